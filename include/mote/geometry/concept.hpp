/// \file
/// What a region is: a value that knows which points lie inside it, how far its surface is, and a box around it.
///
/// Lengths are in metres, coordinates in the frame of the grid. Regions compose with `-`, `&`, `|` and `~`
/// (geometry/boolean.hpp); your own region is a struct with the members that the concept Region names.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <mote/core/error.hpp>
#include <mote/core/vec.hpp>

namespace mote::geometry {

/// A box with sides along the axes, m. A side may be infinite; empty if upper < lower along any axis.
template <int D>
struct Bounds {
  Vec<double, D> lower, upper;

  static constexpr Bounds everything() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {Vec<double, D>::filled(-infinity), Vec<double, D>::filled(infinity)};
  }
};

/// Lower and upper limits of the level in some box, m.
struct Range {
  double lowest, highest;

  friend constexpr Range operator-(Range a) { return {-a.highest, -a.lowest}; }
  friend constexpr Range max(Range a, Range b) {
    return {std::max(a.lowest, b.lowest), std::max(a.highest, b.highest)};
  }
  friend constexpr Range min(Range a, Range b) {
    return {std::min(a.lowest, b.lowest), std::min(a.highest, b.highest)};
  }
};

/// A set of points in 1, 2 or 3 dimensions.
///
/// - `contains(x)`: whether x is inside. Simple regions contain their surface.
/// - `level(x)`: negative inside, positive outside, zero on the surface, and |level(x) - level(y)| <= |x - y|. The
///   signed distance is ideal, but any such function serves.
/// - `bounds()`: a box around the region, which may be infinite.
///
/// Two more members are used if they are there: `levels(centre, half)`, limits of the level in the box centre +- half,
/// which decides about more boxes at once than the level at the centre does; and `validate()`, which throws InputError.
template <class R>
concept Region = requires(const R& region, const Vec<double, R::dimension>& x) {
  requires R::dimension >= 1 && R::dimension <= 3;
  { region.contains(x) } -> std::same_as<bool>;
  { region.level(x) } -> std::convertible_to<double>;
  { region.bounds() } -> std::same_as<Bounds<R::dimension>>;
};

/// Limits of the region's level in the box centre +- half: the region's own, or those that the level's slope of at most
/// one allows.
template <Region R>
Range levels(const R& region, const Vec<double, R::dimension>& centre, const Vec<double, R::dimension>& half) {
  if constexpr (requires { region.levels(centre, half); }) {
    return region.levels(centre, half);
  } else {
    const double middle = region.level(centre), reach = norm(half);
    return {middle - reach, middle + reach};
  }
}

/// Throws InputError if the region has a validate() and that objects.
template <Region R>
void validate(const R& region) {
  if constexpr (requires { region.validate(); }) region.validate();
}

}  // namespace mote::geometry
