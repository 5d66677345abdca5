/// \file
/// VectorField: a vector here or everywhere.
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

#include <mote/core/tensor.hpp>

namespace mote {

/// A vector that is constant, or a function of position (and time): {0, 0, 100} or [](Vec<double, 3> x) { ... }.
///
/// The function of a load is called from several threads at once.
template <int D>
class VectorField {
  using X = Vec<double, D>;
  X constant_{};
  std::function<X(const X&, double)> function_;

 public:
  VectorField() = default;
  VectorField(const X& constant) : constant_(constant) {}
  template <class... N>
    requires(sizeof...(N) == D && (std::is_arithmetic_v<N> && ...))
  VectorField(N... n) : constant_{double(n)...} {}
  template <class F>
    requires(std::is_invocable_r_v<X, F, const X&, double>)
  VectorField(F f) : function_(std::move(f)) {}
  template <class F>
    requires(std::is_invocable_r_v<X, F, const X&>)
  VectorField(F f) : function_([f](const X& x, double) { return f(x); }) {}

  X operator()(const X& x, double time = 0) const { return function_ ? function_(x, time) : constant_; }

  /// Its gradient (i, a) = df_i/dx_a by a central difference over 2 `reach`.
  Mat<double, D> gradient(const X& x, double reach) const {
    Mat<double, D> g{};
    for (int a = 0; function_ && a < D; ++a) {
      X above = x, below = x;
      above[a] += reach, below[a] -= reach;
      const X f = function_(above, 0), b = function_(below, 0);
      for (int i = 0; i < D; ++i) g(i, a) = (f[i] - b[i]) / (above[a] - below[a]);
    }
    return g;
  }
};

}  // namespace mote
