/// \file
/// A piston: a wall seen from a moving frame, its balances, and the wave that it sends out.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <mote/exact/plane_wave.hpp>
#include <mote/mote.hpp>
#include <mote/observe/ledger.hpp>

#include "catch.hpp"
#include "unit/passes/schemes.hpp"

namespace {

using namespace schemes;
using Catch::Matchers::ContainsSubstring;

template <class Scheme, int D, class... Sides>
auto solver_with(double spacing, double dt, const Sides&... sides) {
  return Solver{grid::Cartesian<D>{.spacing = spacing},
                typename Scheme::Shape{},
                transfer_of<Scheme>(0.9),
                typename Scheme::Update{},
                timestep::Fixed{.dt = dt},
                aluminium,
                sides...};
}

/// Particles by number: their places along the axis and the rest of the state.
template <class S>
auto by_id(const S& solver) {
  std::map<std::uint32_t,
           Values<double, S::dimension, typename std::remove_cvref_t<decltype(solver.particles())>::list>>
      all;
  for (std::size_t i = 0; i < solver.size(); ++i)
    solver.particles().load(i, all[solver.particles().template column<field::Id>()[i]]);
  return all;
}

/// The same motion seen from the piston and from the metal at rest: states, impulse, work and losses.
template <class Scheme, class Pushed, class Launched>
void compare(Pushed& pushed, Launched& launched, int axis, double u, int steps) {
  constexpr int D = Pushed::dimension;
  pushed.refresh(), launched.refresh();
  const auto before = observe::ledger(pushed), start = observe::ledger(launched);
  for (int i = 0; i < steps; ++i) pushed.step(), launched.step();
  CHECK(pushed.sorts() > 2);
  const auto here = by_id(pushed), there = by_id(launched);
  for (const auto& [id, a] : here) {
    const auto& b = there.at(id);
    for (int c = 0; c < D; ++c) {
      const double shift = c == axis ? u : 0;
      REQUIRE(get<field::Velocity>(a)[c] == Approx(get<field::Velocity>(b)[c] + shift).margin(1e-7));
      REQUIRE(get<field::Position>(a)[c] ==
              Approx(get<field::Position>(b)[c] + shift * pushed.time()).margin(1e-8 * h).epsilon(1e-12));
    }
    REQUIRE(aluminium.pressure(a) == Approx(aluminium.pressure(b)).margin(10));
    REQUIRE(get<field::Temperature>(a) == Approx(get<field::Temperature>(b)).epsilon(1e-9));
  }
  const auto after = observe::ledger(pushed), end = observe::ledger(launched);
  const double j = after.wall_impulse[axis], mass = after.mass;
  CHECK(j == Approx(end.wall_impulse[axis]).epsilon(1e-9));
  for (int c = 0; c < D; ++c)
    CHECK(after.momentum[c] - before.momentum[c] == Approx(after.wall_impulse[c]).margin(1e-12 * mass * std::abs(u)));
  // energies: K = K' + u p' + m u^2/2, and all that u does goes through the piston
  CHECK(after.piston_work == Approx(u * j).epsilon(1e-9));
  CHECK(end.piston_work == 0);
  const double kinetic = 0.5 * mass * u * u, close = 1e-9 * kinetic;
  CHECK(after.kinetic - before.kinetic == Approx(end.kinetic - start.kinetic + after.piston_work).margin(close));
  CHECK(after.energy() - before.energy() == Approx(end.energy() - start.energy()).margin(close));
  CHECK(after.wall_loss == Approx(end.wall_loss).margin(close));
  CHECK(observe::transfer_loss(before, after) == Approx(observe::transfer_loss(start, end)).margin(close));
  CHECK(observe::transfer_loss(before, after) > 0);
}

template <class Scheme>
void compare_one_dimension() {
  for (const bool upper : {false, true})
    for (const double u : {200.0, -200.0}) {
      CAPTURE(upper, u);
      const Side side{0, upper};
      const geometry::Box<1> bar{.lower = {upper ? -30 * h : 0}, .upper = {upper ? 0 : 30 * h}};
      auto pushed = solver_with<Scheme, 1>(h, 4e-11, boundary::Piston{.side = side, .velocity = u});
      auto launched = solver_with<Scheme, 1>(h, 4e-11, boundary::RigidWall{.side = side});
      pushed.fill(bar, aluminium);
      launched.fill(bar, aluminium, {.velocity = Vec<double, 1>{-u}});
      compare<Scheme>(pushed, launched, 0, u, 600);  // the waves go to and fro, the piston goes 4.8 cells
    }
}

}  // namespace

