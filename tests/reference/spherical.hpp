/// \file
/// A hollow metal ball in spherical symmetry, solved on Lagrangian shells. Written from the equations: it includes
/// nothing of the library and shares no code with it, so that it can check it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace reference {

/// A von Mises metal with linear isotropic hardening under a Mie-Grueneisen pressure.
struct Metal {
  double rho0, c0, lambda, gamma0;  ///< kg/m^3, m/s, 1, 1
  double shear, yield, hardening;   ///< G, Y, H, Pa
  double bulk() const { return rho0 * c0 * c0; }

  /// P_H at x = V/V0, Pa: the shock Hugoniot in compression, linear in tension.
  double hugoniot(double x) const {
    const double q = 1 - x;
    return q > 0 ? bulk() * q / std::pow(1 - lambda * q, 2) : bulk() * q;
  }
  /// int P_H V0 dq, J/kg, the integral of the series sum k (lambda q)^(k - 1) q where the closed form cancels.
  double elastic_energy(double x) const {
    const double q = 1 - x, z = lambda * q;
    if (q <= 0) return 0.5 * c0 * c0 * q * q;
    if (z < 1e-3) return 0.5 * c0 * c0 * q * q * (1 + z * (4.0 / 3 + z * (1.5 + 1.6 * z)));
    return c0 * c0 / (lambda * lambda) * (1 / (1 - z) + std::log(1 - z) - 1);
  }
  /// Fastest signal, m/s: -V^2 dP_H/dV + 4 G/(3 rho).
  double sound(double x) const {
    const double q = std::max(1 - x, 0.0), slope = (1 + lambda * q) / std::pow(1 - lambda * q, 3);
    return std::sqrt(c0 * c0 * x * x * slope + 4 * shear * x / (3 * rho0));
  }
};

/// The ball, its load and the fineness of the shells.
struct Ball {
  Metal metal;
  double inner, outer;                                   ///< m
  int shells;                                            ///< equally thick at the start
  std::function<double(double)> velocity = nullptr;      ///< outwards at the radius, m/s, at the start
  std::function<double(double)> pull = nullptr;          ///< traction on the outer surface at a time, Pa
  std::function<double(double)> pressure = nullptr;      ///< in the cavity at a time, Pa
  bool held = false;                                     ///< the inner surface is held at rest
  double damping = 0;                                    ///< of all velocities, 1/s
  double linear_viscosity = 0, quadratic_viscosity = 0;  ///< q = -rho0 dr (l c0 + k dr |D|) D, stretched or pressed
  double courant = 0.5;
};

/// Sums over the ball, J.
struct Energies {
  double kinetic = 0, elastic = 0, plastic = 0, thermal = 0, viscous = 0, work = 0, damped = 0;
  /// What has been lost: an error of the steps, of second order in them.
  double missing() const { return work - (kinetic + elastic + plastic + thermal + viscous + damped); }
};

