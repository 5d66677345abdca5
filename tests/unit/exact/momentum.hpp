/// \file
/// Manufactured solutions against differences: only the displacement and the material's energy are taken from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <mote/core/tensor.hpp>
#include <mote/exact/neo_hookean.hpp>

namespace mote::test {

/// df/ds at s = 0 by central differences of sixth order.
template <class F>
auto slope(const F& f, double h) {
  return (45 / (60 * h)) * (f(h) - f(-h)) - (9 / (60 * h)) * (f(2 * h) - f(-2 * h)) +
         (1 / (60 * h)) * (f(3 * h) - f(-3 * h));
}

/// d2f/ds2 at s = 0, likewise.
template <class F>
auto bend(const F& f, double h) {
  const double w = 1 / (180 * h * h);
  return (2 * w) * (f(3 * h) + f(-3 * h)) - (27 * w) * (f(2 * h) + f(-2 * h)) + (270 * w) * (f(h) + f(-h)) -
         (490 * w) * f(0);
}

template <int D>
Vec<double, D> shifted(Vec<double, D> x, int axis, double by) {
  x[axis] += by;
  return x;
}

/// P = dW/dF by differences of the energy.
inline Mat<double, 3> first_stress_by_differences(const exact::NeoHookean& m, const Mat<double, 3>& f) {
  Mat<double, 3> p{};
  for (int c = 0; c < 9; ++c)
    p.c[c] = slope(
        [&](double e) {
          Mat<double, 3> moved = f;
          moved.c[c] += e;
          return m.energy(moved);
        },
        1e-3);
  return p;
}

/// The same in closed form, so that it can be differentiated once more.
inline Mat<double, 3> first_stress(const exact::NeoHookean& m, const Mat<double, 3>& f) {
  return m.mu * f + (m.lambda * std::log(det(f)) - m.mu) * transpose(inverse(f));
}

/// How far a manufactured solution is from what differences say, each relative to the size of its terms.
struct Departures {
  double velocity = 0, inertia = 0, gradient = 0, stress = 0, momentum = 0, inverse = 0;
};

/// At the material point X and the time; `length` and `duration` are the steps of the differences.
template <class Solution, int D = Solution::dimension>
void depart(Departures& worst, const Solution& s, const Vec<double, D>& point, double time, double length,
            double duration) {
  const auto at = [&](double dt) { return s.displacement(point, time + dt); };
  const auto gradient = [&](const Vec<double, D>& x) {
    auto f = Mat<double, 3>::identity();
    for (int j = 0; j < D; ++j) {
      const auto du = slope([&](double e) { return s.displacement(shifted(x, j, e), time); }, length);
      for (int i = 0; i < D; ++i) f(i, j) += du[i];
    }
    return f;
  };
  const exact::NeoHookean material = s.material();
  Vec<double, D> div{};
  for (int j = 0; j < D; ++j)
    div += slope(
        [&](double e) {
          const auto p = first_stress(material, gradient(shifted(point, j, e)));
          Vec<double, D> column{};
          for (int i = 0; i < D; ++i) column[i] = p(i, j);
          return column;
        },
        length);
  const auto v = slope(at, duration), a = bend(at, duration), force = div * (1 / material.rho0);
  const double size = norm(a) + norm(force) + norm(s.body_force(point, time));
  const auto raise = [](double& worst_yet, double now) {
    if (!(now <= worst_yet)) worst_yet = now;  // nan too
  };
  raise(worst.velocity, norm(s.velocity(point, time) - v) / (norm(v) + norm(a) * duration));
  raise(worst.inertia, norm(s.inertia(point, time) - a) / size);
  raise(worst.momentum, norm(a - force - s.body_force(point, time)) / size);
  const auto f = gradient(point), exact = s.deformation_gradient(point, time);
  for (int c = 0; c < 9; ++c) raise(worst.gradient, std::abs(f.c[c] - exact.c[c]));
  const auto sigma = sym(first_stress_by_differences(material, exact) * transpose(exact)) * (1 / det(exact));
  const auto miss = sigma - s.stress(point, time);
  raise(worst.stress, std::sqrt(ddot(miss, miss)) / (material.lambda + material.mu));
  const auto x = s.position(point, time);
  raise(worst.inverse, norm(s.material_point(x, time) - point));
  raise(worst.inverse, norm(s.body_force_at(x, time) - s.body_force(point, time)) / size);
}

}  // namespace mote::test
