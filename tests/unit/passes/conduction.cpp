/// \file
/// Conduction on the grid: against a plain textbook, exact modes, its balance, its limit, and what goes with it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <vector>

#include <mote/mote.hpp>

#include "catch.hpp"
#include "schemes.hpp"

namespace {

using namespace schemes;
using Catch::Matchers::ContainsSubstring;

constexpr double rho = 2700, cv = 880, k = 237, alpha = k / (rho * cv), pi = std::numbers::pi;
const eos::LinearBulk bulk{.rho0 = rho, .bulk_modulus = 77e9};

/// So soft that nothing moves, unless said otherwise.
auto metal(int every = 0, double conductivity = k, double modulus = 1e-3) {
  return Material{eos::LinearBulk{.rho0 = rho, .bulk_modulus = modulus},
                  heat::Conducting{.specific_heat = cv, .conductivity = conductivity, .every = every}};
}

template <class P>
double heat_of(const P& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += cv * double(p.template column<field::Mass>()[i]) * double(p.template column<field::Temperature>()[i]);
  return sum;
}

template <class P, class F>
void set_temperature(P& p, const F& f) {
  for (std::size_t i = 0; i < p.size(); ++i)
    p.template column<field::Temperature>()[i] = f(p.template get<field::Position>(i));
}

// ---- a plain textbook: nodes in a map, images folded onto the node inside

template <class Shape, int D>
class Textbook {
  struct Node {
    double capacity = 0, heat = 0, gain = 0, missed = 0;
  };
  int cells_;  // planes at nodes 0 and cells_ of all axes
  std::map<std::vector<int>, Node> nodes_;

  template <class F>
  void for_each_node(const Vec<double, D>& x, const F& f) {
    int base[D], n = 1;
    double w[D][Shape::support], s[D][Shape::support];
    for (int a = 0; a < D; ++a, n *= Shape::support) {
      base[a] = int(std::floor(x[a] / h - Shape::first));
      Shape::values(x[a] / h - base[a], w[a]);
      Shape::slopes(x[a] / h - base[a], s[a]);
    }
    for (int i = 0; i < n; ++i) {
      std::vector<int> at;
      double weight = 1;
      Vec<double, D> slope = Vec<double, D>::filled(1 / h);
      for (int a = 0, rest = i; a < D; ++a, rest /= Shape::support) {
        const int j = rest % Shape::support;
        weight *= w[a][j];
        for (int b = 0; b < D; ++b) slope[b] *= a == b ? s[a][j] : w[a][j];
        const int node = base[a] + j;
        at.push_back(node < 0 ? -node : node > cells_ ? 2 * cells_ - node : node);
      }
      f(nodes_[at], weight, slope);
    }
  }

 public:
  explicit Textbook(int cells) : cells_(cells) {}

