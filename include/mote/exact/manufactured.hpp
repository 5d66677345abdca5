/// \file
/// What all manufactured solutions offer.
///
/// A motion x(X, t) of a neo-Hookean body is chosen, and the body force that it needs is derived:
/// b = d^2 x/dt^2 - Div P / rho0. A solver that is given b must then move as chosen, so its error is known.
///
/// A solver sees places in space, not material points: `material_point` inverts the motion, and
///
///     const exact::AxisAligned<2> solution{{.material = rubber, .amplitude = {0.05, 0.05}, .speed = 100}};
///     load::BodyForce<2>{solution.body_force_field()};
///
/// feeds a solver. The fields are continued smoothly beyond the body, since a solver also asks for nodes out there.
#pragma once

#include <cmath>
#include <utility>

#include <mote/core/tensor.hpp>
#include <mote/exact/neo_hookean.hpp>
#include <mote/exact/numerics.hpp>

namespace mote::exact {

/// The shared part of a manufactured solution in D dimensions. The derived class offers `material()` and, as functions
/// of the material point X (m) and the time (s): `displacement` (m), `velocity` (m/s), `inertia` = d^2 x/dt^2 (m/s^2),
/// `deformation_gradient` and `body_force` (m/s^2); and `material_point(x, time)`, the X that is at x.
template <class Derived, int D>
class Manufactured {
 public:
  static constexpr int dimension = D;
  using X = Vec<double, D>;

  /// Where the material point is, m.
  X position(const X& point, double time) const { return point + self().displacement(point, time); }

  /// Cauchy stress, Pa, tension positive.
  SymTensor<double> stress(const X& point, double time) const {
    return self().material().stress(self().deformation_gradient(point, time));
  }

  /// The same at the place x in space.
  X velocity_at(const X& x, double time) const { return self().velocity(self().material_point(x, time), time); }
  X body_force_at(const X& x, double time) const { return self().body_force(self().material_point(x, time), time); }

  /// As functions of place and time, with a copy of this solution inside: for load::BodyForce and for a fill.
  auto body_force_field() const {
    return [copy = self()](const X& x, double time) { return copy.body_force_at(x, time); };
  }
  auto velocity_field(double time) const {
    return [copy = self(), time](const X& x) { return copy.velocity_at(x, time); };
  }

 private:
  const Derived& self() const { return static_cast<const Derived&>(*this); }
};

namespace detail {

/// The X with X + a sin(k X) = x, for |a k| < 1.
inline double undo_sine(double x, double a, double k) {
  const auto miss = [&](double point) {
    return std::pair(point + a * std::sin(k * point) - x, 1 + a * k * std::cos(k * point));
  };
  return newton(miss, x - std::abs(a), x + std::abs(a));
}

/// A displacement of amplitude a along a period `length` turns nothing inside out.
inline void require_sine(double a, double length) {
  constexpr double turn = 6.283185307179586;
  require(length > 0, "the length is ", length, " m; it must be > 0");
  require(std::abs(a) * turn < length, "the amplitude is ", a, " m; it must lie within +-", length / turn,
          " m, so that the body is not turned inside out");
}

}  // namespace detail

}  // namespace mote::exact
