/// \file
/// A spherical cavity that grows, stops and rebounds in an incompressible elastic-plastic medium.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <mote/core/error.hpp>
#include <mote/exact/cavity_strength.hpp>
#include <mote/exact/numerics.hpp>

namespace mote::exact {

/// The cavity's radius is a(t), at first A, in a shell whose outer radius b (at first B, infinite allowed) moves with
/// b^3 - a^3 = B^3 - A^3. The medium is incompressible, v = a^2 a_t/r^2, and its momentum
/// rho dv/dt = d sigma_r/dr - 2 (sigma_t - sigma_r)/r, from a to b, gives
///
///     rho [(a^2 a_tt + 2 a a_t^2) (1/a - 1/b) - (a^4 a_t^2/2) (1/a^4 - 1/b^4)] = T(t) - S,
///
/// for b = infinity rho (a a_tt + (3/2) a_t^2) = T - S. T is the tension outside plus the pressure in the cavity. S is
/// the medium's resistance 2 int (sigma_t - sigma_r) dr/r, elastic in logarithmic strain with G and ideally plastic
/// with Y, history included (CavityStrength): S = (4 G/3) (1 - A^3/a^3) at first, 2 Y/3 when it begins to yield, and at
/// most (2 Y/3) [1 + ln(2 G/Y)] for small Y/G.
///
/// Adaptive steps of fifth order; the estimated error per step is at most `tolerance` of the largest a - A, a_t and
/// energy yet.
/// Turning points are met exactly. Shells lie at the place r; the stress is tension positive.
/// Source: Hopkins, Dynamic expansion of spherical cavities in metals, Progress in Solid Mechanics 1 (1960) 83; Carroll
/// and Holt, J. Appl. Phys. 43 (1972) 1626; for G = Y = 0 it is Rayleigh, Phil. Mag. 34 (1917) 94.
class DynamicCavity {
 public:
  struct Parameters {
    double radius;                                           ///< A, m, > 0
    double outer = std::numeric_limits<double>::infinity();  ///< B, m, > A
    double density;                                          ///< rho, kg/m^3, > 0
    double shear_modulus;                                    ///< G, Pa, >= 0
    double yield = std::numeric_limits<double>::infinity();  ///< Y, Pa, > 0; infinity: elastic
    double speed = 0;                                        ///< a_t at the start, m/s
    std::function<double(double)> tension = {};              ///< T(t), Pa; steps must not leap over a pulse of it
    double tolerance = 1e-10;                                ///< > 0, at most 1e-3
  };

  /// \throws InputError for numbers outside their ranges.
  explicit DynamicCavity(const Parameters& p)
      : p_(p), strength_(p.shear_modulus, p.yield, std::pow(p.radius, 3), std::pow(p.outer, 3)) {
    require(p.radius > 0 && std::isfinite(p.radius), "the cavity's radius is ", p.radius, " m; it must be > 0");
    require(p.outer > p.radius, "the outer radius is ", p.outer, " m; it must be larger than the cavity's, ", p.radius,
            " m");
    require(p.density > 0, "the density is ", p.density, " kg/m^3; it must be > 0");
    require(p.shear_modulus >= 0, "the shear modulus is ", p.shear_modulus, " Pa; it must be >= 0");
    require(p.yield > 0, "the yield stress is ", p.yield, " Pa; it must be > 0");
    require(std::isfinite(p.speed), "the cavity's speed is ", p.speed, " m/s; it must be finite");
    require(p.tolerance > 0 && p.tolerance <= 1e-3, "the tolerance is ", p.tolerance,
            "; it must be > 0 and at most 1e-3");
    y_[speed_] = p.speed;
    remember();
    const double fast = std::sqrt((p.shear_modulus + std::abs(tension())) / p.density) + std::abs(p.speed);
    step_ = 0.05 * p.radius / fast;  // infinite if nothing moves yet
  }

  /// Moves on to `until`, s.
  /// \throws InputError for a time that has passed. \throws NumericalError when the cavity closes before.
  void advance(double until) {
    require(until >= time_ && std::isfinite(until), "the time is ", until, " s; it must be finite and at least ", time_,
            " s, where the cavity is");
    while (time_ < until) {
      const bool last = until - time_ <= step_;
      const double h = last ? until - time_ : step_;
      if (time_ + h == time_ && !last)
        throw NumericalError(text("mote: the cavity closes at ", time_, " s; its radius is ", radius(), " m"));
      const auto s = step(h);
      const double error = relative_error(s);
      if (!(error <= 1)) {
        step_ = h * detail::step_factor(error);
        continue;
      }
      if (y_[speed_] * s.y[speed_] < 0) {
        turn(h);
      } else {
        y_ = s.y;
        time_ = last ? until : time_ + h;
        if (!last) step_ = h * detail::step_factor(error);
      }
      remember();
    }
  }