  /// \param relaxed part of (1 - M)^2 T that goes, M T being the means of the means at the nodes
  template <class P>
  std::vector<double> step(const P& p, double dt, double relaxed) {
    const auto all = [&](const auto& f) {
      for (std::size_t i = 0; i < p.size(); ++i) f(i, p.template get<field::Position>(i));
    };
    std::vector<double> t(p.size()), mean(p.size());
    all([&](std::size_t i, const auto& x) {
      t[i] = p.template get<field::Temperature>(i);
      for_each_node(x, [&](Node& node, double w, const auto&) {
        const double c = w * cv * p.template get<field::Mass>(i);
        node.capacity += c, node.heat += c * t[i];
      });
    });
    all([&](std::size_t i, const auto& x) {
      const double volume = p.template get<field::Mass>(i) * p.template get<field::VolumeRatio>(i) / rho;
      Vec<double, D> gradient{};
      for_each_node(x, [&](Node& n, double w, const auto& slope) {
        gradient += (n.heat / n.capacity) * slope;
        mean[i] += w * n.heat / n.capacity;
      });
      for_each_node(x, [&](Node& n, double w, const auto& slope) {
        n.gain -= volume * k * dot(gradient, slope);
        n.missed += w * cv * p.template get<field::Mass>(i) * (t[i] - mean[i]);
      });
    });
    all([&](std::size_t i, const auto& x) {
      const double unseen = t[i] - mean[i];
      t[i] -= relaxed * unseen;
      for_each_node(x, [&](Node& n, double w, const auto&) {
        t[i] += dt * w * n.gain / n.capacity + relaxed * w * n.missed / n.capacity;
      });
    });
    return t;
  }
};

template <class Shape, class Plane, int D>
void compare_with_textbook() {
  constexpr int cells = 6;
  const double limit = h * h / (2 * D * alpha) * (Shape::support == 2 ? 0.5 : 1), dt = 0.4 * limit;
  std::vector<Plane> lower, upper;
  const auto make = [&](auto... axes) {
    return Solver{grid::Cartesian<D>{.spacing = h},
                  Shape{},
                  transfer::Flip{},
                  timestep::Fixed{.dt = dt},
                  metal(1),
                  Plane{.side = {axes, false}, .at = 0}...,
                  Plane{.side = {axes, true}, .at = cells * h}...};
  };
  auto solver = [&] {
    if constexpr (D == 1)
      return make(0);
    else if constexpr (D == 2)
      return make(0, 1);
    else
      return make(0, 1, 2);
  }();
  // a free surface and a hole, beside planes
  solver.fill(geometry::Box<D>{.lower = {}, .upper = Vec<double, D>::filled(4.5 * h)} -
                  geometry::Ball<D>{.centre = Vec<double, D>::filled(2.2 * h), .radius = 0.9 * h},
              metal(1), {.method = geometry::Method::fraction, .jitter = 0.3});
  auto& p = solver.particles();
  Random random;
  set_temperature(p, [&](const auto&) { return 300 + random(50); });
  for (double& x : p.template column<field::VolumeRatio>()) x = 1 + random(0.2);
  for (int a = 0; a < D; ++a)
    for (double& v : p.template column<field::Velocity>(a)) v = 0;
  solver.refresh();
  const auto expected = Textbook<Shape, D>(cells).step(p, dt, 0.4);
  solver.step(dt);
  // the step moves the metal too, which changes the temperature by what its volume changes: nothing, without gamma
  for (std::size_t i = 0; i < p.size(); ++i)
    REQUIRE(p.template column<field::Temperature>()[i] == Approx(expected[i]).epsilon(1e-12));
}

// ---- exact modes

/// T = 300 + prod cos(2 pi x_a/L + phase), in a box with n cells per axis, whose sides the boundaries are.
template <class Shape, int D, class... Boundaries>
double mode_error(int n, double wave_number, double phase, int every, double steps_per_limit, Boundaries... sides) {
  const double length = 16e-6, spacing = length / n, rate = D * alpha * wave_number * wave_number;
  const double limit = spacing * spacing / (2 * D * alpha), end = 1 / rate;
  const int steps = every * int(std::ceil(end / limit * steps_per_limit / every));
  const auto m = metal(every);
  Solver solver{grid::Cartesian<D>{.spacing = spacing}, Shape{}, transfer::Flip{},
                timestep::Fixed{.dt = end / steps},     m,       sides...};
  solver.fill(geometry::Box<D>{.lower = {}, .upper = Vec<double, D>::filled(length)}, m);
  solver.refresh();
  auto& p = solver.particles();
  const auto mode = [&](const Vec<double, D>& x) {
    double product = 1;
    for (int a = 0; a < D; ++a) product *= std::cos(wave_number * x[a] + phase);
    return product;
  };
  set_temperature(p, [&](const auto& x) { return 300 + mode(x); });
  for (int i = 0; i < steps; ++i) solver.step();
  double sum = 0, norm = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double shape = mode(p.template get<field::Position>(i));
    sum += shape * (p.template column<field::Temperature>()[i] - 300), norm += shape * shape;
  }
  return sum / norm - std::exp(-1.0);
}

