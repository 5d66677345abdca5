/// \file
/// Several bodies in one solver: told apart by type and numbers, on one grid, at no cost to a single one.
#include <cstring>
#include <mote/mote.hpp>

#include "catch.hpp"
#include "passes/schemes.hpp"

namespace {

using namespace schemes;
using Catch::Matchers::ContainsSubstring;

const Material copper{eos::MieGruneisen{.rho0 = 8930, .c0 = 3940, .lambda = 1.489, .gamma0 = 2.02},
                      strength::VonMises{.shear_modulus = 47.7e9, .yield = 120e6},
                      heat::Adiabatic{.specific_heat = 383, .initial_temperature = 300}};
const Material water{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2.2e9}};
static_assert(std::is_same_v<decltype(copper), decltype(aluminium)>);

const timestep::Cfl cfl{.courant = 0.4};

/// A ball of aluminium that flies into a block of another material in 3-D; 40 steps.
template <class Scheme, class M, class Executor>
auto collision(const M& block, const Executor& executor, std::vector<double>& momentum) {
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename Scheme::Shape{},
                typename Scheme::Transfer{},
                typename Scheme::Update{},
                cfl,
                executor,
                aluminium,
                block};
  solver.fill(geometry::Ball<3>{.centre = {0, 0, 4 * h}, .radius = 4 * h}, aluminium,
              {.velocity = {100, 50, -700}, .jitter = 0.2});
  solver.fill(geometry::Box<3>{.lower = {-6 * h, -6 * h, -4 * h}, .upper = {6 * h, 6 * h, 0}}, block);
  for (int i = 0; i <= 40; ++i) {
    const auto l = observe::ledger(solver);
    momentum.insert(momentum.end(), l.momentum.c, l.momentum.c + 3);
    if (i < 40) solver.step();
  }
  const auto& hit = solver.particles(block);
  double gained = 0;
  for (std::size_t p = 0; p < hit.size(); ++p)
    gained += hit.template column<field::Mass>()[p] * hit.template column<field::Velocity>(2)[p];
  CHECK(gained < 0.05 * momentum[2]);  // both point down
  return columns(solver);
}

template <class Scheme, class M>
void check_collision(const M& block) {
  std::vector<double> serial_momentum;
  const auto serial = collision<Scheme>(block, execution::Serial{}, serial_momentum);
  const std::size_t last = serial_momentum.size() - 3;
  const double size = std::abs(serial_momentum[2]);
  CHECK(size > 0);
  for (std::size_t a = 0; a < 3; ++a) CHECK(std::abs(serial_momentum[last + a] - serial_momentum[a]) < 1e-12 * size);
  for (int threads : {1, 2, 3}) {
    CAPTURE(threads);
    std::vector<double> momentum;
    CHECK(same_bits(collision<Scheme>(block, execution::Threads(threads), momentum), serial));
    CHECK(same_bits(momentum, serial_momentum));
  }
}

}  // namespace

TEST_CASE("two bodies of one type are found by their numbers", "[solver][bodies]") {
  Solver solver{grid::Cartesian<1>{.spacing = h}, shape::Linear{}, transfer::Flip{}, cfl, aluminium, copper};
  const auto put = [&](const auto& metal, double cells) {
    return solver.fill(geometry::Box<1>{.lower = {0}, .upper = {cells * h}}, metal);
  };
  CHECK(put(copper, 3) == 6);
  CHECK(put(aluminium, 5) == 10);
  CHECK(put(copper, 1) == 2);
  CHECK(solver.particles<0>().size() == 10);
  CHECK(solver.particles<1>().size() == 8);
  CHECK(&solver.particles(aluminium) == &solver.particles<0>());
  CHECK(&solver.particles(copper) == &solver.particles<1>());
  CHECK(&std::as_const(solver).particles(copper) == &std::as_const(solver).particles<1>());
  CHECK(solver.material<0>() == aluminium);
  CHECK(solver.material<1>() == copper);
  CHECK(solver.particles(aluminium).column<field::Mass>()[3] == Approx(2700 * h / 2).epsilon(1e-12));
  CHECK(solver.particles(copper).column<field::Mass>()[3] == Approx(8930 * h / 2).epsilon(1e-12));
  CHECK(decltype(solver)::bodies == 2);

  auto other = copper;
  other.heat.initial_temperature = 301;
  CHECK_THROWS_WITH(put(other, 1), ContainsSubstring("fill() was given a material with other numbers"));
  CHECK_THROWS_AS(put(other, 1), InputError);
  CHECK_THROWS_WITH(solver.particles(other), ContainsSubstring("particles() was given"));
  CHECK(solver.size() == 18);
}

