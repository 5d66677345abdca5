/// \file
/// Transfers that sharpen: what XPIC, FMPM and affine FLIP keep, what they damp, and what they are at order one.
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <mote/mote.hpp>
#include <vector>

#include "../passes/schemes.hpp"
#include "catch.hpp"

namespace {

using namespace schemes;

/// So soft that its stress is nothing beside any momentum, and a step so short that nothing moves.
const Material dust{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 1e-30}};
const Material rubber{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 1e9}};
constexpr double instant = 1e-20;

template <class P>
auto momentum(const P& particles) {
  Vec<double, P::dimension> sum{};
  for (std::size_t p = 0; p < particles.size(); ++p)
    sum += particles.template column<field::Mass>()[p] * particles.template get<field::Velocity>(p);
  return sum;
}

template <class S>
std::vector<double> numbers(S& solver) {
  auto all = columns(solver);
  for (const auto& part : solver.ledger().impulse) all.insert(all.end(), part.c, part.c + S::dimension);
  return all;
}

/// A shaken block between a wall, a symmetry plane and periodic sides; some particles lie beyond the planes.
template <class Shape, class X, class U, class Executor = execution::Serial>
auto shaken(const X& transfer, const U& update, const Executor& executor = {}) {
  auto solver = std::make_unique<Solver<grid::Cartesian<2>, Shape, X, U, timestep::Fixed, Executor, sleep::Never,
                                        std::tuple<boundary::Periodic, boundary::Symmetry, boundary::RigidWall>,
                                        std::tuple<>, std::tuple<std::remove_const_t<decltype(rubber)>>>>(
      grid::Cartesian<2>{.spacing = h}, Shape{}, transfer, update, timestep::Fixed{.dt = 1e-10}, executor,
      boundary::Periodic{.axis = axis::x, .from = 0, .to = 6 * h}, boundary::Symmetry{.side = side::y_max, .at = 9 * h},
      boundary::RigidWall{.side = side::y_min, .at = 0}, rubber);
  solver->fill(geometry::Box<2>{.lower = {0, 0}, .upper = {6 * h, 9 * h}} -
                   geometry::Ball<2>{.centre = {2 * h, 5 * h}, .radius = 1.8 * h},
               rubber, {.per_axis = 2, .velocity = {300, -200}});
  shake(solver->particles(), 50);
  for (double& y : solver->particles().template column<field::Position>(1)) y -= 0.2 * h;
  solver->refresh();
  return solver;
}

template <class Shape, class X, class U, class Executor = execution::Serial>
auto after_20_steps(const X& transfer, const U& update, const Executor& executor = {}) {
  const auto solver = shaken<Shape>(transfer, update, executor);
  for (int i = 0; i < 20; ++i) solver->step();
  return numbers(*solver);
}

/// The largest relative difference of any two numbers.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) most = std::max(most, std::abs(a[i] - b[i]) / std::max(std::abs(a[i]), std::abs(b[i])));
  return most;
}

template <class Shape, class U>
void check_momentum(const U& update) {
  const auto check = [&](const auto& transfer) {
    const auto solver = shaken<Shape>(transfer, update);
    const auto before = momentum(solver->particles());
    double mass = 0;
    for (const double m : solver->particles().template column<field::Mass>()) mass += m;
    for (int i = 0; i < 20; ++i) solver->step();
    Vec<double, 2> given{};
    for (const auto& part : solver->ledger().impulse) given += part;
    CHECK(norm(momentum(solver->particles()) - before - given) < 1e-13 * mass * 400);
    CHECK(std::abs(given[0]) > 0.01 * mass * 300);  // the wall holds it back
    CHECK(solver->ledger().impulse[1][0] == 0);     // the symmetry plane does not
  };
  const int order = GENERATE(1, 2, 5, 12);
  CAPTURE(order);
  check(transfer::Xpic{.order = order});
  check(transfer::Fmpm{.order = order});
  check(transfer::AffineFlip{.order = order});
}

/// A line of particles in a periodic cell, and its transfers as dense matrices.
template <class Shape>
struct Line {
  int cells;
  std::vector<double> x, m;            // in cells
  std::vector<std::vector<double>> S;  // particle, node