template <class Shape>
void check_order_one_dimension() {
  const double length = 16e-6;
  const boundary::Periodic around{.axis = 0, .from = 0, .to = length};
  const boundary::RigidWall wall{.side = side::x_min, .at = 0};
  const boundary::Symmetry mirror{.side = side::x_max, .at = length};
  double last[3] = {};
  for (int n = 16; n <= 128; n *= 2) {
    const double now[3] = {mode_error<Shape, 1>(n, 2 * pi / length, 0.3, 1, 1, around),
                           mode_error<Shape, 1>(n, pi / length, 0, 1, 1, wall, mirror),
                           mode_error<Shape, 1>(n, pi / length, 0, 1, 1)};  // free ends
    for (int i = 0; i < 3; ++i) {
      CAPTURE(n, i, last[i], now[i]);
      if (n > 32) CHECK(std::log2(last[i] / now[i]) == Approx(2).margin(0.1));
      last[i] = now[i];
    }
  }
  for (int i = 0; i < 3; ++i) CHECK(std::abs(last[i]) < 1e-3);
}

}  // namespace

TEST_CASE("conduction: one round against a plain textbook, beside planes, a free surface and a hole", "[conduction]") {
  compare_with_textbook<shape::CubicBSpline, boundary::Symmetry, 1>();
  compare_with_textbook<shape::Linear, boundary::Symmetry, 2>();
  compare_with_textbook<shape::QuadraticBSpline, boundary::RigidWall, 3>();
}

TEMPLATE_TEST_CASE("conduction: a mode decays with exp(-alpha k^2 t), to order 2, periodic, between walls, free",
                   "[conduction]", shape::Linear, shape::QuadraticBSpline, shape::CubicBSpline) {
  check_order_one_dimension<TestType>();
}

TEST_CASE("conduction: an oblique mode in the plane, to order 2", "[conduction]") {
  const double length = 16e-6;
  const auto error = [&](int n) {
    return mode_error<shape::QuadraticBSpline, 2>(
        n, 2 * pi / length, 0, 1, 1, boundary::RigidWall{.side = side::x_min, .at = 0},
        boundary::Symmetry{.side = side::x_max, .at = length}, boundary::Periodic{.axis = 1, .from = 0, .to = length});
  };
  CHECK(std::log2(error(32) / error(64)) == Approx(2).margin(0.1));
}

TEST_CASE("conduction: every step and every 20 steps agree as the steps shrink, to order 1", "[conduction]") {
  const double length = 16e-6;
  const boundary::Periodic around{.axis = 0, .from = 0, .to = length};
  const auto error = [&](int every, double steps_per_limit) {
    return mode_error<shape::QuadraticBSpline, 1>(32, 2 * pi / length, 0, every, steps_per_limit, around);
  };
  // the same mesh, so the same spatial error; explicit steps of 20 dt make an error 20 times as large
  const double d40 = error(20, 40) - error(1, 40), d80 = error(20, 80) - error(1, 80);
  CHECK(std::abs(d40) < 0.02 * std::exp(-1.0));
  CHECK(d40 / d80 == Approx(2).margin(0.1));
  // steps beyond the limit are cut into rounds within it
  CHECK(std::abs(error(20, 1)) < 0.02);
}

namespace {

/// A ball that flies and rings in a corner of walls and a period, unevenly hot.
template <class Scheme, int D, class Executor, class M>
auto ball(const Executor& executor, const M& m) {
  return Solver{grid::Cartesian<D>{.spacing = h},
                typename Scheme::Shape{},
                typename Scheme::Transfer{},
                typename Scheme::Update{},
                timestep::Cfl{.courant = 0.4},
                executor,
                boundary::RigidWall{.side = side::x_min, .at = 0},
                boundary::Periodic{.axis = 1, .from = 0, .to = 8 * h},
                m};
}
template <class S, class M>
void fill_ball(S& solver, const M& m) {
  solver.fill(geometry::Ball<3>{.centre = {3 * h, 4 * h, 2 * h}, .radius = 3.2 * h} &
                  geometry::Box<3>{.lower = {0, 0, -9 * h}, .upper = {9 * h, 8 * h, 9 * h}},
              m, {.velocity = {-200, 150, 0}, .jitter = 0.2});
  set_temperature(solver.particles(), [](const auto& x) { return 300 + 100 * std::sin(3e6 * x[0] + 2e6 * x[2]); });
}

}  // namespace

