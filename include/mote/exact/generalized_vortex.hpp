/// \file
/// Manufactured solution: the generalized vortex, a ring whose middle is turned to and fro.
#pragma once

#include <numbers>

#include <mote/exact/manufactured.hpp>

namespace mote::exact {

/// How the angle g(t) of the vortex begins.
enum class VortexStart {
  moving,   ///< g = A sin(pi t/T): undeformed, at full speed
  at_rest,  ///< g = (A/2) (1 - cos(2 pi t/T)): undeformed and at rest
};

/// A neo-Hookean ring, R_i <= R <= R_o, in plane strain (D = 2, or D = 3 with free z). Each circle turns rigidly by
///
///     alpha(R, t) = g(t) h(R),  h = (1 - 4 s^2)^2 = 1 - 8 s^2 + 16 s^4,  s = (R - (R_i + R_o)/2)/(R_o - R_i).
///
/// Both edges neither move nor carry a traction. With e_r', e_t' the radial and tangential directions at the current
/// place (turned by theta + alpha) and gamma = R d_R alpha,
///
///     F = e_r' E_R + gamma e_t' E_R + e_t' E_T,     J = 1,     P = mu gamma (e_t' E_R + e_r' E_T).
///
/// Div P = d_R (P E_R) + (P E_R + d_T (P E_T))/R with d_R e_t' = -d_R alpha e_r' and d_T e_r' = e_t' is
/// mu [-R (d_R alpha)^2 e_r' + (3 d_R alpha + R d_R^2 alpha) e_t'], and the acceleration -R alpha_t^2 e_r' +
/// R alpha_tt e_t', so that
///
///     b_r' = -R alpha_t^2 + (mu/rho0) R (d_R alpha)^2,   b_t' = R alpha_tt - (mu/rho0) (3 d_R alpha + R d_R^2 alpha).
///
/// lambda does nothing. Circles stay circles, so the inverse motion is a turn back by alpha(|x|), exact. Beyond the
/// edges h goes on as the same polynomial, so that b is smooth there; on the axis b = 0 is returned. Source: Brannon,
/// Kamojjala, Sadeghirad, Particles (2011); Kamojjala, Brannon, Sadeghirad, Guilkey, Eng. Comput. 31 (2015) 193. The
/// force is derived above: b_t' has another sign in some public codes.
template <int D = 2>
class GeneralizedVortex : public Manufactured<GeneralizedVortex<D>, D> {
  static_assert(D == 2 || D == 3, "mote: the generalized vortex has two or three dimensions");

 public:
  using X = Vec<double, D>;

  struct Parameters {
    NeoHookean material;
    double amplitude = 1;  ///< A, rad
    double period = 1;     ///< T, s, > 0: the ring is undeformed again after T
    double inner = 0.75;   ///< R_i, m, > 0
    double outer = 1.25;   ///< R_o, m, > R_i
    VortexStart start = VortexStart::at_rest;
  };

  /// \throws InputError for numbers outside their ranges.
  explicit GeneralizedVortex(const Parameters& p) : p_(p) {
    p.material.validate();
    require(std::isfinite(p.amplitude), "the amplitude is ", p.amplitude, " rad; it must be finite");
    require(p.period > 0, "the period is ", p.period, " s; it must be > 0");
    require(p.inner > 0 && p.outer > p.inner, "the ring's radii are ", p.inner, " and ", p.outer,
            " m; the inner must be > 0 and the outer larger");
  }

  const Parameters& parameters() const { return p_; }
  const NeoHookean& material() const { return p_.material; }

  /// alpha, rad.
  double angle(double radius, double time) const { return turn(time).value * profile(radius).value; }

  X displacement(const X& point, double time) const {
    const double a = angle(radius(point), time), half = std::sin(a / 2);
    return in_plane(-2 * half * half * point[0] - std::sin(a) * point[1],
                    std::sin(a) * point[0] - 2 * half * half * point[1]);
  }
  X velocity(const X& point, double time) const {
    const X x = this->position(point, time);
    const double rate = turn(time).first * profile(radius(point)).value;
    return in_plane(-rate * x[1], rate * x[0]);
  }
  X inertia(const X& point, double time) const {
    const X x = this->position(point, time);
    const Derivatives g = turn(time), h = profile(radius(point));
    const double rate2 = g.first * g.first * h.value * h.value, change = g.second * h.value;
    return in_plane(-rate2 * x[0] - change * x[1], -rate2 * x[1] + change * x[0]);
  }
  Mat<double, 3> deformation_gradient(const X& point, double time) const {
    const X x = this->position(point, time);
    const double r = radius(point), a = angle(r, time), c = std::cos(a), s = std::sin(a);
    const double slope = r > 0 ? turn(time).value * profile(r).first / r : 0;  // gamma e_t' E_R = slope (ez x x) X
    auto f = Mat<double, 3>::identity();
    f(0, 0) = c - slope * x[1] * point[0];
    f(0, 1) = -s - slope * x[1] * point[1];
    f(1, 0) = s + slope * x[0] * point[0];
    f(1, 1) = c + slope * x[0] * point[1];
    return f;
  }
  X body_force(const X& point, double time) const { return body_force_at(this->position(point, time), time); }

  X material_point(const X& x, double time) const {
    const double a = angle(radius(x), time), c = std::cos(a), s = std::sin(a);
    X point = x;
    point[0] = c * x[0] + s * x[1];
    point[1] = c * x[1] - s * x[0];
    return point;
  }

  /// Needs no material point: a circle's radius does not change.
  X body_force_at(const X& x, double time) const {
    const double r = radius(x), stiffness = p_.material.mu / p_.material.rho0;
    if (r == 0) return X{};
    const Derivatives g = turn(time), h = profile(r);
    const double rate = g.first * h.value, slope = g.value * h.first;
    const double radial = -rate * rate + stiffness * slope * slope;                                     // b_r'/R
    const double tangential = g.second * h.value - stiffness * g.value * (3 * h.first / r + h.second);  // b_t'/R
    return in_plane(radial * x[0] - tangential * x[1], radial * x[1] + tangential * x[0]);
  }

 private:
  struct Derivatives {
    double value, first, second;
  };

  Parameters p_;

  static double radius(const X& x) { return std::hypot(x[0], x[1]); }
  static X in_plane(double a, double b) {
    X r{};
    r[0] = a;
    r[1] = b;
    return r;
  }
  /// g(t).
  Derivatives turn(double time) const {
    const double a = p_.amplitude, w = std::numbers::pi / p_.period, s = std::sin(w * time), c = std::cos(w * time);
    if (p_.start == VortexStart::moving) return {a * s, a * w * c, -a * w * w * s};
    return {a * s * s, 2 * a * w * s * c, 2 * a * w * w * (c * c - s * s)};  // sin^2 = (1 - cos 2)/2
  }
  /// h(R).
  Derivatives profile(double r) const {
    const double width = p_.outer - p_.inner, s = (r - 0.5 * (p_.inner + p_.outer)) / width, q = 1 - 4 * s * s;
    return {q * q, -16 * s * q / width, (192 * s * s - 16) / (width * width)};
  }
};

}  // namespace mote::exact