TEMPLATE_TEST_CASE("piston: pushes and pulls metal at rest as a wall stops metal that flies", "[piston][boundary]",
                   schemes::LinearFlipMusl, schemes::QuadraticApicUsl, schemes::QuadraticAffineFlipUsl) {
  compare_one_dimension<TestType>();
}

TEST_CASE("piston: the same in three dimensions, beside symmetry planes and a period", "[piston][boundary]") {
  using Scheme = schemes::QuadraticFlipUsl;
  const boundary::Symmetry mirror{.side = side::x_min};
  const boundary::Periodic around{.axis = axis::y, .from = 0, .to = 5 * h};
  const auto block = geometry::Box<3>{.lower = {0, 0, 0}, .upper = {4 * h, 5 * h, 8 * h}} -
                     geometry::Ball<3>{.centre = {h, 2 * h, 2 * h}, .radius = 1.6 * h};
  auto pushed =
      solver_with<Scheme, 3>(h, 4e-11, mirror, around, boundary::Piston{.side = side::z_min, .velocity = 300});
  auto launched = solver_with<Scheme, 3>(h, 4e-11, mirror, around, boundary::RigidWall{.side = side::z_min});
  pushed.fill(block, aluminium);
  launched.fill(block, aluminium, {.velocity = {0, 0, -300}});
  compare<Scheme>(pushed, launched, 2, 300, 150);
}

namespace {

// a linear metal: small waves run with c and keep their shape
const Material linear{eos::LinearBulk{.rho0 = 2700, .bulk_modulus = 77e9}};
const double c = std::sqrt(77e9 / 2700);

/// A piston's gentle push, v = V sin^2(pi t/T), and the L2 error of the particles' ways against u(t - X/c) after 1.5 T,
/// over the piston's. (Ways, since velocities are those of the middle of the step, as with any leapfrog.)
template <class Scheme>
double push_error(double spacing) {
  const double push = 1e-3, period = 20e-6 / c, pi = 3.14159265358979323846;
  const auto way = [=](double t) {
    const double s = std::min(std::max(t, 0.0), period);
    return 0.5 * push * (s - period / (2 * pi) * std::sin(2 * pi * s / period));
  };
  const auto velocity = [=](double t) {
    return t < 0 || t > period ? 0 : push * std::pow(std::sin(pi * t / period), 2);
  };
  Solver solver{grid::Cartesian<1>{.spacing = spacing},
                typename Scheme::Shape{},
                typename Scheme::Transfer{},
                typename Scheme::Update{},
                timestep::Cfl{.courant = 0.2},
                boundary::Piston{.side = side::x_min, .velocity = velocity},
                linear};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {40e-6}}, linear);
  solver.refresh();
  const auto x = solver.particles().template column<field::Position>();
  const std::vector<double> place(x.begin(), x.end());
  const double end = 1.5 * period;
  while (solver.time() < end * (1 - 1e-12)) solver.step(end - solver.time());
  double sum = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const double e = solver.particles().template column<field::Position>()[i] - place[i] - way(end - place[i] / c);
    sum += e * e;
  }
  // the plane has gone where the integral of its velocity says
  CHECK(solver.frame().node_position(0, solver.domain().plane(0, 0)->node) ==
        Approx(0.5 * push * period).epsilon(1e-9));
  return std::sqrt(sum / double(place.size())) / way(period);
}

}  // namespace

TEST_CASE("piston: a smooth push sends out the exact wave, to the order of the scheme", "[piston][boundary]") {
  const double coarse = push_error<schemes::QuadraticFlipUsl>(0.5e-6),
               middle = push_error<schemes::QuadraticFlipUsl>(0.25e-6),
               fine = push_error<schemes::QuadraticFlipUsl>(0.125e-6);
  CAPTURE(coarse, middle, fine);
  CHECK(std::log2(coarse / middle) > 1.8);
  CHECK(std::log2(middle / fine) > 1.8);
  CHECK(fine < 5e-4);
}