TEMPLATE_TEST_CASE("conduction: heat is conserved to round-off in a body that moves and hits a wall", "[conduction]",
                   schemes::LinearFlipMusl, schemes::QuadraticApicUsl) {
  const auto m = metal(2, 100 * k, 77e9);
  auto solver = ball<TestType, 3>(execution::Serial{}, m);
  fill_ball(solver, m);
  const double before = heat_of(solver.particles());
  auto spread = [&] {
    const auto t = solver.particles().template column<field::Temperature>();
    return *std::max_element(t.begin(), t.end()) - *std::min_element(t.begin(), t.end());
  };
  const double uneven = spread();
  for (int i = 0; i < 60; ++i) solver.step();
  CHECK(solver.sorts() > 1);
  CHECK(heat_of(solver.particles()) == Approx(before).epsilon(1e-13));
  CHECK(spread() < 0.5 * uneven);
}

TEST_CASE("conduction: the same bits for any number of threads", "[conduction]") {
  const Material m{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                   strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                   heat::Conducting{.specific_heat = cv, .conductivity = 20 * k}};
  const auto run = [&](const auto& executor) {
    auto solver = ball<schemes::QuadraticApicUsl, 3>(executor, m);
    fill_ball(solver, m);
    for (int i = 0; i < 40; ++i) solver.step();
    const auto t = solver.particles().template column<field::Temperature>();
    return std::vector<double>(t.begin(), t.end());
  };
  const auto serial = run(execution::Serial{});
  CHECK(serial == run(execution::Threads{2}));
  CHECK(serial == run(execution::Threads{3}));
}

TEST_CASE("conduction: a body shares its heat with one that conducts, and with no other", "[conduction]") {
  const double cell = 1e-6;
  const Material hot{bulk, heat::Conducting{.specific_heat = cv, .initial_temperature = 400, .conductivity = k}};
  const Material cold{bulk, heat::Conducting{.specific_heat = 2 * cv, .initial_temperature = 300, .conductivity = k}};
  const Material insulator{bulk, heat::Adiabatic{.specific_heat = cv, .initial_temperature = 500}};
  Solver solver{grid::Cartesian<1>{.spacing = cell},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Fixed{.dt = 1e-10},
                hot,
                cold,
                insulator};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {5 * cell}}, hot);
  solver.fill(geometry::Box<1>{.lower = {5 * cell}, .upper = {10 * cell}}, cold);
  solver.fill(geometry::Box<1>{.lower = {10 * cell}, .upper = {15 * cell}}, insulator);
  // k/(rho cv) differs by 2; the slowest mode of the pair is gone by exp(-alpha (pi/10 um)^2 t/2) = e^-20 at 4 us
  while (solver.time() < 4e-6) solver.step();
  for (double t : solver.particles(hot).column<field::Temperature>()) CHECK(t == Approx(1000.0 / 3).epsilon(1e-7));
  for (double t : solver.particles(cold).column<field::Temperature>()) CHECK(t == Approx(1000.0 / 3).epsilon(1e-7));
  for (double t : solver.particles(insulator).column<field::Temperature>()) CHECK(t == 500);
}

