/// \file
/// Manufactured solution: a bar of large deformation in one dimension.
#pragma once

#include <numbers>

#include <mote/exact/manufactured.hpp>

namespace mote::exact {

/// A bar from X = 0 to L with fixed ends, C^2 = E/rho0, k = 2 pi/L, omega = C pi/L:
///
///     u = A sin(k X) cos(omega t),     P = (E/2) (F - 1/F),
///     b = u_tt - P_X/rho0 = omega^2 u (1 + 2/F^2),
///
/// since P_X = (E/2) (1 + 1/F^2) F_X, F_X = -k^2 u and k^2 C^2 = 4 omega^2. For L = 1: b = C^2 pi^2 u (1 + 2/F^2).
/// P is that of a neo-Hookean body with lambda = 0 and mu = E/2 in uniaxial strain.
/// Source: Steffen, Kirby, Berzins, IJNME 76 (2008) 922, and Steffen, Wallstedt, Guilkey, Kirby, Berzins, CMES 31
/// (2008) 107, eqs. 47 to 50, where L = 1, E = 1e4, rho0 = 1 and A = 0.05.
class ManufacturedBar : public Manufactured<ManufacturedBar, 1> {
 public:
  struct Parameters {
    double modulus;     ///< E, Pa, > 0
    double density;     ///< rho0, kg/m^3, > 0
    double amplitude;   ///< A, m, within +- L/(2 pi)
    double length = 1;  ///< L, m, > 0
  };

  /// \throws InputError for numbers outside their ranges.
  explicit ManufacturedBar(const Parameters& p) : p_(p), omega_(0), k_(2 * std::numbers::pi / p.length) {
    require(p.modulus > 0, "the modulus is ", p.modulus, " Pa; it must be > 0");
    require(p.density > 0, "the density is ", p.density, " kg/m^3; it must be > 0");
    detail::require_sine(p.amplitude, p.length);
    omega_ = std::numbers::pi * speed() / p.length;
  }

  const Parameters& parameters() const { return p_; }
  NeoHookean material() const { return {.rho0 = p_.density, .lambda = 0, .mu = p_.modulus / 2}; }
  /// C, m/s.
  double speed() const { return std::sqrt(p_.modulus / p_.density); }
  /// 2 L/C, s, after which the motion repeats.
  double period() const { return 2 * p_.length / speed(); }

  X displacement(const X& point, double time) const { return {amplitude(time) * std::sin(k_ * point[0])}; }
  X velocity(const X& point, double time) const {
    return {-omega_ * p_.amplitude * std::sin(omega_ * time) * std::sin(k_ * point[0])};
  }
  X inertia(const X& point, double time) const { return -omega_ * omega_ * displacement(point, time); }
  Mat<double, 3> deformation_gradient(const X& point, double time) const {
    auto f = Mat<double, 3>::identity();
    f(0, 0) = stretch(point, time);
    return f;
  }
  X body_force(const X& point, double time) const {
    const double f = stretch(point, time);
    return omega_ * omega_ * (1 + 2 / (f * f)) * displacement(point, time);
  }
  X material_point(const X& x, double time) const { return {detail::undo_sine(x[0], amplitude(time), k_)}; }

 private:
  Parameters p_;
  double omega_, k_;

  double amplitude(double time) const { return p_.amplitude * std::cos(omega_ * time); }
  double stretch(const X& point, double time) const { return 1 + k_ * amplitude(time) * std::cos(k_ * point[0]); }
};

}  // namespace mote::exact
