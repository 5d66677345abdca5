/// \file
/// Eigenvalues, logarithm and exponential of symmetric 3 x 3 tensors, for numbers and packs: no branch depends on a
/// value.
#pragma once

#include <mote/core/pack.hpp>
#include <mote/core/tensor.hpp>

namespace mote {

/// Eigenvalues and, in the columns of a rotation, eigenvectors; in no particular order.
template <class T>
struct Spectral {
  Vec<T, 3> values;
  Mat<T, 3> vectors;
};

namespace detail {

/// Turns axes p and q so that a(p, q) vanishes; r is the third axis.
template <class T>
void jacobi_rotation(SymTensor<T>& a, Mat<T, 3>& v, int p, int q, int r) {
  using std::abs;
  using std::max;
  using std::min;
  using std::sqrt;
  const T d = a(q, q) - a(p, p), o = a(p, q) + a(p, q);
  // the tangent of the smaller angle; the floor keeps 0/0 out, the bounds what underflowed in the squares
  const T size = abs(d) + sqrt(d * d + o * o) + T(1e-30);
  const T t = min(max(select(d < T(0), T(-o), o) / size, T(-1)), T(1));
  const T c = T(1) / sqrt(T(1) + t * t), s = t * c;
  const T shift = t * a(p, q), apr = a(p, r), aqr = a(q, r);
  a(p, p) -= shift;
  a(q, q) += shift;
  a(p, q) = T(0);
  a(p, r) = c * apr - s * aqr;
  a(q, r) = s * apr + c * aqr;
  for (int i = 0; i < 3; ++i) {
    const T vp = v(i, p), vq = v(i, q);
    v(i, p) = c * vp - s * vq;
    v(i, q) = s * vp + c * vq;
  }
}

}  // namespace detail

/// By cyclic Jacobi rotations: backward stable, also where eigenvalues meet; the error is round-off of the largest.
///
/// The off-diagonal part falls quadratically; four sweeps leave nothing of it in double precision.
/// Source: Golub and Van Loan, Matrix Computations, section 8.5.
template <class T>
Spectral<T> spectral(SymTensor<T> a) {
  Mat<T, 3> v = Mat<T, 3>::identity();
  for (int sweep = 0; sweep < 4; ++sweep) {
    detail::jacobi_rotation(a, v, 0, 1, 2);
    detail::jacobi_rotation(a, v, 0, 2, 1);
    detail::jacobi_rotation(a, v, 1, 2, 0);
  }
  return {{a.c[0], a.c[1], a.c[2]}, v};
}

/// The tensor with these eigenvalues and eigenvectors.
template <class T>
SymTensor<T> compose(const Spectral<T>& s) {
  SymTensor<T> r{};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      T sum = s.values[0] * (s.vectors(i, 0) * s.vectors(j, 0));
      for (int k = 1; k < 3; ++k) sum += s.values[k] * (s.vectors(i, k) * s.vectors(j, k));
      r(i, j) = sum;
    }
  return r;
}

/// a b of tensors that commute, so that the product is symmetric.
template <class T>
[[gnu::always_inline]] inline SymTensor<T> commuting_product(const SymTensor<T>& a, const SymTensor<T>& b) {
  SymTensor<T> r{};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) r(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  return r;
}

template <class T>
SymTensor<T> inverse(const SymTensor<T>& a) {
  SymTensor<T> r{};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const int p = (i + 1) % 3, q = (i + 2) % 3, u = (j + 1) % 3, v = (j + 2) % 3;
      r(i, j) = a(p, u) * a(q, v) - a(p, v) * a(q, u);
    }
  return r * (T(1) / (a(0, 0) * r(0, 0) + a(0, 1) * r(0, 1) + a(0, 2) * r(0, 2)));
}

namespace detail {

/// Up to here log1p is a series: its last term is round-off, in double precision.
inline constexpr double log_series_size = 0.2;

/// ln(I + a) = 2 artanh(z) with z = a (2 I + a)^-1, by the series z (1 + w/3 + w^2/5 + ...), w = z^2.
template <class T>
SymTensor<T> log1p_near(const SymTensor<T>& a) {
  const SymTensor<T> z = commuting_product(a, inverse(add_diagonal(a, T(2)))), w = commuting_product(z, z);
  SymTensor<T> sum = w * T(2.0 / 17);
  for (int n = 15; n > 1; n -= 2) sum = commuting_product(w, add_diagonal(sum, T(2.0 / n)));
  return commuting_product(z, add_diagonal(sum, T(2)));
}

template <class T>
SymTensor<T> log1p_far(const SymTensor<T>& a) {
  using std::log1p;
  Spectral<T> s = spectral(a);
  for (int k = 0; k < 3; ++k) s.values[k] = log1p(s.values[k]);
  return compose(s);
}

}  // namespace detail

/// ln(I + a), with an error relative to a, not to I. Eigenvalues of a must be above -1.
///
/// A series where |a| <= 0.2, else by eigenvalues, which take three times as long; a lane's digits do not depend on the
/// other lanes.
template <class T>
SymTensor<T> log1p(const SymTensor<T>& a) {
  const auto near = ddot(a, a) <= T(detail::log_series_size * detail::log_series_size);
  SymTensor<T> small = a;
  for (auto& c : small.c) c = select(near, c, T(0));
  SymTensor<T> r = detail::log1p_near(small);
  if (all_of(near)) return r;
  const SymTensor<T> far = detail::log1p_far(a);
  for (int i = 0; i < 6; ++i) r.c[i] = select(near, r.c[i], far.c[i]);
  return r;
}

/// exp(a) - I, with an error relative to a. Exact to round-off for eigenvalues up to 8; beyond that it slowly loses
/// digits.
///
/// Taylor's series to the eighth order for a/64, then squared six times: exp(2 y) - I = 2 (exp(y) - I) + (exp(y) -
/// I)^2.
template <class T>
SymTensor<T> expm1(const SymTensor<T>& a) {
  const SymTensor<T> y = a * T(1.0 / 64);
  SymTensor<T> sum = y * T(1.0 / 8);
  for (int n = 7; n > 0; --n) sum = commuting_product(y, add_diagonal(sum, T(1))) * T(1.0 / n);
  for (int k = 0; k < 6; ++k) sum = T(2) * sum + commuting_product(sum, sum);
  return sum;
}

}  // namespace mote