namespace {

/// The largest eigenvalue of what a round takes from the particles, times the explicit limit, by the power method: a
/// round is stable up to 2.
template <class Shape, int D>
double stiffness(int per_axis, double jitter, geometry::Method method, std::uint64_t seed) {
  const double limit = h * h / (2 * D * alpha) * (Shape::support == 2 ? 0.5 : 1);
  const auto m = metal(1);
  Solver solver{grid::Cartesian<D>{.spacing = h}, Shape{}, transfer::Flip{}, timestep::Fixed{.dt = limit}, m};
  Vec<double, D> centre{};
  for (int a = 0; a < D; ++a) centre[a] = h * (0.1 + 0.23 * double((seed + std::size_t(a)) % 5));
  solver.fill(geometry::Ball<D>{.centre = centre, .radius = 3.3 * h}, m,
              {.per_axis = per_axis, .method = method, .jitter = jitter, .seed = seed});
  solver.refresh();
  auto t = solver.particles().template column<field::Temperature>();
  Random random;
  for (double& one : t) one = random(1);
  std::vector<double> old;
  double largest = 0;
  for (int i = 0; i < 60; ++i) {
    old.assign(t.begin(), t.end());
    solver.step();
    double norm2 = 0, old2 = 0;
    for (std::size_t p = 0; p < t.size(); ++p) {
      const double mass = solver.particles().template column<field::Mass>()[p];
      old2 += mass * old[p] * old[p], norm2 += mass * (t[p] - old[p]) * (t[p] - old[p]);
    }
    largest = std::sqrt(norm2 / old2);
    for (std::size_t p = 0; p < t.size(); ++p) t[p] = (old[p] - t[p]) / largest;
  }
  return largest;
}

template <class Shape, int D>
double stiffest(int seeds, geometry::Method method) {
  double most = 0;
  for (const int per_axis : {1, 2, 3})
    for (const double jitter : {0.0, 0.25, 0.5})
      for (int seed = 0; seed < seeds; ++seed)
        most = std::max(most, stiffness<Shape, D>(per_axis, jitter, method, std::uint64_t(seed)));
  return most;
}

}  // namespace

TEST_CASE("conduction: a round is stable for any place of the particles, at free surfaces too", "[conduction]") {
  using enum geometry::Method;
  CHECK(stiffest<shape::QuadraticBSpline, 1>(100, fraction) < 1.01);
  CHECK(stiffest<shape::QuadraticBSpline, 1>(100, lattice) < 1.01);
  CHECK(stiffest<shape::QuadraticBSpline, 2>(10, fraction) < 1.01);
  CHECK(stiffest<shape::Linear, 1>(100, lattice) < 1.2);
  CHECK(stiffest<shape::Linear, 1>(200, fraction) > 2);  // a known limit: slivers and linear hats
}

TEST_CASE("conduction: once per as many steps as the limit allows, heating as without it in between", "[conduction]") {
  // aluminium, 1 um, three dimensions: h^2/(6 alpha) = 1.671 ns, so 26 steps of 62 ps
  passes::Conduction<double, 3, true> conduction(1e-6, 3, std::tuple(metal()));
  int steps = 0;
  double conducted = 0;
  for (int i = 0; i < 26 * 4; ++i)
    if (const double due = conduction.due(62e-12); due > 0) ++steps, conducted += due;
  CHECK(steps == 4);
  CHECK(conducted == Approx(26 * 4 * 62e-12).epsilon(1e-12));
  passes::Conduction<double, 3, true> none(1e-6, 3, std::tuple(metal(1, 0)));
  CHECK(none.due(1) == 0);
}

TEST_CASE("conduction: impossible numbers are refused", "[conduction]") {
  CHECK_THROWS_WITH(metal(0, -1), ContainsSubstring("the conductivity is -1 W/(m K); it must be >= 0"));
  CHECK_THROWS_WITH(metal(-3), ContainsSubstring("heat is to be conducted every -3 steps"));
  CHECK_THROWS_WITH((Material{bulk, heat::Conducting{.specific_heat = 0, .conductivity = 1}}),
                    ContainsSubstring("the specific heat is 0"));
}

namespace {

// what does not conduct pays nothing; what does has no more columns than heat::Adiabatic
using Cold = passes::Conduction<double, 3, false>;
static_assert(std::is_empty_v<Cold>);
static_assert(std::is_same_v<particle_fields_of<decltype(metal())>,
                             particle_fields_of<decltype(Material{bulk, heat::Adiabatic{}})>>);

}  // namespace
