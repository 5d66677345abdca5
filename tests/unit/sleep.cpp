/// \file
/// Sleep changes nothing that one sees: what sleeps moves exactly, wakes before anything reaches it, and is shown where
/// it is.
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <mote/mote.hpp>

#include "catch.hpp"
#include "passes/schemes.hpp"

namespace {

using namespace schemes;
using Catch::Matchers::ContainsSubstring;

constexpr double tolerance = sleep::Quiescent{}.tolerance;
const timestep::Cfl cfl{.courant = 0.4};
const Material copper{eos::MieGruneisen{.rho0 = 8930, .c0 = 3940, .lambda = 1.489, .gamma0 = 2.02},
                      strength::VonMises{.shear_modulus = 47.7e9, .yield = 120e6},
                      heat::Adiabatic{.specific_heat = 383, .initial_temperature = 300}};

template <class Scheme, class Sleep, class... Parts>
auto solver_with(const Sleep& sleep, const Parts&... parts) {
  return Solver{grid::Cartesian<3>{.spacing = h},
                typename Scheme::Shape{},
                typename Scheme::Transfer{},
                typename Scheme::Update{},
                cfl,
                sleep,
                aluminium,
                parts...};
}

/// A field of all particles of body I by their Id.
template <class Tag, int I = 0, class S>
auto by_id(const S& solver) {
  const auto& p = solver.template particles<I>();
  std::map<std::uint32_t, Vec<double, 3>> all;
  for (std::size_t i = 0; i < p.size(); ++i)
    all[p.template column<field::Id>()[i]] = cast<double>(p.template get<Tag>(i));
  return all;
}

double largest_difference(const std::map<std::uint32_t, Vec<double, 3>>& a,
                          const std::map<std::uint32_t, Vec<double, 3>>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (const auto& [id, v] : a)
    for (int c = 0; c < 3; ++c) {
      const double d = std::abs(v[c] - b.at(id)[c]);
      if (!(d <= most)) most = d;
    }
  return most;
}

template <class S>
std::vector<double> numbers(S& solver) {
  auto all = columns(solver);
  all.insert(all.end(), {solver.time(), solver.ledger().work, solver.active_fraction()});
  return all;
}

/// The cavity scene, coarse.
template <class Scheme, class Sleep, class... Parts>
auto cavity_scene(const Sleep& sleep, const Parts&... parts) {
  const double w = 8 * h;
  return solver_with<Scheme>(
      sleep, boundary::Symmetry{.side = side::x_min, .at = 0}, boundary::Symmetry{.side = side::x_max, .at = w},
      boundary::Symmetry{.side = side::y_min, .at = 0}, boundary::Symmetry{.side = side::y_max, .at = w},
      boundary::RigidWall{.side = side::z_min, .at = 0}, parts...);
}
template <class S>
void fill_cavity_scene(S& solver, double speed = 100) {
  const geometry::Box<3> block{.lower = {-8 * h, -8 * h, 0}, .upper = {8 * h, 8 * h, 36 * h}};
  solver.fill(block - geometry::Ball<3>{.centre = {0, 0, 8 * h}, .radius = 4 * h}, aluminium,
              {.velocity = {0, 0, speed}, .method = geometry::Method::fraction});
}

}  // namespace

TEST_CASE("sleep: a free body sleeps wholly and moves by v t, through periods and sorts", "[sleep]") {
  auto solver =
      solver_with<QuadraticApicUsl>(sleep::Quiescent{}, boundary::Periodic{.axis = 0, .from = 0, .to = 12 * h});
  const Vec<double, 3> v{3000, -2000, 100};
  solver.fill(geometry::Ball<3>{.centre = {6 * h, 0, 0}, .radius = 4 * h}, aluminium, {.velocity = v});
  const auto before = by_id<field::Position>(solver);
  double slept = 1;
  for (int i = 0; i < 200; ++i) {
    solver.step();
    slept = std::min(slept, 1 - solver.active_fraction());
  }
  CHECK(slept == 1);
  CHECK(solver.sorts() > 5);
  CHECK(solver.time() * v[0] > 20 * h);
  CHECK(largest_difference(by_id<field::Velocity>(solver), [&] {
          auto all = before;
          for (auto& [id, u] : all) u = v;
          return all;
        }()) == 0);
  for (const auto& [id, x] : by_id<field::Position>(solver)) {
    Vec<double, 3> off = x - before.at(id) - solver.time() * v;
    off[0] -= 12 * h * std::round(off[0] / (12 * h));
    REQUIRE(norm(off) < 1e-12 * norm(solver.time() * v));
  }
}

