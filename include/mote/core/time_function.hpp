/// \file
/// TimeFunction: a number now or for ever.
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

namespace mote {

/// A number that is constant, or a function of time: 100 or [](double t) { ... }.
class TimeFunction {
  double constant_ = 0;
  std::function<double(double)> function_;

 public:
  TimeFunction() = default;
  TimeFunction(double constant) : constant_(constant) {}
  template <class F>
  requires(std::is_invocable_r_v<double, F, double>) TimeFunction(F f) : function_(std::move(f)) {}

  double operator()(double time) const { return function_ ? function_(time) : constant_; }
};

}  // namespace mote