  Line(int n, const std::vector<double>& places, const std::vector<double>& masses) : cells(n), x(places), m(masses) {
    for (const double at : x) {
      S.emplace_back(std::size_t(n), 0.0);
      const double low = std::floor(at - Shape::first);
      double w[Shape::support];
      Shape::values(at - low, w);
      for (int i = 0; i < Shape::support; ++i) S.back()[std::size_t((int(low) + i + 2 * n) % n)] += w[i];
    }
  }
  /// (1 - S S+) V
  std::vector<double> unseen(std::vector<double> V) const {
    std::vector<double> v(std::size_t(cells), 0.0), mass(std::size_t(cells), 0.0);
    for (std::size_t p = 0; p < x.size(); ++p)
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += S[p][i] * m[p] * V[p], mass[i] += S[p][i] * m[p];
    for (std::size_t p = 0; p < x.size(); ++p)
      for (std::size_t i = 0; i < v.size(); ++i) V[p] -= S[p][i] * v[i] / mass[i];
    return V;
  }
  /// What a solver makes of velocities V in an instant.
  template <class X>
  std::vector<double> step(const X& transfer, const std::vector<double>& V) const {
    Solver solver{grid::Cartesian<1>{.spacing = 1},
                  Shape{},
                  transfer,
                  timestep::Fixed{.dt = instant},
                  boundary::Periodic{.axis = 0, .from = 0, .to = double(cells)},
                  dust};
    solver.fill(geometry::Box<1>{.lower = {0}, .upper = {double(cells)}}, dust, {.per_axis = int(x.size()) / cells});
    auto& particles = solver.particles();
    for (std::size_t p = 0; p < x.size(); ++p) {
      particles.template column<field::Position>(0)[p] = x[p];
      particles.template column<field::Mass>()[p] = m[p];
      particles.template column<field::Velocity>(0)[p] = V[p];
    }
    solver.step();
    std::vector<double> after(x.size());
    for (std::size_t p = 0; p < x.size(); ++p)
      after[particles.template column<field::Id>()[p]] = particles.template column<field::Velocity>(0)[p];
    return after;
  }
};

double size(const std::vector<double>& a) {
  double sum = 0;
  for (const double x : a) sum += x * x;
  return std::sqrt(sum / double(a.size()));
}
std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

template <class Shape>
Line<Shape> random_line(int cells, int per_cell) {
  Random random;
  std::vector<double> x, m;
  for (int i = 0; i < cells * per_cell; ++i)
    x.push_back((i + 0.5 + random(0.3)) / per_cell), m.push_back(1 + random(0.2));
  return {cells, x, m};
}
/// Two particles per cell in order, and a sine of one wave over all.
template <class Shape>
std::pair<Line<Shape>, std::vector<double>> wave(int cells) {
  std::vector<double> x, V;
  for (int i = 0; i < 2 * cells; ++i)
    x.push_back(0.5 * (i + 0.5)), V.push_back(std::sin(2 * std::acos(-1) * x.back() / cells + 0.3));
  return {Line<Shape>{cells, x, std::vector<double>(x.size(), 1.0)}, V};
}

}  // namespace

TEMPLATE_TEST_CASE("XPIC(1) and FMPM(1) are PIC", "[transfer]", shape::Linear, shape::QuadraticBSpline) {
  const transfer::Flip pic{.blend = 0};
  const auto check = [&](const auto& update) {
    const auto reference = after_20_steps<TestType>(pic, update);
    const auto xpic = after_20_steps<TestType>(transfer::Xpic{.order = 1}, update),
               fmpm = after_20_steps<TestType>(transfer::Fmpm{.order = 1}, update),
               second = after_20_steps<TestType>(transfer::Fmpm{.order = 2}, update);
    CHECK(apart(reference, fmpm) < 1e-10);  // round-off: compilers may fuse what is inlined differently
    CHECK(apart(reference, xpic) < 1e-10);
    CHECK(apart(reference, second) > 1e-3);
  };
  check(update::Usl{});
  check(update::Usf{});
  check(update::Musl{});
}

