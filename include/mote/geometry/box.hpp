/// \file
/// A box with sides along the axes.
#pragma once

#include <mote/geometry/concept.hpp>

namespace mote::geometry {

/// The points with lower <= x <= upper along every axis, m. A side may be infinite.
template <int D>
struct Box {
  Vec<double, D> lower, upper;

  static constexpr int dimension = D;

  bool contains(const Vec<double, D>& x) const { return level(x) <= 0; }

  /// The largest of the signed distances to the planes of the faces: outside, near edges, less than the distance.
  double level(const Vec<double, D>& x) const {
    double result = std::max(lower[0] - x[0], x[0] - upper[0]);
    for (int i = 1; i < D; ++i) result = std::max({result, lower[i] - x[i], x[i] - upper[i]});
    return result;
  }

  Range levels(const Vec<double, D>& centre, const Vec<double, D>& half) const {
    return {level_of_faces(centre, half, -1), level_of_faces(centre, half, 1)};
  }

  Bounds<D> bounds() const { return {lower, upper}; }

  /// \throws InputError unless upper > lower along every axis.
  void validate() const {
    for (int i = 0; i < D; ++i)
      require(upper[i] > lower[i], "Box: upper must be above lower along each axis, but along axis ", i,
              " lower = ", lower[i], " m and upper = ", upper[i], " m");
  }

 private:
  /// The largest limit (sign = 1 upper, -1 lower) of the distances to the faces' planes in a box, face by face.
  double level_of_faces(const Vec<double, D>& centre, const Vec<double, D>& half, double sign) const {
    double result = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < D; ++i)
      result = std::max({result, lower[i] - centre[i] + sign * half[i], centre[i] - upper[i] + sign * half[i]});
    return result;
  }
};

}  // namespace mote::geometry
