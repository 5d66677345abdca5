/// \file
/// Which order a combination of shape function, transfer and update reaches: what it is measured on, and by what.
///
/// Each file orders_SHAPE.cpp measures the combinations of one shape function; orders.cpp states what is expected of
/// each, compares, and prints the tables of docs/verification.md.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace orders {

/// The problems. In one dimension all are neo-Hookean bars, 2 particles per cell, exact in position.
enum class Problem {
  bar_large,     ///< Steffen et al., both ends fixed, A = 0.05: particles cross up to n/20 cells
  bar_small,     ///< the same, A = 1e-4: none crosses
  wall,          ///< a pulse of small amplitude comes back from a rigid wall
  free_end,      ///< a pulse comes back from a free end that lies on a node
  free_amid,     ///< a free end that lies amid a cell
  vibration,     ///< first mode of a bar with a fixed and a free end, one period
  axis_aligned,  ///< box in the plane whose sides slide along themselves, A = 0.05
  vortex,        ///< ring in the plane, cut by volume fraction, its middle turned by 1 rad and back, shear up to 6.9
  vortex_mild,   ///< the same by 0.2 rad, shear up to 1.4
  vortex_small,  ///< the same by 0.001 rad
  vortex_dense   ///< by 0.2 rad, 4 particles per cell and axis
};
inline constexpr int problems_of_the_line = 6;

/// A combination, and its error: the largest over time of the RMS over particles of the error in position, over the
/// amplitude; infinite if the run failed.
struct Method {
  std::string shape, transfer, update;
  std::function<double(Problem, int cells)> error;
  std::string name() const { return shape + ", " + transfer + ", " + update; }
};
using Methods = std::vector<Method>;

Methods linear();
Methods gimp();
Methods contiguous_gimp();
Methods quadratic();
Methods cubic();
/// Some combinations, for the problems in the plane.
Methods plane();
Methods more_in_plane();
Methods cubic_in_plane();

/// Errors on meshes of n, 2n, 4n, ... cells.
inline std::vector<double> errors(const Method& method, Problem problem, int coarsest, int meshes) {
  std::vector<double> all;
  for (int k = 0; k < meshes; ++k) all.push_back(method.error(problem, coarsest << k));
  return all;
}

/// Slope of the line of least squares through log2 of the errors, over the three finest meshes.
inline double order(const std::vector<double>& e) {
  const std::size_t n = e.size();
  return 0.5 * std::log2(e[n - 3] / e[n - 1]);
}

}  // namespace orders