TEMPLATE_TEST_CASE("sharpening conserves momentum, and planes give what the body gains", "[transfer]",
                   shape::QuadraticBSpline, shape::CubicBSpline) {
  check_momentum<TestType>(update::Usl{});
  check_momentum<TestType>(update::Usf{});
}

TEST_CASE("sharpening and USF: any number of threads gives the same bits", "[transfer][execution]") {
  const auto check = [](const auto& transfer, const auto& update) {
    const auto serial = after_20_steps<shape::QuadraticBSpline>(transfer, update);
    for (const int threads : {1, 2, 3})
      CHECK(same_bits(after_20_steps<shape::QuadraticBSpline>(transfer, update, execution::Threads(threads)), serial));
  };
  check(transfer::Xpic{.order = 4}, update::Usl{});
  check(transfer::Fmpm{.order = 3}, update::Usf{});
  check(transfer::AffineFlip{.order = 3}, update::Usl{});
}

/// Repeated transfers carry a disturbance by several kernels in a step, what sleeps cuts it off; it has died out there.
TEST_CASE("transfers that sharpen with sleep move every particle as without", "[transfer][sleep]") {
  const auto run = [](const auto& transfer, const auto& sleep) {
    Solver solver{grid::Cartesian<2>{.spacing = h},
                  shape::QuadraticBSpline{},
                  transfer,
                  timestep::Cfl{.courant = 0.3},
                  sleep,
                  boundary::RigidWall{.side = side::y_min, .at = 0},
                  rubber};
    solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {4 * h, 60 * h}}, rubber, {.velocity = {0, -100}});
    std::map<std::uint32_t, double> v;
    double least = 1;
    for (int i = 0; i < 60; ++i) {
      solver.step();
      least = std::min(least, solver.active_fraction());
    }
    CHECK((least < 0.7 || !std::remove_cvref_t<decltype(sleep)>::sleeps));
    for (std::size_t p = 0; p < solver.size(); ++p)
      v[solver.particles().template column<field::Id>()[p]] = solver.particles().template column<field::Velocity>(1)[p];
    return v;
  };
  const auto check = [&](const auto& transfer, double bound = 100 * sleep::Quiescent{}.tolerance * 1000) {
    const auto sleeping = run(transfer, sleep::Quiescent{}), never = run(transfer, sleep::Never{});
    double most = 0;
    for (const auto& [id, v] : sleeping) most = std::max(most, std::abs(v - never.at(id)));
    CAPTURE(transfer.order, most);
    CHECK(most < bound);
  };
  check(transfer::Xpic{.order = 5});
  check(transfer::Xpic{.order = 20}, 1e-5 * 100);  // what reaches over 20 kernels is cut off, whatever the tolerance
  check(transfer::Fmpm{.order = 5});
  check(transfer::AffineFlip{.order = 2});
  check(transfer::AffineFlip{.order = 5});
}

TEMPLATE_TEST_CASE("XPIC leaves (1 - S S+)^m of a velocity behind, FMPM the same", "[transfer]", shape::Linear,
                   shape::QuadraticBSpline, shape::CubicBSpline) {
  const auto line = random_line<TestType>(12, 3);
  Random random;
  std::vector<double> V(line.x.size());
  for (double& v : V) v = random(1);
  std::vector<double> lost = V;
  for (int m = 1; m <= 40; ++m) {
    lost = line.unseen(lost);
    CAPTURE(m);
    CHECK(size(difference(line.step(transfer::Xpic{.order = m}, V), difference(V, lost))) < 1e-13);
    CHECK(size(difference(line.step(transfer::Fmpm{.order = m}, V), difference(V, lost))) < 1e-13);
  }
}

TEMPLATE_TEST_CASE("noise that the grid cannot see stays with FLIP and is gone at once with XPIC", "[transfer]",
                   shape::Linear, shape::QuadraticBSpline, shape::CubicBSpline) {
  const auto line = random_line<TestType>(12, 4);
  Random random;
  std::vector<double> noise(line.x.size());
  for (double& v : noise) v = random(1);
  for (int i = 0; i < 20000; ++i) noise = line.unseen(noise);
  REQUIRE(size(noise) > 0.3);
  CHECK(size(difference(line.step(transfer::Flip{}, noise), noise)) < 1e-13);
  for (const int m : {1, 2, 5, 40}) CHECK(size(line.step(transfer::Xpic{.order = m}, noise)) < 1e-5);
}

