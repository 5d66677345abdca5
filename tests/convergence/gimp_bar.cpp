/// \file
/// The manufactured bar of Steffen et al. (2008) with contiguous GIMP: u = A sin(2 pi X) cos(C pi t) on 0 < X < 1, both
/// ends fixed, P = (E/2) (F - 1/F), C^2 = E/rho0. Amplitude 0.05 stretches particles by up to 31%, and moves them
/// through up to 13 cells on the finest mesh.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <mote/mote.hpp>

#include "catch.hpp"

namespace {

using namespace mote;
using std::numbers::pi;

constexpr double E = 1e4, rho0 = 1, C = 100;  // Pa, kg/m^3, m/s

/// In uniaxial strain F is J, and the first Piola stress is the Cauchy stress: P = (E/2) (1/J - J) as a pressure.
struct NeoHookean {
  using role = role::Eos;
  double rho0;  // kg/m^3

  template <class T>
  T pressure(const T& x, const T&) const {
    return T(0.5 * E) * (T(1) / x - x);
  }
  template <class T>
  T bulk_sound_speed2(const T& x, const T&) const {  // -(x^2/rho0) dp/dx
    return T(0.5 * E / rho0) * (T(1) + x * x);
  }
  template <class T>
  T reference_energy(const T& x) const {  // -1/rho0 int p dx
    using std::log;
    return T(0.5 * E / rho0) * (T(0.5) * (x * x - T(1)) - log(x));
  }
  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  double gamma_over_volume() const { return 0; }
  template <class T>
  auto admissible(const T& x) const {
    return x > T(0);
  }
};

/// The motion that the body force makes.
struct Motion {
  double amplitude;

  double displacement(double X, double t) const { return amplitude * std::sin(2 * pi * X) * std::cos(C * pi * t); }
  double velocity(double X, double t) const {
    return -C * pi * amplitude * std::sin(2 * pi * X) * std::sin(C * pi * t);
  }
  double stretch(double X, double t) const {
    return 1 + 2 * pi * amplitude * std::cos(2 * pi * X) * std::cos(C * pi * t);
  }
  /// rho0 u'' = dP/dX + rho0 b, with dP/dX = (E/2) (1 + 1/F^2) dF/dX and dF/dX = -4 pi^2 u.
  double body_force(double X, double t) const {
    const double F = stretch(X, t);
    return C * C * pi * pi * displacement(X, t) * (1 + 2 / (F * F));
  }
};

/// The body force as in the publication, where particles bring it to the nodes: sum w m b / sum w m. It is smoothed as
/// often as the stress then. A function of place at the nodes, as load::BodyForce is meant, is smoothed once less; the
/// order is the same, the error 1.9 times as large (1.84e-4 at n = 256).
template <class Shape>
class BroughtForce {
  double spacing_;
  std::vector<double> impulse_, mass_;

 public:
  BroughtForce(double spacing, int cells)
      : spacing_(spacing), impulse_(std::size_t(cells + 5)), mass_(std::size_t(cells + 5)) {}

