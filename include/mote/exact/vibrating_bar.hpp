/// \file
/// Linear axial vibration of a bar.
#pragma once

#include <cmath>
#include <numbers>

#include <mote/core/error.hpp>

namespace mote::exact {

/// How the ends of a vibrating bar are held: at x = 0 and at x = L.
enum class BarEnds { fixed_free, fixed_fixed };

/// One mode of an elastic bar of small strain that starts undeformed, c = sqrt(E/rho):
///
///     v(X, t) = v0 sin(beta X) cos(omega t),   u = (v0/omega) sin(beta X) sin(omega t),   omega = beta c,
///     sigma = E du/dX,
///
/// beta = (2 n - 1) pi/(2 L) with a free end at L, n pi/L with both ends fixed. E is the modulus of the uniaxial
/// motion: in the uniaxial strain of a solver in one dimension lambda + 2 mu. A nonlinear material departs from this by
/// about the strain v0/c of itself. Source: Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974),
/// sec. 5.2; as a test of MPM: Bardenhagen, J. Comput. Phys. 180 (2002) 383 (L = 25, E = 100, rho = 1, v0 = 0.1).
class VibratingBar {
 public:
  struct Parameters {
    double length;   ///< L, m, > 0
    double modulus;  ///< E, Pa, > 0
    double density;  ///< rho, kg/m^3, > 0
    double speed;    ///< v0, m/s, the largest velocity at the start
    int mode = 1;    ///< n, >= 1
    BarEnds ends = BarEnds::fixed_free;
  };

  /// \throws InputError for numbers outside their ranges.
  explicit VibratingBar(const Parameters& p) : p_(p) {
    require(p.length > 0, "the bar's length is ", p.length, " m; it must be > 0");
    require(p.modulus > 0, "the bar's modulus is ", p.modulus, " Pa; it must be > 0");
    require(p.density > 0, "the bar's density is ", p.density, " kg/m^3; it must be > 0");
    require(std::isfinite(p.speed), "the bar's speed is ", p.speed, " m/s; it must be finite");
    require(p.mode >= 1, "the mode is ", p.mode, "; it must be >= 1");
  }

  const Parameters& parameters() const { return p_; }
  /// c, m/s.
  double wave_speed() const { return std::sqrt(p_.modulus / p_.density); }
  /// beta, 1/m.
  double wave_number() const {
    const double halves = p_.ends == BarEnds::fixed_free ? p_.mode - 0.5 : p_.mode;
    return halves * std::numbers::pi / p_.length;
  }
  /// omega, 1/s.
  double frequency() const { return wave_number() * wave_speed(); }
  double period() const { return 2 * std::numbers::pi / frequency(); }

  /// m.
  double displacement(double point, double time) const {
    return p_.speed / frequency() * std::sin(wave_number() * point) * std::sin(frequency() * time);
  }
  /// m/s.
  double velocity(double point, double time) const {
    return p_.speed * std::sin(wave_number() * point) * std::cos(frequency() * time);
  }
  /// Pa, tension positive.
  double stress(double point, double time) const {
    return p_.modulus * wave_number() * p_.speed / frequency() * std::cos(wave_number() * point) *
           std::sin(frequency() * time);
  }
  /// Of the centre of mass, m/s: the mean of the velocity over the bar.
  double mean_velocity(double time) const {
    const double end = wave_number() * p_.length;
    return p_.speed * (1 - std::cos(end)) / end * std::cos(frequency() * time);
  }
  /// J per m^2 of cross-section. The sum with strain_energy() never changes.
  double kinetic_energy(double time) const { return energy() * std::pow(std::cos(frequency() * time), 2); }
  double strain_energy(double time) const { return energy() * std::pow(std::sin(frequency() * time), 2); }

 private:
  Parameters p_;

  double energy() const { return 0.25 * p_.density * p_.speed * p_.speed * p_.length; }  // mean of sin^2 is 1/2
};

}  // namespace mote::exact
