/// \file
/// Whether a shape function is one.
#pragma once

#include <mote/core/pack.hpp>
#include <mote/shape/concept.hpp>
#include <mote/verify/tools.hpp>

namespace mote::verify {

namespace detail {

/// The checks of one kernel, at places f and, if it asks for one, half sizes.
///
/// Weights are sums of products of numbers up to S::support; 16 operations of their round-off are allowed.
template <class S>
class ShapeChecks {
  static constexpr int n = S::support;
  static constexpr double noise = 16 * n * eps;

  template <class T>
  static void values(const T& f, const T& half, T* w) {
    if constexpr (sized<S>)
      S::values(f, half, w);
    else
      S::values(f, w);
  }
  template <class T>
  static void slopes(const T& f, const T& half, T* d) {
    if constexpr (sized<S>)
      S::slopes(f, half, d);
    else
      S::slopes(f, d);
  }

  static std::string at(double f, double half) {
    return sized<S> ? text("f = ", f, ", half size ", half) : text("f = ", f);
  }

  /// Calls g(f, half, w, d) for places in the middle, at the ends, and in between.
  template <class G>
  static void for_each_place(double margin, const G& g) {
    Random random(1);
    for (int i = 0; i < 400; ++i) {
      const double u = i == 0 ? 0 : i == 1 ? 0.5 : i == 2 ? 1 : random.between(0, 1);
      const double f = S::first + margin + (1 - 2 * margin) * u, half = random.between(0.05, 0.5);
      double w[n], d[n];
      values(f, half, w);
      slopes(f, half, d);
      g(f, half, w, d);
    }
  }

  /// The row of a sum over nodes that should be `expected`.
  template <class Term>
  static Row sum(const char* check, double expected, const Term& term) {
    Worst worst;
    for_each_place(0, [&](double f, double half, const double* w, const double* d) {
      double total = 0;
      for (int i = 0; i < n; ++i) total += term(i, f, w, d);
      worst.see(std::abs(total - expected), n * n * noise, [&] { return text(at(f, half), ": ", total); });
    });
    return worst.row(check);
  }

 public:
  static Row unity() {
    return sum("partition of unity", 1, [](int i, double, const double* w, const double*) { return w[i]; });
  }
  static Row gradient_sum() {
    return sum("slopes sum to zero", 0, [](int i, double, const double*, const double* d) { return d[i]; });
  }
  static Row linear() {
    return sum("linear functions are reproduced", 0,
               [](int i, double f, const double* w, const double*) { return w[i] * (i - f); });
  }
  static Row inertia() {
    if (S::inertia == 0) return only_reported("inertia", 0, "not stated");
    return sum("inertia", S::inertia,
               [](int i, double f, const double* w, const double*) { return w[i] * (i - f) * (i - f); });
  }

  static Row against_differences() {
    Worst worst;
    const double h = 1e-4;
    for_each_place(2 * h, [&](double f, double half, const double*, const double* d) {
      for (int i = 0; i < n; ++i) {
        const auto weight = [&](double g) {
          double w[n];
          values(g, half, w);
          return w[i];
        };
        const Slope by = slope(weight, f, h, noise);
        worst.see(std::abs(d[i] - by.value), by.error + noise,
                  [&] { return text("node ", i, ", ", at(f, half), ": ", d[i], ", differences ", by.value); });
      }
    });
    return worst.row("slopes are those of the weights");
  }

  /// What leaves a cell on one side is what enters the next.
  static Row continuity() {
    Worst worst;
    for (const double half : {0.05, 0.2, 0.5}) {
      double left[n], right[n];
      values(S::first + 1, half, left);
      values(double(S::first), half, right);
      for (int i = 0; i <= n; ++i) {
        const double a = i < n ? left[i] : 0, b = i > 0 ? right[i - 1] : 0;
        worst.see(std::abs(a - b), noise, [&] { return text("node ", i, " at the end of a cell: ", a, " and ", b); });
      }
    }
    return worst.row("weights are continuous across cells");
  }

  static Row positive() {
    Worst worst;
    for_each_place(0, [&](double f, double half, const double* w, const double*) {
      for (int i = 0; i < n; ++i)
        worst.see(std::max(-w[i], 0.0), noise, [&] { return text("node ", i, ", ", at(f, half)); });
    });
    return worst.row("weights are not negative");
  }

  static Row packs() {
    Worst worst;
    Random random(2);
    for (int round = 0; round < 50; ++round) {
      const Pack<double> f([&](int) { return S::first + random.between(0, 1); });
      const Pack<double> half([&](int) { return random.between(0.05, 0.5); });
      Pack<double> w[n], d[n];
      values(f, half, w);
      slopes(f, half, d);
      for (int l = 0; l < lanes; ++l) {
        double one_w[n], one_d[n];
        values(lane(f, l), lane(half, l), one_w);
        slopes(lane(f, l), lane(half, l), one_d);
        for (int i = 0; i < n; ++i)
          worst.see(std::max(std::abs(lane(w[i], l) - one_w[i]), std::abs(lane(d[i], l) - one_d[i])), noise,
                    [&] { return text("node ", i, " in lane ", l, ", ", at(lane(f, l), lane(half, l))); });
      }
    }
    return worst.row("packs are numbers, lane by lane");
  }
};

}  // namespace detail

/// Checks a shape function: partition of unity, slopes that sum to zero, linear reproduction, slopes against
/// differences, inertia, continuity across cells, weights that are not negative, packs. One that depends on the
/// particle's size is looked at with half sizes from 0.05 to 0.5 cells.
template <class S>
Report shape(const S&) {
  static_assert(mote::Shape<S>, "mote: the shape function lacks a member; shape/concept.hpp lists them");
  using Checks = detail::ShapeChecks<S>;
  return {"shape",
          {Checks::unity(), Checks::gradient_sum(), Checks::linear(), Checks::against_differences(), Checks::inertia(),
           Checks::continuity(), Checks::positive(), Checks::packs()}};
}

}  // namespace mote::verify