  /// \param b(i) the acceleration of particle i
  template <class P, class B>
  void set(const P& p, const B& b) {
    std::fill(impulse_.begin(), impulse_.end(), 0.0);
    std::fill(mass_.begin(), mass_.end(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double xi = p.template column<field::Position>()[i] / spacing_, base = std::floor(xi - Shape::first);
      const double m = p.template column<field::Mass>()[i];
      double w[Shape::support];
      if constexpr (sized<Shape>)
        Shape::values(xi - base, p.template column<field::HalfSize>()[i] / spacing_, w);
      else
        Shape::values(xi - base, w);
      for (int k = 0; k < Shape::support; ++k) {
        const auto node = std::size_t(base + k + 2);
        mass_[node] += w[k] * m, impulse_[node] += w[k] * m * b(i);
      }
    }
  }
  double at(double x) const {
    const auto node = std::size_t(std::lround(x / spacing_) + 2);
    return mass_[node] > 0 ? impulse_[node] / mass_[node] : 0;
  }
};

/// The largest RMS error of the particles' places over time, over the amplitude.
template <class Shape>
double error(const Motion& motion, int cells) {
  BroughtForce<Shape> force(1.0 / cells, cells);
  const double h = 1.0 / cells, dt = 0.1 * h / C, end = 2 / C;
  const Material rubber{NeoHookean{.rho0 = rho0}};
  Solver solver{grid::Cartesian<1>{.spacing = h},
                Shape{},
                transfer::Flip{},
                timestep::Fixed{.dt = dt},
                boundary::RigidWall{.side = side::x_min, .at = 0},
                boundary::RigidWall{.side = side::x_max, .at = 1},
                load::BodyForce<1>{{[&](const Vec<double, 1>& x, double) { return Vec<double, 1>{force.at(x[0])}; }}},
                rubber};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1}}, rubber, {.per_axis = 2});
  auto& p = solver.particles();
  const auto x = p.template column<field::Position>(), v = p.template column<field::Velocity>(),
             J = p.template column<field::VolumeRatio>();
  const auto id = p.template column<field::Id>();
  std::vector<double> X(x.begin(), x.end());
  for (std::size_t i = 0; i < p.size(); ++i) {
    x[i] += motion.displacement(X[i], 0);
    v[i] = motion.velocity(X[i], -0.5 * dt);  // velocities belong to the middle of steps: v += dt a(x), x += dt v
    J[i] = motion.stretch(X[i], 0);
    if constexpr (sized<Shape>) p.template column<field::HalfSize>()[i] *= J[i];
  }
  solver.refresh();
  double worst = 0;
  while (solver.time() < end * (1 - 1e-9)) {
    force.set(p, [&](std::size_t i) { return motion.body_force(X[id[i]], solver.time()); });
    solver.step();
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double e = x[i] - X[id[i]] - motion.displacement(X[id[i]], solver.time());
      sum += e * e;
    }
    const double rms = std::sqrt(sum / double(p.size())) / motion.amplitude;
    if (!(rms <= worst)) worst = rms;
  }
  return worst;
}

}  // namespace

TEST_CASE("bar of Steffen et al.: contiguous GIMP with USL is of order 2 at large deformation", "[convergence][gimp]") {
  const std::vector<int> cells{32, 64, 128, 256};
  // what an independent small program gives for the same scheme; it has other walls
  const std::vector<double> independent{6.5e-3, 1.6e-3, 3.9e-4, 9.7e-5};
  std::vector<double> errors;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    errors.push_back(error<shape::ContiguousGimp>({0.05}, cells[i]));
    CAPTURE(cells[i], errors[i]);
    CHECK(errors[i] == Approx(independent[i]).epsilon(0.05));
    if (i > 0) CHECK(std::log2(errors[i - 1] / errors[i]) > 1.8);
  }
  CHECK(errors.back() < 1.5e-4);
}

TEST_CASE("bar of Steffen et al.: uniform GIMP is of order 2 while particles keep their size", "[convergence][gimp]") {
  const double coarse = error<shape::Gimp>({1e-4}, 32), middle = error<shape::Gimp>({1e-4}, 64),
               fine = error<shape::Gimp>({1e-4}, 128);
  CAPTURE(coarse, middle, fine);
  CHECK(std::log2(coarse / middle) == Approx(2).margin(0.2));
  CHECK(std::log2(middle / fine) == Approx(2).margin(0.2));
  CHECK(error<shape::ContiguousGimp>({1e-4}, 128) == Approx(fine).epsilon(0.02));  // the same to first order
}

TEST_CASE("bar of Steffen et al.: uniform GIMP does not converge at large deformation", "[convergence][gimp]") {
  const double coarse = error<shape::Gimp>({0.05}, 32), fine = error<shape::Gimp>({0.05}, 128);
  CAPTURE(coarse, fine);
  CHECK(fine > coarse);  // so take ContiguousGimp
}
