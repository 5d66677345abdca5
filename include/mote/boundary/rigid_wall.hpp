/// \file
/// Rigid wall that the body sticks to.
#pragma once

#include <mote/boundary/concept.hpp>

namespace mote::boundary {

/// Velocity zero on the plane (no slip, no contact: the wall is the same metal, at rest), in compression and tension.
///
/// With B-splines of two degrees or more the field near the wall is a parabola that vanishes on it
/// (passes/orbits.hpp), with other kernels odd in the mirror. Zeroing nodes instead would put the wall of a wide kernel
/// half a cell off.
struct RigidWall {
  using role = mote::role::Boundary;
  static constexpr bool body_beyond = false;

  Side side;
  double at = 0;  ///< m, on a grid node

  static constexpr bool odd(int, int) { return true; }
};

}  // namespace mote::boundary
