/// \file
/// Quadratic B-splines.
#pragma once

#include <mote/shape/concept.hpp>

namespace mote::shape {

/// Quadratic B-splines on uniform knots, three nodes per axis, continuous gradient.
/// Source: Steffen, Kirby, Berzins, IJNME 76 (2008) 922.
struct QuadraticBSpline {
  using role = mote::role::Shape;
  static constexpr int support = 3;
  static constexpr double first = 0.5;
  static constexpr double inertia = 0.25;

  template <class T>
  static void values(const T& f, T* w) {
    const T a = T(1.5) - f, b = f - T(1), c = f - T(0.5);
    w[0] = T(0.5) * a * a;
    w[1] = T(0.75) - b * b;
    w[2] = T(0.5) * c * c;
  }
  template <class T>
  static void slopes(const T& f, T* d) {
    d[0] = f - T(1.5);
    d[1] = T(2) - T(2) * f;
    d[2] = f - T(0.5);
  }
};

}  // namespace mote::shape
