/// \file
/// Mat<T, N> (general) and SymTensor<T> (symmetric, always three-dimensional), for any number type T, packs included.
#pragma once

#include <mote/core/vec.hpp>

namespace mote {

/// N x N matrix, row-major: a(i, j) is row i, column j.
template <class T, int N>
struct Mat {
  T c[N * N];

  constexpr T& operator()(int i, int j) { return c[i * N + j]; }
  constexpr const T& operator()(int i, int j) const { return c[i * N + j]; }

  constexpr Mat& operator+=(const Mat& b) {
    for (int i = 0; i < N * N; ++i) c[i] += b.c[i];
    return *this;
  }
  friend constexpr Mat operator+(Mat a, const Mat& b) { return a += b; }
  friend constexpr Mat operator-(Mat a, const Mat& b) {
    for (int i = 0; i < N * N; ++i) a.c[i] -= b.c[i];
    return a;
  }
  friend constexpr Mat operator*(Mat a, const T& s) {
    for (int i = 0; i < N * N; ++i) a.c[i] *= s;
    return a;
  }
  friend constexpr Mat operator*(const T& s, Mat a) { return a * s; }

  static constexpr Mat identity() {
    Mat m{};
    for (int i = 0; i < N * N; ++i) m.c[i] = T(0);
    for (int i = 0; i < N; ++i) m(i, i) = T(1);
    return m;
  }
};

template <class T, int N>
constexpr Mat<T, N> operator*(const Mat<T, N>& a, const Mat<T, N>& b) {
  Mat<T, N> r{};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      T sum = a(i, 0) * b(0, j);
      for (int k = 1; k < N; ++k) sum += a(i, k) * b(k, j);
      r(i, j) = sum;
    }
  return r;
}

template <class T, int N>
constexpr Vec<T, N> operator*(const Mat<T, N>& a, const Vec<T, N>& v) {
  Vec<T, N> r{};
  for (int i = 0; i < N; ++i) {
    T sum = a(i, 0) * v[0];
    for (int k = 1; k < N; ++k) sum += a(i, k) * v[k];
    r[i] = sum;
  }
  return r;
}

template <class T, int N>
constexpr Mat<T, N> transpose(const Mat<T, N>& a) {
  Mat<T, N> r{};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) r(i, j) = a(j, i);
  return r;
}

template <class U, class T, int N>
constexpr Mat<U, N> cast(const Mat<T, N>& a) {
  Mat<U, N> r{};
  for (int i = 0; i < N * N; ++i) r.c[i] = U(a.c[i]);
  return r;
}

template <class T>
constexpr T det(const Mat<T, 3>& a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

template <class T>
constexpr Mat<T, 3> inverse(const Mat<T, 3>& a) {
  Mat<T, 3> r{};
  const T s = T(1) / det(a);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int p = (j + 1) % 3, q = (j + 2) % 3, u = (i + 1) % 3, v = (i + 2) % 3;
      r(i, j) = s * (a(p, u) * a(q, v) - a(p, v) * a(q, u));
    }
  return r;
}

/// A D x D matrix as the upper left part of a 3 x 3 one, zero elsewhere (plane or uniaxial strain).
template <class T, int D>
constexpr Mat<T, 3> embed(const Mat<T, D>& a) {
  if constexpr (D == 3) {
    return a;
  } else {
    Mat<T, 3> r{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r(i, j) = i < D && j < D ? a(i < D ? i : 0, j < D ? j : 0) : T(0);
    return r;
  }
}

/// Symmetric 3 x 3 tensor, six numbers in the order xx, yy, zz, xy, yz, xz.
///
/// Stress and strain are three-dimensional whatever the dimension of the grid: plane strain has a stress along z.
template <class T>
struct SymTensor {
  T c[6];

  static constexpr int index(int i, int j) { return i == j ? i : (i + j == 1 ? 3 : (i + j == 3 ? 4 : 5)); }
  constexpr T& operator()(int i, int j) { return c[index(i, j)]; }
  constexpr const T& operator()(int i, int j) const { return c[index(i, j)]; }

  constexpr SymTensor& operator+=(const SymTensor& b) {
    for (int i = 0; i < 6; ++i) c[i] += b.c[i];
    return *this;
  }
  friend constexpr SymTensor operator+(SymTensor a, const SymTensor& b) { return a += b; }
  friend constexpr SymTensor operator-(SymTensor a, const SymTensor& b) {
    for (int i = 0; i < 6; ++i) a.c[i] -= b.c[i];
    return a;
  }
  friend constexpr SymTensor operator*(SymTensor a, const T& s) {
    for (int i = 0; i < 6; ++i) a.c[i] *= s;
    return a;
  }
  friend constexpr SymTensor operator*(const T& s, SymTensor a) { return a * s; }
};

/// Double contraction a : b.
template <class T>
constexpr T ddot(const SymTensor<T>& a, const SymTensor<T>& b) {
  return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2] +
         T(2) * (a.c[3] * b.c[3] + a.c[4] * b.c[4] + a.c[5] * b.c[5]);
}

template <class T>
constexpr T trace(const SymTensor<T>& a) {
  return a.c[0] + a.c[1] + a.c[2];
}

/// a + s I.
template <class T>
constexpr SymTensor<T> add_diagonal(SymTensor<T> a, const T& s) {
  for (int i = 0; i < 3; ++i) a.c[i] += s;
  return a;
}

template <class T>
constexpr SymTensor<T> deviator(const SymTensor<T>& a) {
  return add_diagonal(a, T(-1.0 / 3) * trace(a));
}

/// The symmetric part of a matrix.
template <class T>
constexpr SymTensor<T> sym(const Mat<T, 3>& a) {
  const T half(0.5);
  return {
      {a(0, 0), a(1, 1), a(2, 2), half * (a(0, 1) + a(1, 0)), half * (a(1, 2) + a(2, 1)), half * (a(0, 2) + a(2, 0))}};
}

/// R s R^T.
template <class T>
constexpr SymTensor<T> rotate(const Mat<T, 3>& r, const SymTensor<T>& s) {
  Mat<T, 3> rs{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rs(i, j) = r(i, 0) * s(0, j) + r(i, 1) * s(1, j) + r(i, 2) * s(2, j);
  SymTensor<T> out{};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) out(i, j) = rs(i, 0) * r(j, 0) + rs(i, 1) * r(j, 1) + rs(i, 2) * r(j, 2);
  return out;
}

}  // namespace mote
