// The library in three dimensions against the spherical reference solver, which shares no code with it: a ball of
// aluminium with a cavity, whose outer half flies off and tears the cavity open, one octant between symmetry planes.
#include "reference/spherical.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include <mote/mote.hpp>

#include "catch.hpp"

namespace {

using namespace mote;

constexpr double um = 1e-6, inner = 5 * um, outer = 20 * um, until = 10e-9;
constexpr int samples = 20;

/// m/s outwards at the start: at rest to 10 um, then a smooth rise to 400 m/s at the outer surface.
double launch(double r) {
  const double t = std::clamp(r / (10 * um) - 1, 0.0, 1.0);
  return 400 * t * t * (3 - 2 * t);
}

reference::Shells shells() {
  reference::Ball ball{.metal = {2700, 5350, 1.34, 1.96, 69e9 / (2 * 1.33), 120e6, 384e6},
                       .inner = inner,
                       .outer = outer,
                       .shells = 200};
  ball.velocity = launch;
  return reference::Shells{ball};
}

/// Of the library against the reference, at samples from until/samples to `until`.
struct Comparison {
  double first_swing = 0, worst = 0;  ///< largest |relative error| of the cavity's radius to 6 ns; to the end
  double mean = 0;                    ///< root of the mean square of it, to the end
  double last = 0;                    ///< signed, at the end
  double body = 0;                    ///< root mean square over mass of the error of r at the end, m
  double largest = 0;                 ///< radius of the cavity, m
};

template <class Solver>
double cavity_radius(observe::VoidComponent& cavity, const Solver& solver) {
  const auto& p = solver.particles();
  const auto x = [&](int a) { return p.template column<field::Position>(a); };
  const observe::ParticleColumns<double> columns{
      x(0), x(1), x(2), p.template column<field::Mass>(), p.template column<field::VolumeRatio>(), 1 / 2700.0};
  return std::cbrt(cavity.measure(columns).volume * 3 / (4 * std::numbers::pi));
}

/// Quadratic AffineFlip, volume-fraction fill, 2 particles per cell and axis.
Comparison compare(double h, bool print) {
  const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                           strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6}};
  Solver solver{grid::Cartesian<3>{.spacing = h},
                shape::QuadraticBSpline{},
                transfer::AffineFlip{},
                timestep::Cfl{.courant = 0.4},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                boundary::Symmetry{.side = side::y_min, .at = 0},
                boundary::Symmetry{.side = side::z_min, .at = 0},
                aluminium};
  const geometry::Ball<3> ball{.centre = {0, 0, 0}, .radius = outer}, cavity{.centre = {0, 0, 0}, .radius = inner};
  const auto velocity = [](const Vec<double, 3>& x) { return x * (launch(norm(x)) / norm(x)); };
  solver.fill(ball - cavity, aluminium, {.per_axis = 2, .velocity = velocity, .method = geometry::Method::fraction});
  auto& p = solver.particles();
  std::vector<double> start(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) start[p.column<field::Id>()[i]] = norm(p.get<field::Position>(i));

  const observe::Extent half{.from = 0, .to = outer, .lower = observe::Extent::plane, .mirrored = true};
  observe::VoidComponent hole{h, {half, half, half}, Vec<double, 3>{0, 0, 0}};
  reference::Shells exact = shells();
  CHECK(cavity_radius(hole, solver) == Approx(inner).epsilon(1e-4));
  Comparison c;
  for (int i = 1; i <= samples; ++i) {
    const double t = until * i / samples;
    solver.run({.until = t});
    exact.advance(t);
    const double radius = cavity_radius(hole, solver), error = radius / exact.radius() - 1;
    if (t < 6.1e-9) c.first_swing = std::max(c.first_swing, std::abs(error));
    c.worst = std::max(c.worst, std::abs(error));
    c.mean += error * error / samples;
    c.last = error;
    c.largest = std::max(c.largest, radius);
    if (print) std::printf("%g,%g,%.5f,%.5f\n", h / um, t * 1e9, radius / um, exact.radius() / um);
  }
  c.mean = std::sqrt(c.mean);
  double mass = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double m = p.column<field::Mass>()[i];
    const double error = norm(p.get<field::Position>(i)) - exact.place(start[p.column<field::Id>()[i]]);
    c.body += m * error * error;
    mass += m;
  }
  c.body = std::sqrt(c.body / mass);
  UNSCOPED_INFO("h " << h / um << " um: to 6 ns " << c.first_swing << ", to the end " << c.worst << ", mean " << c.mean
                     << ", last " << c.last << ", body " << c.body / um << " um");
  return c;
}

TEST_CASE("the cavity in a ball grows as the spherical reference has it") {
  const Comparison coarse = compare(2 * um, false), fine = compare(1 * um, false);
  CHECK(fine.largest > 1.5 * inner);
  // the project's bar is 1% on a converging sequence
  CHECK(fine.first_swing < 0.01);
  CHECK(fine.mean < 0.005);
  CHECK(fine.worst < 0.01);
  CHECK(std::abs(fine.last) < 0.005);
  CHECK(fine.body < 0.01 * um);
  // of second order or better
  CHECK(fine.worst < 0.25 * coarse.worst);
  CHECK(fine.mean < 0.25 * coarse.mean);
}

// Prints what docs/verification.md and tests/reference/plot_spherical.py show:
//   mote_studies "[spherical-table]" | grep -E '^[0-9.]+,' > spherical.csv
TEST_CASE("the cavity in a ball converges to the spherical reference", "[slow][spherical-table]") {
  reference::Shells exact = shells();
  for (int i = 0; i <= 10 * samples; ++i) {
    exact.advance(until * i / (10 * samples));
    const double t = 1e9 * exact.time(), radius = exact.radius() / um;
    std::printf("0,%g,%.5f,%.5f\n", t, radius, radius);
  }
  const Comparison coarse = compare(1.25 * um, true), middle = compare(1 * um, true), fine = compare(0.5 * um, true);
  CHECK(fine.worst < 0.01);
  CHECK(fine.worst < 0.45 * middle.worst);
  CHECK(middle.worst < 0.75 * coarse.worst);
  CHECK(fine.mean < 0.5 * middle.mean);
  CHECK(fine.body < 0.7 * middle.body);
}

}  // namespace
