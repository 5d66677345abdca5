/// \file
/// Affine FLIP: the books of its sharpened change of velocity, what order one is, and the affine field that fill() sets.
#include <cmath>
#include <limits>
#include <vector>

#include <mote/mote.hpp>
#include <mote/observe/ledger.hpp>

#include "../passes/schemes.hpp"
#include "catch.hpp"

namespace {

using namespace schemes;

const double sound = 6437;  // m/s

/// A bar on a wall swings for ten cells' time. \return energy error and what the grid knows to be lost, as parts of the
/// kinetic energy at the start
std::pair<double, double> energy_and_loss(int order, double courant) {
  Solver solver{grid::Cartesian<1>{.spacing = h},
                shape::QuadraticBSpline{},
                transfer::AffineFlip{.order = order},
                timestep::Fixed{.dt = courant * h / sound},
                boundary::RigidWall{.side = side::x_min},
                aluminium};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {16 * h}}, aluminium,
              {.velocity = [](const Vec<double, 1>& x) { return Vec<double, 1>{10 * std::sin(0.4 * x[0] / h)}; }});
  solver.refresh();
  const auto before = observe::ledger(solver);
  solver.run({.until = 10 * h / sound});
  const auto after = observe::ledger(solver);
  return {observe::energy_error(before, after), observe::transfer_loss(before, after) / before.kinetic};
}

struct AfterAStep {
  grid::Blocks<double, 2> nodes;
  double work;
  std::vector<double> velocity;  ///< of the particles
};

/// A free block with noise in all it has, after one step.
template <class X>
AfterAStep after_a_step(const X& transfer) {
  Solver solver{grid::Cartesian<2>{.spacing = h},
                shape::QuadraticBSpline{},
                transfer,
                timestep::Fixed{.dt = 1e-11},
                aluminium};
  solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {5 * h, 4 * h}}, aluminium);
  auto& particles = solver.particles();
  Random random;
  shake<field::Position>(particles, 2, 0.1 * h, random);
  shake<field::Velocity>(particles, 2, 10, random);
  shake<field::VolumeRatio>(particles, 1, 1e-3, random);
  solver.step();
  std::vector<double> v;
  for (int a = 0; a < 2; ++a)
    for (const double x : particles.template column<field::Velocity>(a)) v.push_back(x);
  return {solver.nodes(), solver.ledger().work, v};
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace

/// What the books do not close by falls with the step: strain and force are of different times in it.
TEST_CASE("affine FLIP: energies and known losses close as the step shrinks, at any order", "[transfer][energy]") {
  for (const int order : {1, 2, 3}) {
    const auto [coarse_error, coarse_loss] = energy_and_loss(order, 0.1);
    const auto [error, loss] = energy_and_loss(order, 0.0125);
    CAPTURE(order, coarse_error, coarse_loss, error, loss);
    CHECK(loss > 0.05);
    CHECK(std::abs(error + loss) < 0.02 * loss);
    CHECK(std::abs(error + loss) < 0.3 * std::abs(coarse_error + coarse_loss));
  }
}

TEST_CASE("affine FLIP: of order one, without an affine field yet, it is FLIP", "[transfer]") {
  const auto flip = after_a_step(transfer::Flip{.blend = 0.9}).velocity;
  CHECK(apart(after_a_step(transfer::AffineFlip{.blend = 0.9, .order = 1}).velocity, flip) < 1e-12 * 10);
  CHECK(apart(after_a_step(transfer::AffineFlip{.blend = 0.9, .order = 2}).velocity, flip) > 1e-3 * 10);
}

/// Forces f for a time dt do the work sum f dt (v_before + v_after)/2; f dt is what order one, which does not sharpen,
/// makes of the momentum.
TEST_CASE("affine FLIP: the work of a step is that of its forces on the sharpened motion", "[transfer][energy]") {
  const auto plain = after_a_step(transfer::AffineFlip{.order = 1});
  for (const int order : {1, 2, 3, 4, 5}) {
    const auto sharp = after_a_step(transfer::AffineFlip{.order = order});
    double work = 0, by_sharpening = 0;
    for (std::size_t i = 0; i < plain.nodes.mass.size(); ++i)
      for (int a = 0; a < 2; ++a) {
        const double m = plain.nodes.mass[i], before = plain.nodes.previous[grid::node_width<2> * i + a],
                     lumped = plain.nodes.velocity[grid::node_width<2> * i + a],
                     after = sharp.nodes.velocity[grid::node_width<2> * i + a];
        work += 0.5 * m * (lumped - before) * (before + after);
        by_sharpening += 0.5 * m * (lumped - before) * (after - lumped);
      }
    CAPTURE(order, work, by_sharpening);
    CHECK(sharp.work == Approx(work).epsilon(1e-12));
    CHECK((order == 1 || by_sharpening > 1e-3 * std::abs(work)));
  }
}

TEST_CASE("fill() gives the affine field the gradient of the velocity", "[solver][transfer]") {
  Solver solver{grid::Cartesian<2>{.spacing = h}, shape::QuadraticBSpline{}, transfer::AffineFlip{},
                timestep::Fixed{.dt = 1e-12}, aluminium};
  const auto shear_and_spin = [](const Vec<double, 2>& x) {
    return Vec<double, 2>{3 + 2e6 * x[0] - 5e6 * x[1], 1e6 * x[0] + 4e12 * x[1] * x[1]};
  };
  const std::size_t n = solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {3 * h, 2 * h}}, aluminium,
                                    {.velocity = shear_and_spin});
  solver.fill(geometry::Box<2>{.lower = {4 * h, 0}, .upper = {5 * h, 2 * h}}, aluminium, {.velocity = {300, -20}});
  const auto& particles = solver.particles();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const auto C = particles.get<field::Affine>(p);
    const double y = particles.get<field::Position>(p)[1];
    const double expected[2][2] = {{2e6, -5e6}, {1e6, 8e12 * y}};
    for (int i = 0; i < 2; ++i)
      for (int a = 0; a < 2; ++a) {
        if (p < n)
          CHECK(C(i, a) == Approx(expected[i][a]).epsilon(1e-9));
        else
          CHECK(C(i, a) == 0);
      }
  }
}