/// PIC loses (kh)^2 of a wave and XPIC(m) (kh)^(2m), until what is lost is what splines of degree d cannot follow. That
/// is of order d + 1, and one better where the leading error is the same at both particles of a cell (odd d), since the
/// nodes take it up.
TEST_CASE("XPIC keeps a smooth wave, the better the higher its order", "[transfer]") {
  const auto order_of = [](auto shape, int m) {
    double loss[2];
    for (const int fine : {0, 1}) {
      const auto [line, V] = wave<decltype(shape)>(fine ? 48 : 24);
      loss[fine] = size(difference(line.step(transfer::Xpic{.order = m}, V), V)) / size(V);
    }
    return std::log2(loss[0] / loss[1]);
  };
  CHECK(order_of(shape::Linear{}, 1) == Approx(2).margin(0.05));
  CHECK(order_of(shape::Linear{}, 5) == Approx(3).margin(0.05));
  CHECK(order_of(shape::QuadraticBSpline{}, 1) == Approx(2).margin(0.05));
  CHECK(order_of(shape::QuadraticBSpline{}, 5) == Approx(3).margin(0.05));
  CHECK(order_of(shape::CubicBSpline{}, 1) == Approx(2).margin(0.05));
  CHECK(order_of(shape::CubicBSpline{}, 2) == Approx(4).margin(0.05));
  CHECK(order_of(shape::CubicBSpline{}, 5) == Approx(5).margin(0.05));
}

/// On shaken particles PIC bends an affine field; the higher the order, the less, well inside at least.
TEMPLATE_TEST_CASE("XPIC comes to keep an affine field inside a body", "[transfer]", shape::Linear,
                   shape::QuadraticBSpline) {
  const auto error = [](int m) {
    Solver solver{grid::Cartesian<2>{.spacing = h}, TestType{}, transfer::Xpic{.order = m},
                  timestep::Fixed{.dt = instant}, dust};
    solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {16 * h, 16 * h}}, dust, {.per_axis = 3});
    auto& particles = solver.particles();
    shake(particles, 0);
    const auto affine = [](const Vec<double, 2>& x) {
      return Vec<double, 2>{1 + (x[0] - 2 * x[1]) / h, 3 * x[1] / h - x[0] / h};
    };
    for (std::size_t p = 0; p < particles.size(); ++p)
      particles.template set<field::Velocity>(p, affine(particles.template get<field::Position>(p)));
    solver.step();
    double most = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const auto x = particles.template get<field::Position>(p);
      if (std::abs(x[0] / h - 8) > 3 || std::abs(x[1] / h - 8) > 3) continue;
      most = std::max(most, norm(particles.template get<field::Velocity>(p) - affine(x)));
    }
    return most;
  };
  const double first = error(1);
  double last = first;
  CHECK(first > 0.02);
  for (const int m : {2, 5, 10, 40}) {
    const double now = error(m);
    CAPTURE(m, now);
    CHECK(now < last);
    last = now;
  }
  CHECK(last < 1e-2);
}

TEST_CASE("orders out of range are refused", "[transfer]") {
  CHECK_THROWS_WITH(transfer::Xpic{.order = 0}.validate(), "mote: the XPIC order is 0; it must be from 1 to 40");
  CHECK_THROWS_WITH(transfer::Fmpm{.order = 41}.validate(), "mote: the FMPM order is 41; it must be from 1 to 40");
  CHECK_THROWS_WITH(transfer::AffineFlip{.order = 0}.validate(),
                    "mote: the order of the change of velocity is 0; it must be from 1 to 40");
  CHECK_THROWS_WITH(transfer::AffineFlip{.tail = 0.5}.validate(),
                    "mote: the weight of the last term is 0.5; it must be in [1, 2]");
}