TEST_CASE("piston: into metal at rest at 100 and 500 m/s, against the exact shock", "[piston][boundary]") {
  for (const double u : {100.0, 500.0}) {
    CAPTURE(u);
    const auto wave = exact::plane_wave(aluminium, -u);
    const double spacing = 0.25e-6, length = 50e-6;
    Solver solver{grid::Cartesian<1>{.spacing = spacing},
                  shape::QuadraticBSpline{},
                  transfer::Flip{.blend = 0.65},
                  timestep::Cfl{.courant = 0.4},
                  boundary::Piston{.side = side::x_min, .velocity = u},
                  aluminium};
    solver.fill(geometry::Box<1>{.lower = {0}, .upper = {length}}, aluminium);
    solver.refresh();
    const auto x = solver.particles().column<field::Position>();
    const std::vector<double> place(x.begin(), x.end());
    const double end = 40e-6 / wave.elastic_speed;
    while (solver.time() < end) solver.step(end - solver.time());
    double stress = 0, speed = 0;
    int n = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] < 0.3 * wave.plastic_speed * end || place[i] > 0.8 * wave.plastic_speed * end) continue;
      Values<double, 1, std::remove_cvref_t<decltype(solver.particles())>::list> state;
      solver.particles().load(i, state);
      stress += aluminium.stress(state)(0, 0), speed += get<field::Velocity>(state)[0], ++n;
    }
    CHECK(stress / n == Approx(wave.behind.stress).epsilon(0.005));
    CHECK(speed / n == Approx(u).epsilon(0.002));
    // force times time and times way, per m^2; all of the work is there as energy, but for what the scheme loses
    const auto ledger = observe::ledger(solver);
    CHECK(ledger.wall_impulse[0] == Approx(-wave.behind.stress * end).epsilon(0.02));
    CHECK(ledger.piston_work == Approx(u * ledger.wall_impulse[0]).epsilon(1e-12));
    CHECK(ledger.momentum[0] == Approx(ledger.wall_impulse[0]).epsilon(1e-11));
  }
}

TEST_CASE("piston: what it cannot serve is refused in one sentence", "[piston][boundary]") {
  const auto with = [](const auto&... sides) {
    Solver solver{
        grid::Cartesian<2>{.spacing = h}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, linear, sides...};
  };
  const boundary::Piston piston{.side = side::y_min, .velocity = 1};
  CHECK_NOTHROW(with(piston, boundary::Symmetry{.side = side::x_min}));
  CHECK_THROWS_WITH(with(piston, boundary::RigidWall{.side = side::y_max, .at = 9 * h}),
                    ContainsSubstring("axis y has a piston and another plane"));
  CHECK_THROWS_WITH(with(piston, boundary::RigidWall{.side = side::x_min}),
                    ContainsSubstring("take boundary::Symmetry beside a piston"));
  CHECK_THROWS_WITH(with(piston, boundary::Piston{.side = side::x_min, .velocity = 1}),
                    ContainsSubstring("two pistons"));
  CHECK_THROWS_WITH(with(piston, boundary::Periodic{.axis = 1, .from = 0, .to = h}), ContainsSubstring("is periodic"));
  CHECK_THROWS_WITH(with(boundary::Piston{.side = side::y_min, .at = 0.4 * h, .velocity = 1}),
                    ContainsSubstring("must lie on a grid node"));
  CHECK_THROWS_WITH(with(boundary::Piston{.side = side::y_min, .velocity = std::numeric_limits<double>::infinity()}),
                    ContainsSubstring("a piston's velocity is inf"));
  Solver solver{grid::Cartesian<1>{.spacing = h},
                shape::Linear{},
                transfer::Flip{},
                timestep::Fixed{.dt = 1e-11},
                linear,
                boundary::Piston{.side = side::x_min, .velocity = [](double t) { return t > 0 ? std::nan("") : 0; }}};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {3 * h}}, linear);
  CHECK_THROWS_WITH(solver.step(), ContainsSubstring("the piston's velocity is nan m/s at time"));
}
