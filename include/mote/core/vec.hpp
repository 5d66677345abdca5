/// \file
/// Vec<T, N>: a fixed-size vector of numbers, an aggregate, so that `Vec<double, 1>{5}` means what it says.
#pragma once

#include <cmath>
#include <cstdint>

namespace mote {

/// N numbers of type T; T may be a pack of numbers (core/pack.hpp).
template <class T, int N>
struct Vec {
  T c[N];

  constexpr T& operator[](int i) { return c[i]; }
  constexpr const T& operator[](int i) const { return c[i]; }

  constexpr Vec& operator+=(const Vec& b) {
    for (int i = 0; i < N; ++i) c[i] += b.c[i];
    return *this;
  }
  constexpr Vec& operator-=(const Vec& b) {
    for (int i = 0; i < N; ++i) c[i] -= b.c[i];
    return *this;
  }
  constexpr Vec& operator*=(const T& s) {
    for (int i = 0; i < N; ++i) c[i] *= s;
    return *this;
  }

  friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend constexpr Vec operator*(Vec a, const T& s) { return a *= s; }
  friend constexpr Vec operator*(const T& s, Vec a) { return a *= s; }
  friend constexpr bool operator==(const Vec& a, const Vec& b) {
    for (int i = 0; i < N; ++i)
      if (!(a.c[i] == b.c[i])) return false;
    return true;
  }

  /// All components equal to s.
  static constexpr Vec filled(const T& s) {
    Vec v{};
    for (int i = 0; i < N; ++i) v.c[i] = s;
    return v;
  }
};

/// Integer coordinates of a node, cell or block.
template <int N>
using IVec = Vec<std::int32_t, N>;

template <class T, int N>
constexpr T dot(const Vec<T, N>& a, const Vec<T, N>& b) {
  T sum = a.c[0] * b.c[0];
  for (int i = 1; i < N; ++i) sum += a.c[i] * b.c[i];
  return sum;
}

template <class T, int N>
T norm(const Vec<T, N>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Componentwise conversion to another number type.
template <class U, class T, int N>
constexpr Vec<U, N> cast(const Vec<T, N>& a) {
  Vec<U, N> r{};
  for (int i = 0; i < N; ++i) r.c[i] = U(a.c[i]);
  return r;
}

/// Axes by name, so that `.axis = axis::x` reads well.
namespace axis {
inline constexpr int x = 0, y = 1, z = 2;
}

/// A side of a box-shaped domain: an axis and an end of it.
struct Side {
  int axis;
  bool upper;  ///< true: the domain lies below the plane
  friend constexpr bool operator==(Side, Side) = default;
};
namespace side {
inline constexpr Side x_min{0, false}, x_max{0, true}, y_min{1, false}, y_max{1, true}, z_min{2, false}, z_max{2, true};
}

}  // namespace mote