TEST_CASE("a material given twice is refused", "[solver][bodies]") {
  const auto assemble = [](const auto&... materials) {
    Solver{grid::Cartesian<1>{.spacing = h}, shape::Linear{}, transfer::Flip{}, cfl, materials...};
  };
  CHECK_NOTHROW(assemble(aluminium, water, copper));
  CHECK_THROWS_AS(assemble(aluminium, aluminium), InputError);
  CHECK_THROWS_WITH(assemble(copper, water, aluminium, Material(aluminium)),
                    ContainsSubstring("materials 2 and 3 of the solver are equal"));
}

TEMPLATE_TEST_CASE("bodies that collide keep their momentum to round-off, for any number of threads the same",
                   "[solver][bodies]", schemes::QuadraticFlipUsl, schemes::QuadraticApicMusl, schemes::LinearFlipMusl) {
  SECTION("of one type") { check_collision<TestType>(copper); }
  SECTION("of two types") { check_collision<TestType>(water); }
}

TEMPLATE_TEST_CASE("a body without particles changes no bit of the other", "[solver][bodies]",
                   schemes::QuadraticApicUsl, schemes::LinearFlipMusl) {
  const auto run = [](const auto&... materials) {
    Solver solver{grid::Cartesian<3>{.spacing = h},
                  typename TestType::Shape{},
                  typename TestType::Transfer{},
                  typename TestType::Update{},
                  cfl,
                  boundary::RigidWall{.side = side::z_min, .at = 0},
                  materials...};
    solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {5 * h, 6 * h, 7 * h}}, aluminium,
                {.velocity = {1000, 50, -200}, .jitter = 0.3});
    observe::History history{.every = 1e-10};
    solver.run({.until = 2e-9}, history);
    auto all = columns(solver);
    for (const auto& s : history.samples)
      all.insert(all.end(), {s.v.min, s.v.low, s.v_grid.max, s.pressure.max, s.t_max, s.elastic});
    return all;
  };
  const auto alone = run(aluminium);
  CHECK(same_bits(run(aluminium, copper), alone));
  CHECK(same_bits(run(copper, aluminium), alone));
  CHECK(same_bits(run(water, aluminium), alone));
}

TEST_CASE("a body cut in two behaves as one", "[solver][bodies]") {
  auto twin = aluminium;
  twin.heat.initial_temperature = 400;  // which moves nothing
  std::vector<double> v[2];
  for (const bool cut : {false, true}) {
    Solver solver{grid::Cartesian<2>{.spacing = h},
                  shape::QuadraticBSpline{},
                  transfer::Apic{},
                  cfl,
                  boundary::RigidWall{.side = side::y_min, .at = 0},
                  aluminium,
                  twin};
    const auto put = [&](double from, double to, const auto& metal) {
      solver.fill(geometry::Box<2>{.lower = {from * h, 0}, .upper = {to * h, 5 * h}}, metal, {.velocity = {30, -400}});
    };
    put(0, 3, aluminium), put(3, 7, cut ? twin : aluminium);
    for (int i = 0; i < 60; ++i) solver.step();
    v[cut].resize(2 * solver.size());
    solver.for_each_body([&](const auto&, const auto& particles) {
      for (std::size_t p = 0; p < particles.size(); ++p)
        for (std::size_t a = 0; a < 2; ++a)
          v[cut][2 * particles.template column<field::Id>()[p] + a] =
              particles.template column<field::Velocity>(int(a))[p];
    });
  }
  for (std::size_t i = 0; i < v[0].size(); ++i) CHECK(std::abs(v[0][i] - v[1][i]) < 1e-9);
}

TEST_CASE("observers measure all bodies", "[solver][bodies]") {
  const Material foam{eos::LinearBulk{.rho0 = 100, .bulk_modulus = 1e8}};
  Solver solver{
      grid::Cartesian<1>{.spacing = h}, shape::QuadraticBSpline{}, transfer::Flip{}, cfl, copper, foam, water};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {10 * h}}, copper, {.velocity = {-20}});
  solver.fill(geometry::Box<1>{.lower = {20 * h}, .upper = {30 * h}}, foam, {.velocity = {30}});
  observe::History history{.every = 1e-10};
  observe::AxisProfile profile{.every = 1, .bin = 5 * h};
  solver.run({.until = 1e-10}, history, profile);
  const auto& s = history.samples.back();
  CHECK(s.v.min == Approx(-20));
  CHECK(s.v.max == Approx(30));
  CHECK(s.v_grid.min == Approx(-20));
  CHECK(s.v_grid.max == Approx(30));  // though foam's nodes have but a ninetieth of copper's mass
  CHECK(s.t_max == Approx(300));
  CHECK(s.mass == Approx((8930 + 100) * 10 * h).epsilon(1e-12));
  CHECK(s.momentum == Approx((8930 * -20 + 100 * 30) * 10 * h).epsilon(1e-12));
  CHECK(profile.bins.front().density == Approx(8930));
  CHECK(profile.bins.back().density == Approx(100));
  CHECK(profile.bins.front().temperature == Approx(300));
  CHECK(std::isnan(profile.bins.back().temperature));
}
