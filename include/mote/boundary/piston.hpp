/// \file
/// Piston: a plane that moves and takes the body along.
#pragma once

#include <cmath>

#include <mote/boundary/concept.hpp>
#include <mote/core/time_function.hpp>

namespace mote::boundary {

/// A plane of prescribed velocity along its normal that the body sticks to (no slip), in compression and tension.
/// boundary::RigidWall is one at rest.
///
/// The grid goes with the piston, along its axis: MPM takes a new grid for each step, and may take it where the piston
/// is. So the plane lies on nodes at every time, the field near it is that of a wall seen from the piston, and the
/// error in its place is none in space; in time it is that of the mid-point rule for the velocity's integral, O(dt^2),
/// and round-off for a constant one. The price: another plane cannot lie across the same axis, and walls beside the
/// piston must let it slide (boundary::Symmetry); both are refused.
///
/// Impulse, and work = impulse times velocity, are in the ledger. Where the piston is: `solver.domain()` and
/// `solver.frame()`.
struct Piston {
  using role = mote::role::Boundary;
  static constexpr bool body_beyond = false;

  Side side;
  double at = 0;          ///< place at time 0, m, on a grid node
  TimeFunction velocity;  ///< along the axis (negative: downwards), m/s: constant, or a function of time

  static constexpr bool odd(int, int) { return true; }

  void validate() const {
    require(std::isfinite(velocity(0)), "a piston's velocity is ", velocity(0), " m/s; it must be finite");
  }
};

}  // namespace mote::boundary
