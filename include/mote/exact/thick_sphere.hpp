/// \file
/// A thick sphere (or a cavity in an infinite body) under pressure inside or tension outside, at rest.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <mote/core/error.hpp>
#include <mote/exact/numerics.hpp>

namespace mote::exact {

/// Load, Pa, at which a small cavity in an infinite elastic-ideally-plastic body grows without limit (Hill's steady
/// growth): (2 Y/3) [1 + ln(E/(3 (1 - nu) Y))], to first order in Y/E.
inline double cavitation_limit(double young, double poisson, double yield) {
  return 2 * yield / 3 * (1 + std::log(young / (3 * (1 - poisson) * yield)));
}

/// Inner radius a, outer b (infinity allowed), small strain, von Mises or Tresca (they agree here) without hardening.
/// Pressure p inside and tension T outside; only q = p + T makes shear. With beta = a^3/b^3, elastically
///
///     sigma_r = T - q (a^3/r^3 - beta)/(1 - beta),      sigma_t = T + q (a^3/(2 r^3) + beta)/(1 - beta),
///     u = (q r/E) [(1 - 2 nu) beta + (1 + nu) a^3/(2 r^3)]/(1 - beta) + (1 - 2 nu) T r/E.
///
/// From q = (2 Y/3) (1 - beta) a plastic zone a < r < c grows, 2 Y ln(c/a) + (2 Y/3) (1 - c^3/b^3) = q. Beyond c it is
/// the elastic sphere of inner radius c that has just begun to yield there; in the zone
///
///     sigma_r = T - 2 Y ln(c/r) - (2 Y/3) (1 - c^3/b^3),     sigma_t = sigma_r + Y,
///     u = (Y r/E) [(1 - nu) c^3/r^3 - (2/3) (1 - 2 nu) (1 + 3 ln(c/r) - c^3/b^3)] + (1 - 2 nu) T r/E.
///
/// The sphere collapses at q = 2 Y ln(b/a); a cavity in a large body grows without limit before, at cavitation_limit().
/// Loads beyond either are refused. Near them strains are not small: u(a)/a tells.
/// Source: Hill, The Mathematical Theory of Plasticity (1950), ch. V, secs. 2 to 4.
class ThickSphere {
 public:
  struct Parameters {
    double inner;                                            ///< a, m, > 0
    double outer = std::numeric_limits<double>::infinity();  ///< b, m, > a
    double young;                                            ///< E, Pa, > 0
    double poisson;                                          ///< nu, in (-1, 0.5]
    double yield = std::numeric_limits<double>::infinity();  ///< Y, Pa, > 0, below E/(3 (1 - nu)); infinity: elastic
    double pressure = 0;                                     ///< p inside, Pa
    double tension = 0;                                      ///< T outside, Pa; p + T >= 0
  };

  /// \throws InputError for numbers outside their ranges and for a load beyond limit_load().
  explicit ThickSphere(const Parameters& p) : p_(p), cube_(std::pow(p.inner / p.outer, 3)) {
    require(p.inner > 0 && std::isfinite(p.inner), "the inner radius is ", p.inner, " m; it must be > 0");
    require(p.outer > p.inner, "the outer radius is ", p.outer, " m; it must be larger than the inner, ", p.inner,
            " m");
    require(p.young > 0, "Young's modulus is ", p.young, " Pa; it must be > 0");
    require(p.poisson > -1 && p.poisson <= 0.5, "Poisson's ratio is ", p.poisson, "; it must lie in (-1, 0.5]");
    const double stiff = p.young / (3 * (1 - p.poisson));
    require(p.yield > 0 && (p.yield < stiff || std::isinf(p.yield)), "the yield stress is ", p.yield,
            " Pa; it must be > 0 and below E/(3 (1 - nu)) = ", stiff, " Pa, or infinite");
    require(load() >= 0 && load() <= limit_load(), "pressure inside plus tension outside is ", load(),
            " Pa; it must lie between 0 and ", limit_load(), " Pa, where this sphere gives way");
    plastic_ = plastic_radius_of(load());
  }

  const Parameters& parameters() const { return p_; }
  /// q = p + T, Pa.
  double load() const { return p_.pressure + p_.tension; }
  /// q at which it begins to yield: 2 Y/3 in an infinite body.
  double yield_load() const { return 2 * p_.yield / 3 * (1 - cube_); }
  /// q at which the sphere is plastic throughout, or the cavity grows without limit, whichever comes first.
  double limit_load() const {
    if (std::isinf(p_.yield)) return p_.yield;
    return std::min(2 * p_.yield * std::log(p_.outer / p_.inner), cavitation_limit(p_.young, p_.poisson, p_.yield));
  }
  /// c, m; a where nothing has yielded.
  double plastic_radius() const { return plastic_; }
  bool plastic(double r) const { return r < plastic_; }

  /// sigma_r at r from a to b, Pa, tension positive.
  double radial_stress(double r) const {
    check(r);
    if (plastic(r)) return p_.tension - 2 * p_.yield * std::log(plastic_ / r) - 2 * p_.yield / 3 * (1 - outer_cube());
    return p_.tension - 2 * shear() / 3 * (std::pow(plastic_ / r, 3) - outer_cube());
  }
  /// sigma_t along circles, Pa, tension positive.
  double hoop_stress(double r) const {
    if (plastic(r)) return radial_stress(r) + p_.yield;
    return radial_stress(r) + shear() * std::pow(plastic_ / r, 3);
  }
  /// u outwards, m.
  double displacement(double r) const {
    check(r);
    const double nu = p_.poisson, c3 = std::pow(plastic_ / r, 3), spread = 1 - 2 * nu;
    const double own =
        plastic(r) ? p_.yield * ((1 - nu) * c3 - 2.0 / 3 * spread * (1 + 3 * std::log(plastic_ / r) - outer_cube()))
                   : shear() * (2.0 / 3 * spread * outer_cube() + (1 + nu) / 3 * c3);
    return r / p_.young * (own + spread * p_.tension);
  }

 private:
  Parameters p_;
  double cube_;  // a^3/b^3
  double plastic_ = 0;

  void check(double r) const {
    require(r >= p_.inner && r <= p_.outer, "the radius is ", r, " m; it must lie between ", p_.inner, " and ",
            p_.outer, " m");
  }
  /// c^3/b^3.
  double outer_cube() const { return std::pow(plastic_ / p_.outer, 3); }
  /// sigma_t - sigma_r at c.
  double shear() const { return plastic_ > p_.inner ? p_.yield : 1.5 * load() / (1 - cube_); }

  double plastic_radius_of(double q) const {
    if (!(q > yield_load())) return p_.inner;
    if (cube_ == 0) return p_.inner * std::exp(q / (2 * p_.yield) - 1.0 / 3);
    if (q >= 2 * p_.yield * std::log(p_.outer / p_.inner)) return p_.outer;  // a double root: Newton would be slow
    const auto surplus = [&](double z) {  // z = ln(c/a)
      const double ratio = cube_ * std::exp(3 * z);
      return std::pair(2 * z + 2.0 / 3 * (1 - ratio) - q / p_.yield, 2 - 2 * ratio);
    };
    const double z = detail::newton(surplus, 0, -std::log(cube_) / 3);
    return std::min(p_.inner * std::exp(z), p_.outer);
  }
};

}  // namespace mote::exact