TEST_CASE("sleep: a body at rest on a wall sleeps, a moving one does not there", "[sleep]") {
  for (const double speed : {0.0, 100.0}) {
    auto solver = cavity_scene<QuadraticApicUsl>(sleep::Quiescent{});
    fill_cavity_scene(solver, speed);
    solver.step();
    if (speed == 0) {
      CHECK(solver.active_fraction() == 0);
    } else {
      CHECK(solver.active_fraction() > 0.05);
      CHECK(solver.active_fraction() < 0.5);
    }
  }
}

/// A body that slides along a symmetry plane sleeps; away from it or along a rigid wall it does not.
TEST_CASE("sleep: a plane wakes what it would turn", "[sleep]") {
  const auto first_step = [](const auto& plane, const Vec<double, 3>& v) {
    auto solver = solver_with<QuadraticApicUsl>(sleep::Quiescent{}, plane);
    solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {4 * h, 4 * h, 4 * h}}, aluminium, {.velocity = v});
    solver.step();
    return solver.active_fraction();
  };
  const boundary::Symmetry mirror{.side = side::z_min, .at = 0};
  const boundary::RigidWall wall{.side = side::z_min, .at = 0};
  CHECK(first_step(mirror, {100, 50, 0}) == 0);
  CHECK(first_step(mirror, {0, 0, 100}) > 0);
  CHECK(first_step(wall, {0, 0, 0}) == 0);
  CHECK(first_step(wall, {100, 0, 0}) > 0);
  CHECK(first_step(wall, {0, 0, 100}) > 0);
}

TEMPLATE_TEST_CASE("sleep: every particle moves as it does without, step by step", "[sleep]", schemes::QuadraticApicUsl,
                   schemes::LinearFlipMusl, schemes::CubicFlipMusl, schemes::QuadraticFlipUsl) {
  auto sleeping = cavity_scene<TestType>(sleep::Quiescent{});
  auto never = cavity_scene<TestType>(sleep::Never{});
  fill_cavity_scene(sleeping);
  fill_cavity_scene(never);
  double least = 1, most = 0;
  for (int i = 0; i < 80; ++i) {
    sleeping.step();
    never.step();
    CAPTURE(i, sleeping.active_fraction());
    least = std::min(least, sleeping.active_fraction()), most = std::max(most, sleeping.active_fraction());
    REQUIRE(largest_difference(by_id<field::Velocity>(sleeping), by_id<field::Velocity>(never)) <
            100 * tolerance * 6400);
    REQUIRE(largest_difference(by_id<field::Position>(sleeping), by_id<field::Position>(never)) <
            100 * tolerance * 6400 * never.time());
  }
  CHECK(least < 0.5);
  CHECK(most > 0.9);
}

/// Two blocks that sleep, one in flight to the other.
TEST_CASE("sleep: bodies of different velocity wake before they meet", "[sleep]") {
  const auto run = [](const auto& sleep, const auto& look) {
    auto solver = solver_with<QuadraticApicUsl>(sleep, copper);
    solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {6 * h, 6 * h, 8 * h}}, aluminium,
                {.velocity = {0, 0, -500}});
    solver.fill(geometry::Box<3>{.lower = {0, 0, -20 * h}, .upper = {6 * h, 6 * h, -9.5 * h}}, copper);
    for (int i = 0; i < 400; ++i) {
      solver.step();
      look(solver);
    }
    return std::pair{by_id<field::Velocity, 0>(solver), by_id<field::Velocity, 1>(solver)};
  };
  double least = 1, most = 0;
  const auto sleeping = run(sleep::Quiescent{}, [&](const auto& solver) {
    least = std::min(least, solver.active_fraction()), most = std::max(most, solver.active_fraction());
  });
  const auto never = run(sleep::Never{}, [](const auto& solver) { CHECK(solver.active_fraction() == 1); });
  CHECK(least == 0);
  CHECK(most > 0.9);
  double fastest = 0;
  for (const auto& [id, v] : never.second) fastest = std::max(fastest, std::abs(v[2]));
  CHECK(fastest > 50);  // they met
  CHECK(largest_difference(sleeping.first, never.first) < 100 * tolerance * 6400);
  CHECK(largest_difference(sleeping.second, never.second) < 100 * tolerance * 6400);
}

