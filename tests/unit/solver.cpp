/// \file
/// What a solver promises about motion, order and sorting.
#include <optional>

#include <mote/solver.hpp>

#include "catch.hpp"
#include "passes/schemes.hpp"

namespace {

using namespace schemes;

const timestep::Cfl cfl{.courant = 0.4};

template <int D>
geometry::Box<D> cube(double from, double to) {
  return {.lower = Vec<double, D>::filled(from * h), .upper = Vec<double, D>::filled(to * h)};
}

}  // namespace

namespace {

/// The largest stress on the way of a block that flies obliquely through 100 cells at 1 km/s, over the yield stress.
template <class Scheme, class... Sides>
double stress_in_flight(const Sides&... sides) {
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename Scheme::Shape{},
                typename Scheme::Transfer{},
                typename Scheme::Update{},
                cfl,
                aluminium,
                sides...};
  const Vec<double, 3> v{800, -480, 360};
  solver.fill(cube<3>(0, 3), aluminium, {.per_axis = 2, .velocity = v, .jitter = 0.3});
  double stress = 0;
  while (solver.time() * norm(v) < 100 * h) {
    solver.step();
    for (std::size_t p = 0; p < solver.size(); p += 7) {
      Aluminium::State<double> state;
      solver.particles().load(p, state);
      for (double s : aluminium.stress(state).c) stress = std::max(stress, std::abs(s));
    }
  }
  CHECK(solver.sorts() > 10);
  return stress / 120e6;
}

}  // namespace

TEMPLATE_TEST_CASE("a body in oblique flight at 1 km/s stays without stress between periodic sides", "[solver]",
                   MOTE_TEST_SCHEMES) {
  const auto side = [](int a) { return boundary::Periodic{.axis = a, .from = 0, .to = 3 * h}; };
  CHECK(stress_in_flight<TestType>(side(0), side(1), side(2)) < 1e-10);
}

TEMPLATE_TEST_CASE("a free body in oblique flight at 1 km/s stays without stress", "[solver]", schemes::LinearFlipMusl,
                   MOTE_TEST_QUADRATIC_SCHEMES, MOTE_TEST_CUBIC_SCHEMES) {
  CHECK(stress_in_flight<TestType>() < 1e-10);
}

/// The velocity gradient of hats at a node of tiny mass turns round-off into stress, and stress into velocity.
TEMPLATE_TEST_CASE("a known limit: linear hats at a free surface need FLIP and MUSL", "[solver][!shouldfail]",
                   schemes::LinearFlipUsl, schemes::LinearApicUsl, schemes::LinearApicMusl) {
  CHECK(stress_in_flight<TestType>() < 1e-10);
}

TEMPLATE_TEST_CASE("a body at rest on a wall stays there exactly", "[solver]", MOTE_TEST_SCHEMES) {
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename TestType::Shape{},
                typename TestType::Transfer{},
                typename TestType::Update{},
                cfl,
                boundary::RigidWall{.side = side::z_min, .at = 0},
                boundary::Symmetry{.side = side::x_max, .at = 3 * h},
                boundary::Periodic{.axis = axis::y, .from = 0, .to = 3 * h},
                aluminium};
  solver.fill(cube<3>(0, 3), aluminium, {.per_axis = 2, .jitter = 0.4});
  solver.refresh();
  const auto before = columns(solver);
  for (int i = 0; i < 20; ++i) solver.step();
  CHECK(columns(solver) == before);
}

