/// \file
/// Cartesian grid.
#pragma once

#include <cmath>

#include <mote/core/error.hpp>
#include <mote/core/role.hpp>
#include <mote/core/vec.hpp>

namespace mote::grid {

/// Nodes at origin + h (i, j, k) for all integers: the grid has no size, only blocks near particles exist.
///
/// \tparam D 1 (uniaxial strain), 2 (plane strain) or 3
/// \tparam T number type of particles and nodes, double or float
template <int D, class T = double>
struct Cartesian {
  using role = mote::role::Grid;
  using number = T;
  static constexpr int dimension = D;
  static_assert(D >= 1 && D <= 3, "mote: a grid has 1, 2 or 3 dimensions");

  double spacing;              ///< h, m, > 0
  Vec<double, D> origin = {};  ///< position of node 0, m

  void validate() const {
    require(spacing > 0 && std::isfinite(spacing), "the grid spacing is ", spacing, " m; it must be > 0 and finite");
    for (int a = 0; a < D; ++a)
      require(std::isfinite(origin[a]), "the grid's origin is ", origin[a], " m; it must be finite");
  }
};

}  // namespace mote::grid
