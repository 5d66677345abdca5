/// \file
/// A strain path with a corner and a curve, and the rate equations of a von Mises metal integrated by Runge and Kutta:
/// what stress integrators are measured against. Shares no code with them.
#pragma once

#include <algorithm>
#include <cmath>
#include <mote/core/field.hpp>
#include <mote/strength/kinematics.hpp>
#include <numbers>
#include <vector>

namespace strain_path {

using namespace mote;
using Tensor = SymTensor<double>;

inline constexpr double g = 25.94e9, yield = 120e6;  // Pa
inline double magnitude(const Tensor& a) { return std::sqrt(ddot(a, a)); }

/// Deviatoric strain as a function of time: straight to `size` times the yield strain (t = 0 to 1), there a corner of a
/// right angle, then half a turn about the origin (t = 1 to 2).
struct Path {
  double size = 5;
  double radius = size * std::sqrt(2.0 / 3) * yield / (2 * g);  // |e| at the corner

  static Tensor in_plane(double a, double b) {
    const double u = a / std::sqrt(6), v = b / std::sqrt(2);
    return {{2 * u, -u, -u, v, 0, 0}};
  }
  Tensor strain(double t) const {
    if (t <= 1) return in_plane(radius * t, 0);
    const double phi = std::numbers::pi * (t - 1);
    return in_plane(radius * std::cos(phi), radius * std::sin(phi));
  }
  /// On the leg that begins at t = 0 or 1.
  Tensor rate(double t, int leg) const {
    if (leg == 0) return in_plane(radius, 0);
    const double phi = std::numbers::pi * (t - 1), w = std::numbers::pi * radius;
    return in_plane(-w * std::sin(phi), w * std::cos(phi));
  }
  double yields_at() const { return 1 / size; }
};

struct Metal {
  double isotropic, kinematic;
};

/// What the rate equations move: stress, back stress, equivalent plastic strain.
struct Point {
  Tensor s, back;
  double eps;
};

inline Point sum(const Point& p, double h, const Point& r) {
  return {p.s + h * r.s, p.back + h * r.back, p.eps + h * r.eps};
}

/// The rate equations with the consistency condition, for a state on the yield surface.
struct RateEquations {
  Metal metal;
  mutable double least = 1;  ///< smallest n : e'/|e'| met: above zero the metal flows all the time

  Point operator()(const Point& p, const Tensor& strain_rate) const {
    const Tensor relative = p.s - p.back, n = relative * (1 / magnitude(relative));
    const double k = 2 * g + (2.0 / 3) * (metal.isotropic + metal.kinematic), along = ddot(n, strain_rate);
    least = std::min(least, along / magnitude(strain_rate));
    const double flow = 2 * g * along / k;
    return {2 * g * (strain_rate - flow * n), (2.0 / 3 * metal.kinematic * flow) * n, std::sqrt(2.0 / 3) * flow};
  }

  /// Runge and Kutta's fourth order, n steps. \param rate the strain rate as a function of time
  template <class Rate>
  void advance(Point& p, const Rate& rate, double from, double to, int n) const {
    const double h = (to - from) / n;
    for (int i = 0; i < n; ++i) {
      const double t = from + i * h;
      const Point a = (*this)(p, rate(t)), b = (*this)(sum(p, h / 2, a), rate(t + h / 2)),
                  c = (*this)(sum(p, h / 2, b), rate(t + h / 2)), d = (*this)(sum(p, h, c), rate(t + h));
      p = sum(sum(sum(sum(p, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
  }
};

/// The states along the path.
struct Reference {
  std::vector<Point> states;  ///< at n + 1 equal times
  double drift = 0;           ///< from the yield surface, relative
  double least = 1;           ///< see RateEquations

  Reference(const Path& path, const Metal& metal, int n) {
    const RateEquations equations{metal};
    const double start = path.yields_at();
    Point p{};
    bool flows = false;
    states.push_back(p);
    for (int i = 0; i < n; ++i) {
      const double from = 2.0 * i / n, to = 2.0 * (i + 1) / n;
      const int leg = i >= n / 2;
      if (to > start) {
        if (!flows) p.s = 2 * g * path.strain(std::max(from, start));
        equations.advance(
            p, [&](double t) { return path.rate(t, leg); }, flows ? from : std::max(from, start), to, 40);
        flows = true;
        const double limit = std::sqrt(2.0 / 3) * (yield + metal.isotropic * p.eps);
        drift = std::max(drift, std::abs(magnitude(p.s - p.back) / limit - 1));
      } else {
        p.s = 2 * g * path.strain(to);
      }
      states.push_back(p);
    }
    least = equations.least;
  }
};

/// The displacement increment whose mid-point strain is `e`, without rotation.
inline Mat<double, 3> stretch(const Tensor& e) {
  Mat<double, 3> m{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = e(i, j);
  return m * inverse(Mat<double, 3>::identity() - 0.5 * m);
}

/// Largest |s - s_ref| on the way over the first yield radius, sqrt(2/3) Y.
template <class Strength>
double error(const Strength& strength, const Path& path, const Reference& reference, int steps) {
  Values<double, 3, union_of<typename Strength::particle_fields, fields<field::VolumeRatio>>> state{};
  get<field::VolumeRatio>(state) = 1;
  const std::size_t every = (reference.states.size() - 1) / std::size_t(steps);
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    const double from = 2.0 * i / steps, to = 2.0 * (i + 1) / steps;
    const Kinematics<double> k(stretch(path.strain(to) - path.strain(from)));
    strength.update(state, k);
    const Tensor& exact = reference.states[std::size_t(i + 1) * every].s;
    largest = std::max(largest, magnitude(get<field::DeviatoricStress>(state) - exact));
  }
  return largest / (std::sqrt(2.0 / 3) * yield);
}

}  // namespace strain_path