TEST_CASE("what leaves a period comes in on the other side", "[solver]") {
  Solver solver{grid::Cartesian<2>{.spacing = h},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                cfl,
                boundary::Periodic{.axis = axis::x, .from = -2 * h, .to = 5 * h},
                boundary::Periodic{.axis = axis::y, .from = -h, .to = 2 * h},
                aluminium};
  const Vec<double, 2> v{2000, -3000};
  solver.fill(geometry::Box<2>{.lower = {-2 * h, -h}, .upper = {5 * h, 2 * h}}, aluminium,
              {.velocity = v, .jitter = 0.3});
  std::vector<Vec<double, 2>> start;
  for (std::size_t p = 0; p < solver.size(); ++p) start.push_back(solver.particles().get<field::Position>(p));
  while (solver.time() < 10e-9) solver.step();
  solver.refresh();
  for (std::size_t p = 0; p < solver.size(); ++p) {
    const auto x = solver.particles().get<field::Position>(p);
    const auto flown = x - start[solver.particles().column<field::Id>()[p]] - v * solver.time();
    CHECK((x[0] >= -2 * h && x[0] < 5 * h && x[1] >= -h && x[1] < 2 * h));
    CHECK(std::abs(std::remainder(flown[0], 7 * h)) < 1e-10 * h);
    CHECK(std::abs(std::remainder(flown[1], 3 * h)) < 1e-10 * h);
  }
}

TEST_CASE("a boundary may be optional: given, it acts as if it were not", "[solver][boundary]") {
  const auto run = [](const auto& wall) {
    Solver solver{grid::Cartesian<1>{.spacing = h}, shape::QuadraticBSpline{}, transfer::Apic{},
                  timestep::Fixed{.dt = 3e-11}, wall, aluminium};
    solver.fill(cube<1>(0, 6), aluminium, {.velocity = Vec<double, 1>{-100}});
    for (int i = 0; i < 20; ++i) solver.step();
    auto all = columns(solver);
    all.push_back(solver.ledger().impulse[0][0]);
    return all;
  };
  const boundary::RigidWall wall{.side = side::x_min, .at = 0};
  const auto with = run(wall), without = run(boundary::Symmetry{.side = side::x_max, .at = 90 * h});
  CHECK(run(std::optional(wall)) == with);
  CHECK(run(std::optional<boundary::RigidWall>{}) == without);
  CHECK(with != without);
  CHECK_THROWS_AS(run(std::optional(boundary::RigidWall{.side = side::x_min, .at = 0.5 * h})), InputError);
}

TEST_CASE("a sort keeps a particle's numbers together and puts blocks in order", "[solver]") {
  Solver solver{grid::Cartesian<3>{.spacing = h}, shape::Linear{}, transfer::Apic{}, timestep::Fixed{.dt = 1e-11},
                aluminium};
  solver.fill(cube<3>(-6, 6), aluminium, {.per_axis = 1});
  auto& particles = solver.particles();
  Random random;
  double next = 0;
  particles.for_each_column([&]<class Column>(Column& column) {
    using N = typename Column::value_type;
    if constexpr (std::is_same_v<N, double>)
      for (N& value : column) value = 1 + 1e-9 * next++;  // each number is another
  });
  for (int a = 0; a < 3; ++a)
    for (double& x : particles.column<field::Position>(a)) x = random(6 * h);
  const auto before = columns(solver);
  const std::size_t n = solver.size();
  solver.refresh();
  const auto after = columns(solver);
  const auto id = particles.column<field::Id>();
  std::size_t wrong = 0;
  for (std::size_t c = 0; c < after.size() / n; ++c)
    for (std::size_t p = 0; p < n; ++p) wrong += after[c * n + p] != before[c * n + id[p]];
  CHECK(wrong == 0);
  const auto block = [&](std::size_t p) {
    std::array<double, 3> b;
    for (int a = 0; a < 3; ++a)
      b[std::size_t(a)] = std::floor(std::floor(particles.column<field::Position>(a)[p] / h) / 4);
    return b;
  };
  for (std::size_t p = 1; p < n; ++p) wrong += block(p) < block(p - 1);
  CHECK(wrong == 0);
}

TEST_CASE("the order in which parts are given changes neither type nor result", "[solver]") {
  const grid::Cartesian<2> cells{.spacing = h};
  const boundary::RigidWall wall{.side = side::y_min, .at = 0};
  const boundary::Symmetry mirror{.side = side::x_min, .at = 0};
  const load::BodyForce<2> pull{{1e9, -1e9}};
  Solver one{cells,    shape::QuadraticBSpline{}, transfer::Flip{.blend = 0.9}, update::Musl{}, cfl, wall, mirror, pull,
             aluminium};
  Solver other{aluminium,
               wall,
               cfl,
               pull,
               update::Musl{},
               mirror,
               shape::QuadraticBSpline{},
               cells,
               transfer::Flip{.blend = 0.9}};
  STATIC_REQUIRE(std::is_same_v<decltype(one), decltype(other)>);
  for (auto* solver : {&one, &other}) {
    solver->fill(cube<2>(0, 4), aluminium, {.velocity = {30, -100}, .jitter = 0.2});
    for (int i = 0; i < 10; ++i) solver->step();
  }
  CHECK(columns(one) == columns(other));
}

