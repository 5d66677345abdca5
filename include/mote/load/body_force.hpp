/// \file
/// Body force.
#pragma once

#include <functional>
#include <type_traits>

#include <mote/core/role.hpp>
#include <mote/core/vec.hpp>

namespace mote {

/// A vector that is constant, or a function of position (and time): {0, 0, 100} or [](Vec<double, 3> x) { ... }.
template <int D>
class VectorField {
  Vec<double, D> constant_{};
  std::function<Vec<double, D>(const Vec<double, D>&, double)> function_;

 public:
  VectorField() = default;
  VectorField(const Vec<double, D>& constant) : constant_(constant) {}
  template <class... N>
  requires(sizeof...(N) == D && (std::is_arithmetic_v<N> && ...)) VectorField(N... n) : constant_{double(n)...} {}
  template <class F>
  requires std::is_invocable_r_v < Vec<double, D>, F,
  const Vec<double, D>&, double > VectorField(F f) : function_(std::move(f)) {}
  template <class F>
  requires std::is_invocable_r_v < Vec<double, D>, F,
  const Vec<double, D>& > VectorField(F f) : function_([f](const Vec<double, D>& x, double) { return f(x); }) {}

  bool is_constant() const { return !function_; }
  Vec<double, D> operator()(const Vec<double, D>& x, double time = 0) const {
    return function_ ? function_(x, time) : constant_;
  }
};

namespace load {

/// An acceleration of every node, m/s^2, constant or a function of position and time.
template <int D>
struct BodyForce {
  using role = mote::role::Load;
  VectorField<D> acceleration;
};

}  // namespace load
}  // namespace mote
