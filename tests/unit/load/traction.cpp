/// \file
/// Tractions: which faces carry them, what they give, and the wave that they send into a bar.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <mote/mote.hpp>
#include <mote/observe/ledger.hpp>

#include "catch.hpp"
#include "unit/passes/schemes.hpp"

namespace {

using namespace schemes;

const Material linear{eos::LinearBulk{.rho0 = 2700, .bulk_modulus = 77e9}};
const double rho_c = std::sqrt(77e9 * 2700), c = rho_c / 2700, pi = 3.14159265358979323846;

template <int I, class S>
double area_of(const S& solver) {
  const auto a = solver.particles().template column<field::LoadedArea<I>>();
  return std::accumulate(a.begin(), a.end(), 0.0);
}
template <class S>
auto momentum_of(const S& solver) {
  Vec<double, S::dimension> sum{};
  for (std::size_t p = 0; p < solver.size(); ++p)
    sum += solver.particles().template column<field::Mass>()[p] * solver.particles().template get<field::Velocity>(p);
  return sum;
}

}  // namespace

TEST_CASE("traction: a region that throws leaves nothing behind", "[load]") {
  struct Throws {
    bool contains(const Vec<double, 1>& x) const {
      if (x[0] > 3 * h) throw std::runtime_error("no region here");
      return true;
    }
  };
  Solver solver{grid::Cartesian<1>{.spacing = h}, shape::Linear{}, transfer::Flip{}, timestep::Fixed{.dt = 1e-11},
                load::Traction<1>{.side = side::x_max, .traction = Vec<double, 1>{1}, .where = Throws{}}, linear};
  const auto bar = [](double to) { return geometry::Box<1>{.lower = {0}, .upper = {to * h}}; };
  CHECK_THROWS_WITH(solver.fill(bar(6), linear), "no region here");
  CHECK(solver.size() == 0);
  CHECK(solver.fill(bar(2), linear) == 4);
  CHECK(solver.particles().column<field::Id>()[0] == 0);
  CHECK_NOTHROW(solver.step());
}

TEST_CASE("traction: faces of one side, where a region says, not at planes, ends of periods or inside", "[load]") {
  using enum geometry::Method;
  for (const auto method : {lattice, fraction})
    for (const double jitter : {0.0, 0.3}) {
      CAPTURE(method == lattice, jitter);
      Solver solver{grid::Cartesian<3>{.spacing = h},
                    shape::QuadraticBSpline{},
                    transfer::Flip{},
                    timestep::Fixed{.dt = 1e-11},
                    boundary::Symmetry{.side = side::x_min},
                    boundary::Periodic{.axis = axis::y, .from = 0, .to = 4 * h},
                    load::Traction<3>{.side = side::z_max, .traction = {0, 0, 1}},
                    load::BodyForce<3>{.acceleration = {0, 0, 0}},
                    load::Traction<3>{.side = side::x_max,
                                      .traction = {0, 0, 1},
                                      .where = geometry::HalfSpace<3>{.point = {0, 0, 3 * h}, .normal = {0, 0, 1}}},
                    load::Traction<3>{.side = side::x_min, .traction = {0, 0, 1}},
                    load::Traction<3>{.side = side::y_max, .traction = {0, 0, 1}},
                    linear};
      solver.fill(geometry::Box<3>{.lower = {-h, 0, 0}, .upper = {3 * h, 4 * h, 5 * h}} -
                      geometry::Box<3>{.lower = {h, h, h}, .upper = {2 * h, 2 * h, 2 * h}},
                  linear, {.method = method, .jitter = jitter});
      const double cell = h * h;
      CHECK(area_of<0>(solver) == Approx((3 * 4 + 1) * cell).epsilon(1e-12));  // the hole's floor looks up too
      CHECK(area_of<2>(solver) == Approx((4 * 3 + 1) * cell).epsilon(1e-12));  // up to z = 3 h, and a wall of the hole
      CHECK(area_of<3>(solver) == Approx(1 * cell).epsilon(1e-12));            // the hole's alone
      CHECK(area_of<4>(solver) == Approx(1 * cell).epsilon(1e-12));
    }
}

