/// \file
/// A half space: all that lies on one side of a plane (of a line in two dimensions, of a point in one).
#pragma once

#include <cmath>
#include <mote/geometry/concept.hpp>

namespace mote::geometry {

/// The points x with (x - point) . normal <= 0: the normal points out of the region. Its length does not matter.
template <int D>
struct HalfSpace {
  Vec<double, D> point;   ///< any point of the plane, m
  Vec<double, D> normal;  ///< outward, of any length but zero

  static constexpr int dimension = D;

  bool contains(const Vec<double, D>& x) const { return level(x) <= 0; }

  /// The signed distance to the plane.
  double level(const Vec<double, D>& x) const { return dot(x - point, normal) / norm(normal); }

  /// Exact: the levels at two opposite corners of the box.
  Range levels(const Vec<double, D>& centre, const Vec<double, D>& half) const {
    double reach = 0;
    for (int i = 0; i < D; ++i) reach += std::abs(normal[i]) * half[i];
    reach /= norm(normal);
    const double middle = level(centre);
    return {middle - reach, middle + reach};
  }

  /// Finite only on the side of the normal, and only if that lies along an axis.
  Bounds<D> bounds() const {
    auto result = Bounds<D>::everything();
    for (int i = 0; i < D; ++i) {
      if (std::abs(normal[i]) < norm(normal)) continue;
      (normal[i] > 0 ? result.upper : result.lower)[i] = point[i];
    }
    return result;
  }

  /// \throws InputError unless point and normal are finite and the normal is not zero.
  void validate() const {
    for (int i = 0; i < D; ++i)
      require(std::isfinite(point[i]) && std::isfinite(normal[i]), "HalfSpace: point[", i, "] = ", point[i],
              " m and normal[", i, "] = ", normal[i], " must be finite");
    require(norm(normal) > 0, "HalfSpace: normal must not be zero");
  }
};

}  // namespace mote::geometry