  const Parameters& parameters() const { return p_; }
  double time() const { return time_; }
  /// a and b, m.
  double radius() const { return p_.radius + y_[out_]; }
  double outer_radius() const { return std::cbrt(std::pow(p_.outer, 3) + swept(y_)); }
  /// a_t, m/s, and a_tt, m/s^2.
  double speed() const { return y_[speed_]; }
  double acceleration() const { return rate(time_, y_)[speed_]; }
  /// S, Pa.
  double resistance() const { return strength_.resistance(swept(y_)); }
  /// T, Pa.
  double tension() const { return tension_at(time_); }
  /// Radius within which the medium yields now, m; that of the cavity where it does not.
  double plastic_radius() const { return std::cbrt(strength_.yielding(swept(y_)) + swept(y_)); }

  /// v, m/s, sigma_t - sigma_r and sigma_r, Pa, at the place r, m; outside T is taken as the tension.
  double velocity(double r) const { return radius() * radius() * speed() / (r * r); }
  double stress_difference(double r) const { return strength_.stress(shell(r), swept(y_)); }
  double radial_stress(double r) const {
    const double a = radius(), b = outer_radius(), v = speed(), flow = a * a * v;
    const double push = (a * a * acceleration() + 2 * a * v * v) * (1 / r - 1 / b) -
                        0.5 * flow * flow * (1 / std::pow(r, 4) - 1 / std::pow(b, 4));
    return tension() - strength_.resistance(swept(y_), shell(r)) - p_.density * push;
  }

  /// J. At any time kinetic + elastic energy = their sum at the start + tension's work - plastic work.
  double kinetic_energy() const { return kinetic_energy(y_); }
  double tension_work() const { return y_[pulled_]; }
  double plastic_work() const { return y_[lost_]; }

 private:
  static constexpr std::size_t out_ = 0, speed_ = 1, pulled_ = 2, lost_ = 3;  // a - A, a_t, works
  using State = detail::Numbers<4>;

  Parameters p_;
  CavityStrength strength_;
  State y_{}, largest_{};
  double energy_ = 0, time_ = 0, step_ = 0;

  void remember() {
    for (std::size_t i = 0; i < y_.size(); ++i) largest_[i] = std::max(largest_[i], std::abs(y_[i]));
    energy_ = std::max(energy_, energy(y_));
  }
  double tension_at(double t) const { return p_.tension ? p_.tension(t) : 0; }
  double shell(double r) const { return std::max(r * r * r - swept(y_), std::pow(p_.radius, 3)); }

  /// w = a^3 - A^3, without cancellation.
  double swept(const State& y) const {
    const double a = p_.radius, u = y[out_];
    return u * (3 * a * a + 3 * a * u + u * u);
  }
  /// 1 - a/b, without cancellation in thin shells.
  double thickness(const State& y) const {
    if (std::isinf(p_.outer)) return 1;
    const double a = p_.radius + y[out_], b = std::cbrt(std::pow(p_.outer, 3) + swept(y));
    return (std::pow(p_.outer, 3) - std::pow(p_.radius, 3)) / (b * (b * b + a * b + a * a));
  }

  State rate(double t, const State& y) const {
    const double a = p_.radius + y[out_], v = y[speed_], w = swept(y);
    if (!(a > 0)) return {NAN, NAN, NAN, NAN};  // too long a step: it is refused
    const double thick = thickness(y), ratio = 1 - thick, pull = tension_at(t), flow = 4 * std::numbers::pi * a * a * v;
    const double kept = 0.5 * (1 + ratio) * (1 + ratio * ratio) - 2;
    const double accel = (pull - strength_.resistance(w)) / (p_.density * a * thick) + v * v / a * kept;
    const double edge = strength_.yielding(w), core = a * a * a;
    const double lost =
        edge > std::pow(p_.radius, 3) ? 2.0 / 3 * p_.yield * std::log((edge + w) / core) * std::abs(flow) : 0;
    return {v, accel, pull * flow, lost};
  }
  detail::DoubledStep<4> step(double h) const {
    return detail::doubled_step([this](double t, const State& y) { return rate(t, y); }, time_, y_, h);
  }

  double relative_error(const detail::DoubledStep<4>& s) const {
    double error = 0;
    for (std::size_t i = 0; i < s.y.size(); ++i) {
      if (!std::isfinite(s.y[i])) return HUGE_VAL;
      const double own =
          i == out_ || i == speed_ ? std::max(largest_[i], std::abs(s.y[i])) : std::max(energy_, energy(s.y));
      if (s.error[i] != 0) error = std::max(error, std::abs(s.error[i]) / (p_.tolerance * own));
    }
    return error;
  }
  double kinetic_energy(const State& y) const {
    return 2 * std::numbers::pi * p_.density * std::pow(p_.radius + y[out_], 3) * y[speed_] * y[speed_] * thickness(y);
  }
  /// All that ever moved: the scale of the works' errors.
  double energy(const State& y) const { return kinetic_energy(y) + std::abs(y[pulled_]) + y[lost_]; }

  /// A step of at most h, to the moment at which the speed vanishes.
  void turn(double h) {
    const double from = y_[speed_];
    double low = 0, high = h;
    State end = y_;
    for (double middle = 0.5 * h; middle != low && middle != high; middle = 0.5 * (low + high)) {
      end = step(middle).y;
      (end[speed_] * from > 0 ? low : high) = middle;
    }
    end = step(high).y;
    end[speed_] = 0;
    y_ = end;
    time_ += high;
    strength_.turn(swept(y_));
  }
};

}  // namespace mote::exact
