/// \file
/// Cubic B-splines.
#pragma once

#include <mote/shape/concept.hpp>

namespace mote::shape {

/// Cubic B-splines on uniform knots, four nodes per axis, continuous gradient and curvature.
/// Sources: Steffen, Kirby, Berzins, IJNME 76 (2008) 922; for D = h^2/3 Jiang, Schroeder, Teran, Stomakhin, Selle, The
/// material point method for simulating continuum materials, ACM SIGGRAPH courses (2016).
struct CubicBSpline {
  using role = mote::role::Shape;
  static constexpr int support = 4;
  static constexpr double first = 1;
  static constexpr double inertia = 1.0 / 3;

  template <class T>
  static void values(const T& f, T* w) {
    const T a = T(2) - f, b = f - T(1), sixth = T(1.0 / 6);
    w[0] = sixth * a * a * a;
    w[1] = sixth * (T(4) + b * b * (T(3) * b - T(6)));
    w[2] = sixth * (T(4) + a * a * (T(3) * a - T(6)));
    w[3] = sixth * b * b * b;
  }
  template <class T>
  static void slopes(const T& f, T* d) {
    const T a = T(2) - f, b = f - T(1);
    d[0] = T(-0.5) * a * a;
    d[1] = T(0.5) * b * (T(3) * b - T(4));
    d[2] = T(0.5) * a * (T(4) - T(3) * a);
    d[3] = T(0.5) * b * b;
  }
};

}  // namespace mote::shape