TEMPLATE_TEST_CASE("traction: what the body gains is force times time, to round-off", "[load]", schemes::LinearFlipMusl,
                   schemes::QuadraticApicUsl) {
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename TestType::Shape{},
                typename TestType::Transfer{},
                typename TestType::Update{},
                timestep::Fixed{.dt = 4e-11},
                boundary::Periodic{.axis = axis::y, .from = 0, .to = 4 * h},
                load::Traction<3>{.side = side::z_max, .traction = {3e8, 1e8, 2e8}},
                load::Traction<3>{.side = side::z_min,
                                  .traction =
                                      [](const Vec<double, 3>&, double t) {
                                        return Vec<double, 3>{0, 0, t < 1e-9 ? -1e8 : 0};
                                      }},
                aluminium};
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {3 * h, 4 * h, 5 * h}}, aluminium, {.jitter = 0.2});
  Vec<double, 3> given{};
  const double area = 3 * 4 * h * h;
  for (int i = 0; i < 400; ++i) {
    const double at = solver.time(), dt = solver.step();
    given += area * dt * Vec<double, 3>{3e8, 1e8, 2e8 + (at < 1e-9 ? -1e8 : 0)};
  }
  CHECK(solver.sorts() > 1);
  const auto p = momentum_of(solver);
  for (int a = 0; a < 3; ++a) CHECK(p[a] == Approx(given[a]).epsilon(1e-12));
}

namespace {

struct Errors {
  double at_centre, at_face;  ///< of the wave, sent out from the last particle's centre or from the face
};

/// A bar's end is pulled with S sin^2(pi t/T); L2 error of the particles' ways against int s(t - X/c) dt/(rho c), over
/// that of the end. (Ways, since velocities are those of the middle of the step, as with any leapfrog.)
template <class Scheme>
Errors pull_error(double spacing) {
  const double pull = 1e3, period = 20e-6 / c, length = 40e-6;
  const auto way = [=](double t) {
    const double s = std::min(std::max(t, 0.0), period);
    return 0.5 * pull / rho_c * (s - period / (2 * pi) * std::sin(2 * pi * s / period));
  };
  const auto stress = [=](double t) { return t < 0 || t > period ? 0 : pull * std::pow(std::sin(pi * t / period), 2); };
  Solver solver{
      grid::Cartesian<1>{.spacing = spacing},
      typename Scheme::Shape{},
      typename Scheme::Transfer{},
      typename Scheme::Update{},
      timestep::Cfl{.courant = 0.2},
      load::Traction<1>{.side = side::x_max,
                        .traction = [=](const Vec<double, 1>&, double t) { return Vec<double, 1>{stress(t)}; }},
      linear};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {length}}, linear);
  solver.refresh();
  const auto x = solver.particles().template column<field::Position>();
  const std::vector<double> place(x.begin(), x.end());
  const double end = 1.5 * period;
  while (solver.time() < end * (1 - 1e-12)) solver.step(end - solver.time());
  double sum[2] = {};
  for (std::size_t i = 0; i < place.size(); ++i)
    for (int face = 0; face < 2; ++face) {
      const double far = (face ? length : length - 0.25 * spacing) - place[i];
      const double e = solver.particles().template column<field::Position>()[i] - place[i] - way(end - far / c);
      sum[face] += e * e;
    }
  const auto ledger = observe::ledger(solver);
  const double work = pull * pull / rho_c * period * 3 / 8;  // int s v dt
  CHECK(ledger.load_work == Approx(work).epsilon(0.1 * spacing / 1e-6));
  CHECK(std::abs(ledger.energy()) < 0.01 * work);  // all that the traction did is there as energy
  const double scale = 1 / way(period) / std::sqrt(double(place.size()));
  return {std::sqrt(sum[0]) * scale, std::sqrt(sum[1]) * scale};
}

}  // namespace

TEST_CASE("traction: a bar's pulled end sends out the exact elastic wave", "[load]") {
  const Errors coarse = pull_error<schemes::QuadraticFlipUsl>(0.5e-6),
               middle = pull_error<schemes::QuadraticFlipUsl>(0.25e-6),
               fine = pull_error<schemes::QuadraticFlipUsl>(0.125e-6);
  CAPTURE(coarse.at_centre, middle.at_centre, fine.at_centre, coarse.at_face, middle.at_face, fine.at_face);
  // the force acts at the last particle's centre, but on all of the mass up to the face: the wave comes from there
  CHECK(std::log2(coarse.at_face / middle.at_face) == Approx(2).margin(0.1));
  CHECK(std::log2(middle.at_face / fine.at_face) == Approx(2).margin(0.1));
  CHECK(fine.at_face < 3e-4);
  CHECK(std::log2(middle.at_centre / fine.at_centre) == Approx(1).margin(0.2));
}

namespace {

// a load on a surface is paid for where there is one
template <class... Loads>
using Body = decltype(Solver{grid::Cartesian<3>{}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, linear,
                             Loads{}...});
static_assert(Body<load::Traction<3>>::bytes_per_particle<> == Body<>::bytes_per_particle<> + 8);
static_assert(Body<load::BodyForce<3>>::bytes_per_particle<> == Body<>::bytes_per_particle<>);
static_assert(std::is_empty_v<passes::Surface<std::tuple<load::BodyForce<3>>, 3>>);

}  // namespace
