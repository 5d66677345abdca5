/// \file
/// What an incompressible elastic-plastic medium resists when a spherical cavity in it moves to and fro.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace mote::exact {

namespace detail {

/// The dilogarithm Li2(x) = -int_0^x ln(1 - t)/t dt for x < 1, to round-off.
inline double dilogarithm(double x) {
  constexpr double sixth = std::numbers::pi * std::numbers::pi / 6;
  if (x < -1) return -sixth - 0.5 * std::log(-x) * std::log(-x) - dilogarithm(1 / x);
  if (x == 1) return sixth;
  if (x > 0.5) return sixth - std::log(x) * std::log1p(-x) - dilogarithm(1 - x);
  // sum B_n z^(n + 1)/(n + 1)! with the Bernoulli numbers and z = -ln(1 - x), |z| <= ln 2: B_18's term is 1e-18
  const double z = -std::log1p(-x), z2 = z * z;
  constexpr double c[] = {1.0 / 36,
                          -1.0 / 3600,
                          1.0 / 211680,
                          -1.0 / 10886400,
                          5.0 / 66 / 39916800,
                          -691.0 / 2730 / 6227020800,
                          7.0 / 6 / 1307674368000,
                          -3617.0 / 510 / 355687428096000};
  double sum = 0;
  for (int i = 7; i >= 0; --i) sum = sum * z2 + c[i];
  return z * (1 - z / 4 + z2 * sum);
}

}  // namespace detail

/// Spherical shells, named by the cube xi of their first radius (m^3, from A^3 to B^3, B may be infinite), are all
/// moved by one number: r^3 = xi + w. The logarithmic strain of a shell is 2 ln(r/xi^(1/3)) in compression along r, so
/// with G and the yield stress Y, without hardening, s = sigma_t - sigma_r changes by
///
///     ds = 2 G d ln(xi + w), held within +-Y.
///
/// Seen from outside inwards the shells fall into zones: those that never yielded, and those that yielded last up to
/// the turning point w_k with s = +-Y there. In each, s = s_k + 2 G ln((xi + w)/(xi + w_k)), so that the resistance
///
///     S = 2 int s dr/r = (2/3) int s dxi/(xi + w)
///
/// is exact in logarithms and dilogarithms: with eta = xi + w and d = w - w_k, int ln(eta/(eta - d)) d eta/eta =
/// -[Li2(d/eta)]. Innermost is the zone that yields now. A motion that goes beyond an earlier turning point wipes it
/// out.
class CavityStrength {
 public:
  /// G >= 0 and Y > 0 (infinite: elastic) in Pa; A^3 > 0 and B^3 > A^3 (or infinite) in m^3.
  CavityStrength(double shear_modulus, double yield, double inner, double outer)
      : g_(shear_modulus), y_(yield), inner_(inner), zones_{{outer, 0, 0}} {}

  /// xi up to which shells yield if the motion goes on from the last turning point to w; A^3 if none do.
  double yielding(double w) const {
    double edge = inner_;
    for (std::size_t k = 0; k < zones_.size(); ++k) {
      const Zone& z = zones_[k];
      const double missing = y_ - direction(w) * z.stress;  // to the yield stress in this direction
      const double to = missing > 0 ? (w - z.turned) / std::expm1(direction(w) * missing / (2 * g_)) - z.turned
                                    : (direction(w) * (w - z.turned) > 0 ? z.outer : inner_);
      if (to > inside(k)) edge = std::max(edge, std::min(to, z.outer));
    }
    return edge;
  }

  /// s = sigma_t - sigma_r of the shell xi at w, Pa.
  double stress(double xi, double w) const {
    if (xi < yielding(w)) return direction(w) * y_;
    std::size_t k = zones_.size() - 1;
    while (k > 0 && xi >= zones_[k].outer) --k;
    return zones_[k].stress + 2 * g_ * std::log((xi + w) / (xi + zones_[k].turned));
  }

  /// S of the shells beyond `from` (m^3), Pa: the jump of sigma_r that they hold. Positive when they pull inwards.
  double resistance(double w, double from) const {
    const double edge = yielding(w);
    double sum = edge > from ? direction(w) * y_ * 2 / 3 * std::log((edge + w) / (from + w)) : 0;
    for (std::size_t k = 0; k < zones_.size(); ++k) {
      const Zone& z = zones_[k];
      const double low = std::max({inside(k), edge, from}) + w, high = z.outer + w, moved = w - z.turned;
      if (!(high > low)) continue;
      if (z.stress != 0) sum += 2.0 / 3 * z.stress * std::log(high / low);
      sum += 4.0 / 3 * g_ * (detail::dilogarithm(moved / low) - detail::dilogarithm(moved / high));
    }
    return sum;
  }
  double resistance(double w) const { return resistance(w, inner_); }

  /// The motion turns round at w.
  void turn(double w) {
    const double edge = yielding(w), stress = direction(w) * y_;
    if (edge > inner_) {
      while (!zones_.empty() && zones_.back().outer <= edge) zones_.pop_back();
      zones_.push_back({edge, stress, w});
    }
    last_ = w;
  }

  /// How many zones the turning points have left.
  std::size_t zones() const { return zones_.size(); }

 private:
  struct Zone {
    double outer;   // xi, m^3; the next zone's is where it ends inside
    double stress;  // s at the turning point, Pa
    double turned;  // w there, m^3
  };

  double g_, y_, inner_;
  std::vector<Zone> zones_;
  double last_ = 0;

  double direction(double w) const { return w >= last_ ? 1 : -1; }
  double inside(std::size_t k) const { return k + 1 < zones_.size() ? zones_[k + 1].outer : inner_; }
};

}  // namespace mote::exact
