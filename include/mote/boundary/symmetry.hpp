/// \file
/// Symmetry plane.
#pragma once

#include <mote/boundary/concept.hpp>

namespace mote::boundary {

/// A mirror: the normal velocity is odd, the tangential velocity even. No friction.
struct Symmetry {
  using role = mote::role::Boundary;
  static constexpr bool body_beyond = true;

  Side side;
  double at = 0;  ///< m, on a grid node

  static constexpr bool odd(int component, int normal_axis) { return component == normal_axis; }
};

}  // namespace mote::boundary
