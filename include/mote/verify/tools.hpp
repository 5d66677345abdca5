/// \file
/// What the checks share: random states that are the same everywhere, differences that know their error, and jumps.
#pragma once

#include <cmath>
#include <cstdint>
#include <mote/core/tensor.hpp>
#include <mote/verify/report.hpp>

namespace mote::verify::detail {

/// SplitMix64: the same numbers with every compiler and library. Source: Steele, Lea, Flood, OOPSLA (2014) 453.
class Random {
  std::uint64_t state_;

 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double between(double from, double to) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return from + (to - from) * (double((z ^ (z >> 31)) >> 11) * 0x1p-53);
  }
  double operator()(double size) { return between(-size, size); }
  Mat<double, 3> matrix(double size) {
    Mat<double, 3> a{};
    for (double& c : a.c) c = (*this)(size);
    return a;
  }
  Vec<double, 3> direction() {
    Vec<double, 3> n{};
    do n = {(*this)(1), (*this)(1), (*this)(1)};
    while (norm(n) < 0.1);
    return n * (1 / norm(n));
  }
};

/// A derivative by differences, and a bound on its error.
struct Slope {
  double value, error;
};

/// By central differences over h and 2 h, extrapolated; what the extrapolation changes bounds the truncation (where f
/// has a kink, the kink). \param noise absolute round-off of f
template <class F>
Slope slope(const F& f, double x, double h, double noise) {
  const double fine = (f(x + h) - f(x - h)) / (2 * h), coarse = (f(x + 2 * h) - f(x - 2 * h)) / (4 * h);
  return {fine + (fine - coarse) / 3, std::abs(fine - coarse) + 2 * noise / h};
}
/// The same to one side, that of the sign of h.
template <class F>
Slope slope_to(const F& f, double x, double h, double noise) {
  const double f0 = f(x), fine = (f(x + h) - f0) / h, coarse = (f(x + 2 * h) - f0) / (2 * h);
  return {2 * fine - coarse, 2 * std::abs(fine - coarse) + 4 * noise / std::abs(h)};
}

/// Where f changes most between a and b, by halving forty times: at a step of f all of it is left, elsewhere a part in
/// 2^40 times the steepness.
struct Jump {
  double at, size, whole;  ///< whole: |f(b) - f(a)|

  /// Of a continuous function, up to a million times as steep there as between a and b, and round-off.
  double allowed(double noise) const { return 0x1p-20 * whole + noise; }
};
template <class F, class Distance>
Jump find_jump(const F& f, double a, double b, const Distance& distance) {
  auto fa = f(a), fb = f(b);
  Jump jump{b, distance(fa, fb), distance(fa, fb)};
  for (int level = 0; level < 40 && std::isfinite(jump.size); ++level) {
    const double middle = 0.5 * (a + b);
    const auto fm = f(middle);
    const double left = distance(fa, fm), right = distance(fm, fb);
    if (left >= right || !std::isfinite(left))
      b = middle, fb = fm, jump.size = left;
    else
      a = middle, fa = fm, jump.size = right;
  }
  jump.at = b;
  return jump;
}

}  // namespace mote::verify::detail
