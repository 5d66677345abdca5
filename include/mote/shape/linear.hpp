/// \file
/// Linear hat functions.
#pragma once

#include <mote/shape/concept.hpp>

namespace mote::shape {

/// Hat functions, two nodes per axis. Their gradient jumps at cell faces: a particle that crosses one gives the nodes a
/// sudden force (cell-crossing noise). Source: Sulsky, Chen, Schreyer, CMAME 118 (1994) 179.
struct Linear {
  using role = mote::role::Shape;
  static constexpr int support = 2;
  static constexpr double first = 0;
  static constexpr double inertia = 0;  // f (1 - f): vanishes at nodes

  template <class T>
  static void values(const T& f, T* w) {
    w[0] = T(1) - f;
    w[1] = f;
  }
  template <class T>
  static void slopes(const T&, T* d) {
    d[0] = T(-1);
    d[1] = T(1);
  }
};

}  // namespace mote::shape