namespace {

std::vector<double> columns_of(const observe::Sample& s) {
  std::vector<double> c{s.v.min,         s.v.max,        s.v.low, s.v.high,   s.v_grid.min,  s.v_grid.max,
                        s.pressure.min,  s.pressure.max, s.t_max, s.kinetic,  s.elastic,     s.plastic,
                        s.transfer_loss, s.wall_loss,    s.mass,  s.momentum, s.wall_impulse};
  return c;
}

}  // namespace

TEST_CASE("sleep: a history with sleep is that without", "[sleep]") {
  const auto history = [](const auto& sleep) {
    auto solver = cavity_scene<QuadraticApicUsl>(sleep);
    fill_cavity_scene(solver);
    const auto samples = std::make_unique<observe::History>();  // on the heap: g++ 12 gives a false alarm
    samples->every = 0.1e-9, samples->copies = 4, samples->volume = 1e-16;
    solver.run({.until = 6e-9}, *samples);
    return samples->samples;
  };
  const auto with = history(sleep::Quiescent{}), without = history(sleep::Never{}),
             off = history(sleep::Quiescent{.enabled = false});
  REQUIRE(with.size() == without.size());
  CHECK(with.front().active_fraction == 1);
  CHECK(with[1].active_fraction < 0.5);
  CHECK(with.back().active_fraction > 0.9);
  const std::size_t columns = columns_of(with[0]).size();
  for (std::size_t c = 0; c < columns; ++c) {
    double size = 0, apart = 0;
    for (std::size_t i = 1; i < with.size(); ++i) {
      const double a = columns_of(with[i])[c], b = columns_of(without[i])[c];
      CHECK(columns_of(off[i])[c] == b);
      size = std::max(size, std::abs(b));
      if (!(std::abs(a - b) <= apart)) apart = std::abs(a - b);
    }
    CAPTURE(c);
    CHECK(apart <= 1e-9 * size);
  }
}

TEST_CASE("sleep: any number of threads gives the same bits", "[sleep][execution]") {
  const auto run = [](const auto& executor) {
    auto solver = cavity_scene<QuadraticApicUsl>(sleep::Quiescent{}, executor);
    fill_cavity_scene(solver, 2000);
    solver.run({.until = 1, .max_steps = 60});
    CHECK(solver.sorts() > 1);
    CHECK(solver.active_fraction() < 1);
    return numbers(solver);
  };
  const auto serial = run(execution::Serial{});
  for (int threads : {1, 2, 3}) {
    CAPTURE(threads);
    CHECK(same_bits(run(execution::Threads(threads)), serial));
  }
}

namespace {

/// Looks at a particle of a body in flight at its times, or at each step.
struct Watch {
  double speed, every = std::numeric_limits<double>::infinity(), next = 0, worst = 0;
  std::map<std::uint32_t, Vec<double, 3>> first = {};
  int looks = 0;

