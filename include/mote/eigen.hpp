/// \file
/// To and from Eigen, and what Eigen does better than we would: principal stresses, polar decomposition.
///
/// The only header that needs Eigen; mote.hpp leaves it out.
#pragma once

#include <Eigen/Dense>
#include <span>

#include <mote/core/tensor.hpp>

namespace mote::eigen {

template <class T, int N>
Eigen::Matrix<T, N, 1> to_eigen(const Vec<T, N>& v) {
  return Eigen::Map<const Eigen::Matrix<T, N, 1>>(v.c);
}
template <class T, int N>
Eigen::Matrix<T, N, N> to_eigen(const Mat<T, N>& a) {
  return Eigen::Map<const Eigen::Matrix<T, N, N, N == 1 ? Eigen::ColMajor : Eigen::RowMajor>>(a.c);
}
template <class T>
Eigen::Matrix<T, 3, 3> to_eigen(const SymTensor<T>& a) {
  Eigen::Matrix<T, 3, 3> m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = a(i, j);
  return m;
}

template <class Derived>
auto to_vec(const Eigen::MatrixBase<Derived>& v) {
  constexpr int n = Derived::SizeAtCompileTime;
  static_assert(Derived::IsVectorAtCompileTime && n > 0, "mote: to_vec() takes a vector of fixed size");
  Vec<typename Derived::Scalar, n> r{};
  for (int i = 0; i < n; ++i) r[i] = v(i);
  return r;
}
template <class Derived>
auto to_mat(const Eigen::MatrixBase<Derived>& a) {
  constexpr int n = Derived::RowsAtCompileTime;
  static_assert(n > 0 && n == Derived::ColsAtCompileTime, "mote: to_mat() takes a square matrix of fixed size");
  Mat<typename Derived::Scalar, n> r{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) r(i, j) = a(i, j);
  return r;
}

/// A particle column as an Eigen vector, without a copy: `as_vector(particles.column<field::Mass>()).sum()`.
template <class T>
Eigen::Map<Eigen::VectorX<std::remove_const_t<T>>> as_vector(std::span<T> column) requires(!std::is_const_v<T>) {
  return {column.data(), Eigen::Index(column.size())};
}
template <class T>
Eigen::Map<const Eigen::VectorX<T>> as_vector(std::span<const T> column) {
  return {column.data(), Eigen::Index(column.size())};
}

/// Principal values of a stress or strain, smallest first, in its own unit.
template <class T>
Vec<T, 3> principal_values(const SymTensor<T>& a) {
  return to_vec(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix<T, 3, 3>>(to_eigen(a), Eigen::EigenvaluesOnly).eigenvalues());
}

/// The rotation R of F = R U, from the singular values; det F must be positive.
template <class T>
Mat<T, 3> rotation_of(const Mat<T, 3>& f) {
  const Eigen::JacobiSVD<Eigen::Matrix<T, 3, 3>> svd(to_eigen(f), Eigen::ComputeFullU | Eigen::ComputeFullV);
  return to_mat((svd.matrixU() * svd.matrixV().transpose()).eval());
}

}  // namespace mote::eigen
