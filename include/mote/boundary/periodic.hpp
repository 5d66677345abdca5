/// \file
/// Periodic boundaries.
#pragma once

#include <mote/boundary/concept.hpp>

namespace mote::boundary {

/// Nodes and particles repeat along `axis` with the period to - from, a whole number of cells.
struct Periodic {
  using role = mote::role::Boundary;
  int axis;
  double from, to;  ///< m

  void validate() const {
    require(to > from, "a periodic boundary goes from ", from, " to ", to, " m; `to` must lie above `from`");
  }
};

}  // namespace mote::boundary