/// Staggered as von Neumann and Richtmyer (1950) and Wilkins (1964) did: nodes r_j with velocities u_j, shells between
/// them with volume V, deviator s = s_rr (s_tt = s_pp = -s/2), plastic strain and work.
///
/// Momentum is rho du/dt = d sigma_r/dr + 2 (sigma_r - sigma_t)/r. A shell of rates d_rr = du/dr and V_t/V = d_rr + 2
/// d_tt takes up sigma_r d_rr + 2 sigma_t d_tt = sigma_t V_t/V + (3/2) s d_rr per volume, with sigma_t = -P - q - s/2.
/// So, by virtual work with V_t = A u (outer less inner) and d_rr = (difference of u)/dr, it pulls at its inner node by
/// sigma_t A + (3/2) s V/dr with the area A there, and at its outer one by the negative: the source 2 (sigma_r -
/// sigma_t)/r is in the difference of the areas V/dr of neighbours. What the nodes lose the shells gain.
///
/// Strains are logarithms of lengths and volumes before and after, exact for radial motion. Its deviator keeps its
/// direction, so that the radial return (1.5 |s| <= Y + H eps_p) is exact up to a corner within the step. Velocity
/// Verlet in time. The closure is the paper's, P = P_H(x) + gamma0 rho0 W_p.
class Shells {
 public:
  explicit Shells(const Ball& ball) : ball_(ball), n_(std::size_t(ball.shells)) {
    if (!(ball.inner > 0 && ball.outer > ball.inner && ball.shells >= 2))
      throw std::invalid_argument("the ball needs 0 < inner < outer and at least two shells");
    r_.resize(n_ + 1), u_.resize(n_ + 1), m_.resize(n_ + 1), f_.resize(n_ + 1), z_.resize(n_);
    for (std::size_t j = 0; j <= n_; ++j) {
      r_[j] = start(j);
      u_[j] = ball_.velocity ? ball_.velocity(r_[j]) : 0;
    }
    if (ball_.held) u_[0] = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      Shell& z = z_[j];
      z.volume = volume(r_[j], r_[j + 1]);
      z.mass = ball_.metal.rho0 * z.volume;
      const double middle = 0.5 * (r_[j] + r_[j + 1]);
      m_[j] += ball_.metal.rho0 * volume(r_[j], middle);
      m_[j + 1] += ball_.metal.rho0 * volume(middle, r_[j + 1]);
    }
    forces();
    start_ = energies().kinetic;
  }

  /// Steps until the time, s.
  void advance(double until) {
    while (time_ < until) {
      const double dt = longest(), left = until - time_;
      if (left <= dt) {
        step(left);
        time_ = until;
      } else {
        step(left < 2 * dt ? 0.5 * left : dt);
      }
    }
  }

  double time() const { return time_; }
  std::size_t size() const { return n_; }
  double radius(std::size_t node = 0) const { return r_[node]; }  ///< m; of the cavity
  double velocity(std::size_t node) const { return u_[node]; }    ///< m/s
  double start(std::size_t node) const { return ball_.inner + (ball_.outer - ball_.inner) * double(node) / double(n_); }
  double ratio(std::size_t shell) const { return x(z_[shell]); }    ///< V/V0
  double deviator(std::size_t shell) const { return z_[shell].s; }  ///< s_rr, Pa
  double plastic_strain(std::size_t shell) const { return z_[shell].eps; }
  double pressure(std::size_t shell) const {  ///< without viscosity, Pa
    return ball_.metal.hugoniot(x(z_[shell])) + ball_.metal.gamma0 * ball_.metal.rho0 * z_[shell].work;
  }
  double radial_stress(std::size_t shell) const { return z_[shell].s - pressure(shell); }

  /// Where the material point that began at the radius is now, m; its velocity, m/s. Linear between nodes.
  double place(double r0) const {
    return r0 + between(r0, [&](std::size_t j) { return r_[j] - start(j); });
  }
  double velocity_of(double r0) const {
    return between(r0, [&](std::size_t j) { return u_[j]; });
  }

  Energies energies() const {
    Energies e;
    const Metal& m = ball_.metal;
    for (std::size_t j = 0; j <= n_; ++j) e.kinetic += 0.5 * m_[j] * u_[j] * u_[j];
    for (const Shell& z : z_) {
      e.elastic += z.mass * m.elastic_energy(x(z)) + z.volume * 0.375 * z.s * z.s / m.shear - z.swollen;
      e.plastic += z.mass * z.work;
      e.thermal += z.thermal;
      e.viscous += z.viscous;
    }
    e.work = work_ + start_;
    e.damped = damped_;
    return e;
  }

 private:
  struct Shell {
    double mass = 0, volume = 0, s = 0, eps = 0;
    double work = 0;     // plastic, J/kg
    double q = 0;        // viscous pressure, Pa
    double viscous = 0;  // its work, J
    double thermal = 0;  // int -gamma0 rho0 W_p dV, J
    // int s:s/(4 G) dV, J, with s:s = 1.5 s_rr^2. V s:de_elastic = V s:ds/(2 G) is not d(V s:s/(4 G)): with a rate of
    // Cauchy's stress the elastic energy hangs on the path, a little
    double swollen = 0;
  };

  Ball ball_;
  std::size_t n_;
  std::vector<double> r_, u_, m_, f_;
  std::vector<Shell> z_;
  double time_ = 0, start_ = 0, work_ = 0, damped_ = 0;

  static double volume(double a, double b) { return 4 * std::numbers::pi / 3 * (b - a) * (a * a + a * b + b * b); }
  static double area(double r) { return 4 * std::numbers::pi * r * r; }
  double x(const Shell& z) const { return z.volume * ball_.metal.rho0 / z.mass; }

  double longest() const {
    double dt = 1e300;
    for (std::size_t j = 0; j < n_; ++j)
      dt = std::min(dt, (r_[j + 1] - r_[j]) / (ball_.metal.sound(x(z_[j])) + std::abs(u_[j + 1] - u_[j])));
    return ball_.courant * dt;
  }

  void step(double dt) {
    kick(0.5 * dt);
    const double inside = force(ball_.pressure, r_.front()), outside = force(ball_.pull, r_.back());
    const std::vector<double> before = r_;
    for (std::size_t j = 0; j <= n_; ++j) r_[j] += dt * u_[j];
    for (std::size_t j = 0; j < n_; ++j) strain(z_[j], before[j], before[j + 1], r_[j], r_[j + 1], dt);
    time_ += dt;
    work_ += 0.5 * (inside + force(ball_.pressure, r_.front())) * dt * u_.front() +
             0.5 * (outside + force(ball_.pull, r_.back())) * dt * u_.back();
    forces();
    kick(0.5 * dt);
  }

  void kick(double dt) {
    const double keep = std::exp(-ball_.damping * dt);
    for (std::size_t j = ball_.held ? 1 : 0; j <= n_; ++j) {
      u_[j] += dt * f_[j] / m_[j];
      damped_ += 0.5 * m_[j] * u_[j] * u_[j] * (1 - keep * keep);
      u_[j] *= keep;
    }
  }

  double force(const std::function<double(double)>& traction, double r) const {
    return traction ? traction(time_) * area(r) : 0;
  }

  void forces() {
    std::fill(f_.begin(), f_.end(), 0.0);
    f_.front() = force(ball_.pressure, r_.front());
    f_.back() = force(ball_.pull, r_.back());
    for (std::size_t j = 0; j < n_; ++j) {
      const Shell& z = z_[j];
      const double hoop = -pressure(j) - z.q - 0.5 * z.s;
      const double rest = 1.5 * z.s * z.volume / (r_[j + 1] - r_[j]);
      f_[j] += hoop * area(r_[j]) + rest;
      f_[j + 1] -= hoop * area(r_[j + 1]) + rest;
    }
  }

  /// Takes the shell between a and b to c and d.
  void strain(Shell& z, double a, double b, double c, double d, double dt) {
    const Metal& m = ball_.metal;
    const double now = volume(c, d), dv = now - z.volume;
    if (!(d > c)) throw std::runtime_error("shells have passed through each other");
    const double swell = std::log(now / z.volume), stretch = std::log((d - c) / (b - a));
    const double trial = z.s + 2 * m.shear * (stretch - swell / 3);
    const double size = 1.5 * std::abs(trial), limit = m.yield + m.hardening * z.eps;
    const double before = z.work, was = z.s;
    z.s = trial;
    if (size > limit) {
      const double rise = (size - limit) / (3 * m.shear + m.hardening);
      z.s = trial * (1 - 3 * m.shear * rise / size);
      z.eps += rise;
      z.work += (limit + 0.5 * m.hardening * rise) * rise * 0.5 * (z.volume + now) / z.mass;
    }
    z.thermal -= m.gamma0 * m.rho0 * 0.5 * (before + z.work) * dv;
    z.swollen += 0.375 / m.shear * 0.5 * (was * was + z.s * z.s) * dv;
    const double rate = swell / dt, width = d - c;
    z.q = -m.rho0 * width * rate * (ball_.linear_viscosity * m.c0 + ball_.quadratic_viscosity * width * std::abs(rate));
    z.viscous -= z.q * dv;
    z.volume = now;
  }

  template <class F>
  double between(double r0, const F& f) const {
    const double t = (r0 - ball_.inner) / (ball_.outer - ball_.inner) * double(n_);
    const auto j = std::size_t(std::clamp(std::floor(t), 0.0, double(n_ - 1)));
    const double w = t - double(j);
    return (1 - w) * f(j) + w * f(j + 1);
  }
};

}  // namespace reference
