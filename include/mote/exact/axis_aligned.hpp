/// \file
/// Manufactured solution: displacement along the axes, each with its own sine.
#pragma once

#include <numbers>

#include <mote/exact/manufactured.hpp>

namespace mote::exact {

/// A neo-Hookean box from 0 to L_i along each of D axes (with D < 3 unstrained along the others), whose faces neither
/// move nor shear, k_i = 2 pi/L_i and omega_i = c pi/L_i:
///
///     u_i = A_i sin(k_i X_i) sin(omega_i t + phi_i)     (no sum)
///     F = diag(F_i),  F_i = 1 + du_i/dX_i,  P_ii = mu (F_i - 1/F_i) + lambda ln J / F_i
///     b_i = -omega_i^2 u_i + (k_i^2 u_i/rho0) [mu (1 + 1/F_i^2) + lambda (1 - ln J)/F_i^2],
///
/// since only F_i depends on X_i, dF_i/dX_i = -k_i^2 u_i and d(ln J)/dF_i = 1/F_i. The inverse motion is one root per
/// axis. Source: Steffen, Wallstedt, Guilkey, Kirby, Berzins, CMES 31 (2008) 107, sec. 4.2, where D = 2, L_i = 1,
/// phi = (0, pi), c = sqrt(E/rho0), E = 1e4, nu = 0.3, rho0 = 1 and A = 0.05.
template <int D>
class AxisAligned : public Manufactured<AxisAligned<D>, D> {
 public:
  using X = Vec<double, D>;

  struct Parameters {
    NeoHookean material;
    X amplitude;              ///< A, m, each within +- L_i/(2 pi)
    double speed;             ///< c, m/s, >= 0; material.bar_speed() in the paper
    X phase = X::filled(0);   ///< phi
    X length = X::filled(1);  ///< L, m, > 0
  };

  /// \throws InputError for numbers outside their ranges.
  explicit AxisAligned(const Parameters& p) : p_(p) {
    p.material.validate();
    require(p.speed >= 0, "the speed of the manufactured solution is ", p.speed, " m/s; it must be >= 0");
    for (int i = 0; i < D; ++i) detail::require_sine(p.amplitude[i], p.length[i]);
  }

  const Parameters& parameters() const { return p_; }
  const NeoHookean& material() const { return p_.material; }

  X displacement(const X& point, double time) const {
    return each([&](int i) { return amplitude(i, time) * std::sin(k(i) * point[i]); });
  }
  X velocity(const X& point, double time) const {
    return each([&](int i) {
      return p_.amplitude[i] * omega(i) * std::cos(omega(i) * time + p_.phase[i]) * std::sin(k(i) * point[i]);
    });
  }
  X inertia(const X& point, double time) const {
    const X u = displacement(point, time);
    return each([&](int i) { return -omega(i) * omega(i) * u[i]; });
  }
  Mat<double, 3> deformation_gradient(const X& point, double time) const {
    auto f = Mat<double, 3>::identity();
    for (int i = 0; i < D; ++i) f(i, i) = 1 + k(i) * amplitude(i, time) * std::cos(k(i) * point[i]);
    return f;
  }
  X body_force(const X& point, double time) const {
    const NeoHookean& m = p_.material;
    const Mat<double, 3> f = deformation_gradient(point, time);
    const double log_j = std::log(f(0, 0) * f(1, 1) * f(2, 2));
    const X u = displacement(point, time);
    return each([&](int i) {
      const double f2 = f(i, i) * f(i, i), stiffness = m.mu * (1 + 1 / f2) + m.lambda * (1 - log_j) / f2;
      return u[i] * (k(i) * k(i) * stiffness / m.rho0 - omega(i) * omega(i));
    });
  }
  X material_point(const X& x, double time) const {
    return each([&](int i) { return detail::undo_sine(x[i], amplitude(i, time), k(i)); });
  }

 private:
  Parameters p_;

  template <class F>
  static X each(const F& f) {
    X r{};
    for (int i = 0; i < D; ++i) r[i] = f(i);
    return r;
  }
  double k(int i) const { return 2 * std::numbers::pi / p_.length[i]; }
  double omega(int i) const { return std::numbers::pi * p_.speed / p_.length[i]; }
  double amplitude(int i, double time) const { return p_.amplitude[i] * std::sin(omega(i) * time + p_.phase[i]); }
};

}  // namespace mote::exact