  template <class S, class R>
  void begin(const S& solver, const R&) {
    first = by_id<field::Position>(solver);
    next = every;
  }
  double due() const { return next; }
  template <class S>
  void observe(const S& solver) {
    if (every < 1 && solver.time() < next) return;
    next += every;
    look(solver);
  }
  template <class S>
  void end(const S& solver) {
    look(solver);
  }
  template <class S>
  void look(const S& solver) {
    ++looks;
    for (const auto& [id, x] : by_id<field::Position>(solver))
      worst = std::max(worst, std::abs(x[2] - first.at(id)[2] - speed * solver.time()));
  }
};
struct PunctualWatch : Watch {
  static constexpr bool only_when_due = true;
};

struct Thrower : PunctualWatch {
  template <class S>
  void observe(const S& solver) {
    if (solver.time() > 0.2e-9) throw std::runtime_error("enough");
  }
};

/// Sums the mass of the nodes at its time.
struct Nodes {
  static constexpr bool only_when_due = true, needs_nodes = true;
  double next = 0.3e-9, mass = 0, active = 0;
  template <class S, class R>
  void begin(const S&, const R&) {}
  double due() const { return next; }
  template <class S>
  void observe(const S& solver) {
    if (solver.time() < next) return;
    next = 1;
    active = solver.active_fraction();
    for (const double m : solver.nodes().mass) mass += m;
  }
  template <class S>
  void end(const S&) {}
};

template <class F>
void fly(const F& f) {
  auto solver = solver_with<QuadraticApicUsl>(sleep::Quiescent{});
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {4 * h, 4 * h, 4 * h}}, aluminium,
              {.velocity = {0, 0, 700}});
  f(solver);
}

}  // namespace

TEST_CASE("sleep: nobody sees a stale position", "[sleep]") {
  const double round_off = 1e-13 * h;
  SECTION("observers at their times") {
    fly([&](auto& solver) {
      PunctualWatch watch{{.speed = 700, .every = 0.3e-9}};
      solver.run({.until = 2e-9}, watch);
      CHECK(watch.looks == 7);
      CHECK(watch.worst < round_off);
      CHECK(solver.active_fraction() == 0);
    });
  }
  SECTION("observers that look at each step") {
    fly([&](auto& solver) {
      Watch watch{.speed = 700};
      PunctualWatch other{{.speed = 700, .every = 0.3e-9}};
      solver.run({.until = 2e-9}, other, watch);
      CHECK(watch.looks == int(solver.steps()) + 1);
      CHECK(watch.worst < round_off);
    });
  }
  SECTION("after a run that ends early, and after steps") {
    fly([&](auto& solver) {
      Watch watch{.speed = 700};
      watch.begin(solver, 0);
      solver.run({.until = 1, .max_steps = 9});
      watch.look(solver);
      solver.step();
      watch.look(solver);
      solver.refresh();
      watch.look(solver);
      CHECK(solver.active_fraction() == 0);
      CHECK(watch.worst < round_off);
    });
  }
  SECTION("after an observer has thrown") {
    fly([&](auto& solver) {
      Thrower thrower{{{.speed = 700}}};
      CHECK_THROWS(solver.run({.until = 2e-9}, thrower));
      thrower.look(solver);
      CHECK(thrower.worst < round_off);
    });
  }
}

TEST_CASE("sleep: an observer of nodes finds them all", "[sleep]") {
  Nodes nodes;
  fly([&](auto& solver) {
    solver.run({.until = 1e-9}, nodes);
    CHECK(nodes.active == 1);
    CHECK(nodes.mass == Approx(2700 * 64 * h * h * h));
    CHECK(solver.active_fraction() == 1);  // it is shown the end, too
    solver.step();
    CHECK(solver.active_fraction() == 0);
    int slept = 0;
    solver.for_each_sleeping_tile([&](const auto& v) { slept += std::abs(v[2] - 700) < 1e-11; });
    CHECK(slept > 0);
    const auto range = observe::grid_velocity_range(solver, 2);
    CHECK(std::abs(range.min - 700) < 1e-11);
    CHECK(std::abs(range.max - 700) < 1e-11);
    solver.refresh();
    CHECK(std::isnan(observe::grid_velocity_range(solver, 2).max));
  });
}

/// There the first particles of a tile are the last that a wave reaches.
TEST_CASE("sleep: a wave from above wakes too", "[sleep]") {
  const auto run = [](const auto& sleep) {
    auto solver = solver_with<QuadraticApicUsl>(sleep, boundary::RigidWall{.side = side::z_max, .at = 0});
    solver.fill(geometry::Box<3>{.lower = {0, 0, -36 * h}, .upper = {6 * h, 6 * h, 0}}, aluminium,
                {.velocity = {0, 0, -100}});
    for (int i = 0; i < 60; ++i) solver.step();
    CHECK(solver.active_fraction() > 0.5);
    return by_id<field::Velocity>(solver);
  };
  CHECK(largest_difference(run(sleep::Quiescent{}), run(sleep::Never{})) < 2 * tolerance * 6400);
}

