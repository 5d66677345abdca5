/// \file
/// Numerical tools of the exact solutions: a root of a monotone function, ordinary differential equations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <mote/core/error.hpp>

namespace mote::exact::detail {

/// The root of a growing function between `low` and `high` to round-off: Newton's method, held inside the bracket.
/// f(x) returns the value and the slope; f(low) <= 0 <= f(high).
template <class F>
double newton(const F& f, double low, double high) {
  const double width = high - low;
  double x = low + 0.5 * width;
  for (int k = 0; k < 200; ++k) {
    const std::pair<double, double> v = f(x);
    const double step = v.first / v.second;
    if (v.first == 0 || std::abs(step) <= 1e-16 * (std::abs(x) + width)) return v.first == 0 ? x : x - step;
    (v.first < 0 ? low : high) = x;
    const double next = x - step;
    x = next > low && next < high ? next : low + 0.5 * (high - low);
  }
  return x;
}

template <std::size_t N>
using Numbers = std::array<double, N>;

/// y + h k.
template <std::size_t N>
Numbers<N> moved(Numbers<N> y, double h, const Numbers<N>& k) {
  for (std::size_t i = 0; i < N; ++i) y[i] += h * k[i];
  return y;
}

/// One step of the classical Runge-Kutta method for dy/dt = f(t, y). Fourth order.
template <std::size_t N, class F>
Numbers<N> rk4(const F& f, double t, const Numbers<N>& y, double h) {
  const Numbers<N> a = f(t, y), b = f(t + h / 2, moved(y, h / 2, a)), c = f(t + h / 2, moved(y, h / 2, b));
  const Numbers<N> d = f(t + h, moved(y, h, c));
  Numbers<N> sum{};
  for (std::size_t i = 0; i < N; ++i) sum[i] = (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6;
  return moved(y, h, sum);
}

/// Two half steps and one whole step: their difference tells the error, and extrapolation gives the fifth order.
template <std::size_t N>
struct DoubledStep {
  Numbers<N> y;      ///< at t + h
  Numbers<N> error;  ///< estimate of the error of the two half steps
};

template <std::size_t N, class F>
DoubledStep<N> doubled_step(const F& f, double t, const Numbers<N>& y, double h) {
  const Numbers<N> whole = rk4(f, t, y, h);
  DoubledStep<N> s{rk4(f, t + h / 2, rk4(f, t, y, h / 2), h / 2), {}};
  for (std::size_t i = 0; i < N; ++i) {
    s.error[i] = (s.y[i] - whole[i]) / 15;
    s.y[i] += s.error[i];
  }
  return s;
}

/// By what factor the next step should differ from one whose error came out `error` times its tolerance.
inline double step_factor(double error) {
  if (error == 0) return 4;
  return std::isfinite(error) ? std::clamp(0.9 * std::pow(error, -0.2), 0.1, 4.0) : 0.1;
}

/// dy/dt = f(t, y) from t = a to b, in steps whose error estimate stays below `tolerance`, relative to the largest
/// value that each component has had.
///
/// \throws NumericalError when the step shrinks to nothing.
template <std::size_t N, class F>
Numbers<N> solve_ode(const F& f, Numbers<N> y, double a, double b, double tolerance) {
  Numbers<N> largest{};
  const auto grow = [&](const Numbers<N>& now) {
    for (std::size_t i = 0; i < N; ++i) largest[i] = std::max(largest[i], std::abs(now[i]));
  };
  grow(y);
  double t = a, h = (b - a) / 16;
  while (t != b) {
    const bool last = std::abs(b - t) <= std::abs(h);
    if (last) h = b - t;
    const DoubledStep<N> s = doubled_step(f, t, y, h);
    double error = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const double scale = std::max(largest[i], std::abs(s.y[i]));
      if (s.error[i] != 0) error = std::max(error, std::abs(s.error[i]) / (tolerance * scale));
      if (!std::isfinite(s.y[i])) error = HUGE_VAL;
    }
    if (error <= 1) {
      t = last ? b : t + h;
      y = s.y;
      grow(y);
    }
    h *= step_factor(error);
    if (t + h == t && t != b) throw NumericalError(text("mote: the integration of an exact solution stops at ", t));
  }
  return y;
}

}  // namespace mote::exact::detail
