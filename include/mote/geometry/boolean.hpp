/// \file
/// Regions made of regions: `a - b`, `a & b`, `a | b` and `~a`.
///
/// The operators copy their operands, so the result is a value like any region. They are found when an operand is a
/// region of this namespace; for two regions of your own say `using mote::geometry::operator-;`.
#pragma once

#include <mote/geometry/concept.hpp>

namespace mote::geometry {

/// Two regions of the same number of dimensions.
template <class A, class B>
concept RegionPair = Region<A> && Region<B> &&(A::dimension == B::dimension);

/// What is in both. Its level is the larger one: exact inside and beside a face, else less than the distance.
template <Region A, Region B>
requires RegionPair<A, B>
struct Intersection {
  A a;
  B b;

  static constexpr int dimension = A::dimension;
  using Point = Vec<double, dimension>;

  bool contains(const Point& x) const { return a.contains(x) && b.contains(x); }
  double level(const Point& x) const { return std::max<double>(a.level(x), b.level(x)); }
  Range levels(const Point& centre, const Point& half) const {
    return max(geometry::levels(a, centre, half), geometry::levels(b, centre, half));
  }
  Bounds<dimension> bounds() const {
    auto result = a.bounds();
    const auto other = b.bounds();
    for (int i = 0; i < dimension; ++i) {
      result.lower[i] = std::max(result.lower[i], other.lower[i]);
      result.upper[i] = std::min(result.upper[i], other.upper[i]);
    }
    return result;
  }
  void validate() const {
    geometry::validate(a);
    geometry::validate(b);
  }
};

/// What is in either. Its level is the smaller one.
template <Region A, Region B>
requires RegionPair<A, B>
struct Union {
  A a;
  B b;

  static constexpr int dimension = A::dimension;
  using Point = Vec<double, dimension>;

  bool contains(const Point& x) const { return a.contains(x) || b.contains(x); }
  double level(const Point& x) const { return std::min<double>(a.level(x), b.level(x)); }
  Range levels(const Point& centre, const Point& half) const {
    return min(geometry::levels(a, centre, half), geometry::levels(b, centre, half));
  }
  Bounds<dimension> bounds() const {
    auto result = a.bounds();
    const auto other = b.bounds();
    for (int i = 0; i < dimension; ++i) {
      result.lower[i] = std::min(result.lower[i], other.lower[i]);
      result.upper[i] = std::max(result.upper[i], other.upper[i]);
    }
    return result;
  }
  void validate() const {
    geometry::validate(a);
    geometry::validate(b);
  }
};

/// All but the region. Nothing bounds it: take it together with a box.
template <Region A>
struct Complement {
  A a;

  static constexpr int dimension = A::dimension;
  using Point = Vec<double, dimension>;

  bool contains(const Point& x) const { return !a.contains(x); }
  double level(const Point& x) const { return -a.level(x); }
  Range levels(const Point& centre, const Point& half) const { return -geometry::levels(a, centre, half); }
  Bounds<dimension> bounds() const { return Bounds<dimension>::everything(); }
  void validate() const { geometry::validate(a); }
};

/// What is in both a and b.
template <Region A, Region B>
requires RegionPair<A, B>
constexpr Intersection<A, B> operator&(const A& a, const B& b) { return {a, b}; }

/// What is in a or b or both.
template <Region A, Region B>
requires RegionPair<A, B>
constexpr Union<A, B> operator|(const A& a, const B& b) { return {a, b}; }

/// All but a.
template <Region A>
constexpr Complement<A> operator~(const A& a) {
  return {a};
}

/// What is in a and not in b.
template <Region A, Region B>
requires RegionPair<A, B>
constexpr Intersection<A, Complement<B>> operator-(const A& a, const B& b) { return {a, {b}}; }

}  // namespace mote::geometry