TEST_CASE("an update that is not named is update stress last", "[solver]") {
  const grid::Cartesian<1> cells{.spacing = h};
  using Unnamed = decltype(Solver{cells, shape::Linear{}, transfer::Flip{}, cfl, aluminium});
  using Named =
      decltype(Solver{cells, shape::Linear{}, transfer::Flip{}, cfl, update::Usl{}, execution::Serial{}, aluminium});
  STATIC_REQUIRE(std::is_same_v<Unnamed, Named>);
}

TEST_CASE("a step is no longer than its limit, and a run ends at its time", "[solver]") {
  Solver solver{grid::Cartesian<1>{.spacing = h}, shape::Linear{}, transfer::Flip{}, timestep::Fixed{.dt = 1e-11},
                aluminium};
  solver.fill(cube<1>(0, 4), aluminium, {});
  CHECK(solver.step() == 1e-11);
  CHECK(solver.step(4e-12) == 4e-12);
  CHECK(solver.last_dt() == 4e-12);
  solver.run({.until = 1e-10});
  CHECK(solver.time() == 1e-10);
  CHECK_THROWS_AS(solver.run({.until = 1e-10}), InputError);
}

TEST_CASE("bodies of two materials meet on one grid", "[solver]") {
  const Material water{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2.2e9}};
  Solver solver{grid::Cartesian<2>{.spacing = h}, shape::QuadraticBSpline{}, transfer::Apic{}, cfl, aluminium, water};
  solver.fill(cube<2>(0, 3), aluminium, {.velocity = {200, 0}});
  solver.fill(geometry::Box<2>{.lower = {3 * h, 0}, .upper = {6 * h, 3 * h}}, water, {});
  for (int i = 0; i < 20; ++i) solver.step();
  double momentum = 0, gained = 0;
  solver.for_each_body([&](const auto& material, const auto& particles) {
    gained = 0;
    for (std::size_t p = 0; p < particles.size(); ++p)
      gained += particles.template column<field::Mass>()[p] * particles.template column<field::Velocity>()[p];
    momentum += gained;
    CHECK(particles.size() == 36);
    CHECK((material.rho0() == 2700 || material.rho0() == 1000));
  });
  CHECK(gained > 0.05 * momentum);  // the water's
  CHECK(momentum == Approx(2700 * 9 * h * h * 200).epsilon(1e-12));
  std::vector<std::uint32_t> ids;
  for (auto id : solver.particles<0>().column<field::Id>()) ids.push_back(id);
  for (auto id : solver.particles<1>().column<field::Id>()) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  for (std::uint32_t i = 0; i < ids.size(); ++i) CHECK(ids[i] == i);
}

TEST_CASE("a sort is due once disorder has cost as much as one", "[solver]") {
  const Material dust{eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1e-30}};
  const auto sorts_after = [&](double shear) {
    Solver solver{grid::Cartesian<3>{.spacing = 1}, shape::QuadraticBSpline{}, transfer::Apic{},
                  timestep::Fixed{.dt = 0.01}, dust};
    solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {4, 4, 4}}, dust,
                {.velocity =
                     [=](const Vec<double, 3>& x) {
                       return Vec<double, 3>{shear * x[1], 0, 0};
                     },
                 .jitter = 0.5});
    for (int i = 0; i < 90; ++i) solver.step();
    return solver.sorts();
  };
  CHECK(sorts_after(0) == 1);
  CHECK(sorts_after(0.25) > 1);  // nobody moves by a cell, but half of them change theirs
  CHECK(sorts_after(0.25) < 10);
}