TEST_CASE("sleep: what a host writes wakes after refresh", "[sleep]") {
  fly([&](auto& solver) {
    solver.step();
    CHECK(solver.active_fraction() == 0);
    solver.particles().template column<field::Velocity>(0)[5] += 1;
    solver.refresh();
    solver.step();
    CHECK(solver.active_fraction() > 0);
  });
}

TEST_CASE("sleep: one disturbed particle wakes the neighbours of its tile, whichever of the tile's it is", "[sleep]") {
  const auto all_velocities = [](const auto& sleep) {
    auto solver = solver_with<schemes::QuadraticApicUsl>(sleep);
    solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {24 * h, 8 * h, 8 * h}}, aluminium, {});
    solver.step();
    auto p = solver.particles().template column<field::Position>(0);
    std::size_t last = 0;  // the last in the columns of those near the middle: not the first of its tile
    for (std::size_t i = 0; i < p.size(); ++i)
      if (std::abs(p[i] - 12 * h) < 1.5 * h) last = i;
    solver.particles().template column<field::Velocity>(0)[last] += 50;
    solver.refresh();
    for (int i = 0; i < 6; ++i) solver.step();
    return by_id<field::Velocity>(solver);
  };
  CHECK(largest_difference(all_velocities(sleep::Quiescent{}), all_velocities(sleep::Never{})) < 1e-6 * 50);
}

TEST_CASE("sleep: the tolerance is positive", "[sleep]") {
  CHECK_THROWS_WITH(solver_with<QuadraticApicUsl>(sleep::Quiescent{.tolerance = 0}),
                    ContainsSubstring("the tolerance of sleep is 0; it must be > 0"));
  CHECK_THROWS_AS(solver_with<QuadraticApicUsl>(sleep::Quiescent{.tolerance = std::nan("")}), InputError);
  CHECK_THROWS_AS(solver_with<QuadraticApicUsl>(sleep::Quiescent{.tolerance = 1}), InputError);
}

TEST_CASE("sleep: a disturbance is that of a number, lane by lane", "[sleep]") {
  const sleep::Quiescent quiescent{};
  using List = union_of<fields<field::Velocity, field::Affine>, particle_fields_of<Aluminium>>;
  Values<double, 3, List> one{};
  Values<Pack<double>, 3, List> pack{};
  aluminium.initialise(one);
  aluminium.initialise(pack);
  const Vec<double, 3> v_ref{1, 2, 3};
  const double c = std::sqrt(aluminium.sound_speed2(one));
  get<field::Velocity>(one) = v_ref;
  for (auto& x : get<field::Affine>(one).c) x = 0;
  CHECK(quiescent.disturbance(aluminium, one, v_ref, h) == 0);
  const auto check = [&](double expected) {
    CHECK(quiescent.disturbance(aluminium, one, v_ref, h) == Approx(expected));
    for (int i = 0; i < 3; ++i) get<field::Velocity>(pack)[i] = get<field::Velocity>(one)[i];
    for (int i = 0; i < 9; ++i) get<field::Affine>(pack).c[i] = get<field::Affine>(one).c[i];
    for (int i = 0; i < 6; ++i) get<field::DeviatoricStress>(pack).c[i] = get<field::DeviatoricStress>(one).c[i];
    const auto found = quiescent.disturbance(aluminium, pack, v_ref, h);
    for (int l = 0; l < lanes; ++l) CHECK(lane(found, l) == Approx(expected));
  };
  get<field::Velocity>(one)[1] -= 5;
  check(5 / c);
  get<field::Affine>(one)(2, 0) = -7 / h;
  check(7 / c);
  get<field::DeviatoricStress>(one).c[4] = -1e9;
  check(1e9 / (2700 * c * c));
}
