/// \file
/// A ball: a segment in one dimension, a disc in two.
#pragma once

#include <cmath>
#include <mote/geometry/concept.hpp>

namespace mote::geometry {

/// The points at most `radius` away from `centre`, m.
template <int D>
struct Ball {
  Vec<double, D> centre;
  double radius;

  static constexpr int dimension = D;

  bool contains(const Vec<double, D>& x) const { return level(x) <= 0; }

  /// The signed distance to the surface.
  double level(const Vec<double, D>& x) const { return norm(x - centre) - radius; }

  /// Exact: the levels at the box's nearest and farthest point.
  Range levels(const Vec<double, D>& middle, const Vec<double, D>& half) const {
    Vec<double, D> nearest{}, farthest{};
    for (int i = 0; i < D; ++i) {
      const double away = std::abs(middle[i] - centre[i]);
      nearest[i] = std::max(0.0, away - half[i]);
      farthest[i] = away + half[i];
    }
    return {norm(nearest) - radius, norm(farthest) - radius};
  }

  Bounds<D> bounds() const {
    const auto reach = Vec<double, D>::filled(radius);
    return {centre - reach, centre + reach};
  }

  /// \throws InputError unless the radius is positive and finite, and the centre finite.
  void validate() const {
    require(radius > 0 && std::isfinite(radius), "Ball: radius = ", radius, " m must be positive and finite");
    for (int i = 0; i < D; ++i)
      require(std::isfinite(centre[i]), "Ball: centre[", i, "] = ", centre[i], " m must be finite");
  }
};

}  // namespace mote::geometry
