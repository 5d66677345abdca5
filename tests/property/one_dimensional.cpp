// A column without a cavity stays one-dimensional in three dimensions and in plane strain, and equals the 1-D run.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <mote/mote.hpp>

#include "catch.hpp"

namespace {

using namespace mote;

const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                         strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6},
                         heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

constexpr double h = 1e-6, height = 25e-6;

/// Position, velocity and pressure along the column by initial height, with their largest and smallest value there.
struct Range {
  double low = INFINITY, high = -INFINITY;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
};
struct Level {
  Range position, velocity, pressure;
};
using Profile = std::map<long, Level>;  // by initial height, in quarters of a cell

/// A column along the last axis, launched off a wall, for 6 ns: the wave has come back from the free end.
template <int D, class Shape, class Transfer, class Update, class... Sides>
Profile run(const Shape& shape, const Transfer& transfer, const Update& update, double launch, double width,
            const Sides&... sides) {
  constexpr int n = D - 1;
  Solver solver{grid::Cartesian<D>{.spacing = h},
                shape,
                transfer,
                update,
                timestep::Fixed{0.4 * h / 7500},
                boundary::RigidWall{.side = Side{n, false}, .at = 0},
                aluminium,
                sides...};
  Vec<double, D> lower{}, upper = Vec<double, D>::filled(width), velocity{};
  upper[n] = height, velocity[n] = launch;
  solver.fill(geometry::Box<D>{.lower = lower, .upper = upper}, aluminium, {.per_axis = 2, .velocity = velocity});
  auto& p = solver.particles();
  std::vector<long> level(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    level[p.template column<field::Id>()[i]] = std::lround(p.template column<field::Position>(n)[i] / h * 4);
  while (solver.time() < 6e-9) solver.step();
  Profile profile;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<double, D, typename std::remove_cvref_t<decltype(p)>::list> v;
    p.load(i, v);
    Level& l = profile[level[p.template column<field::Id>()[i]]];
    l.position.add(get<field::Position>(v)[n]);
    l.velocity.add(get<field::Velocity>(v)[n]);
    l.pressure.add(aluminium.pressure(v));
  }
  return profile;
}

/// Largest variation across planes, and largest difference to the line, relative to the largest value of the line.
struct Difference {
  double across = 0, to_line = 0;
};
Difference difference(const Profile& body, const Profile& line, Range Level::*what) {
  double scale = 0;
  for (const auto& [level, v] : line) scale = std::max({scale, std::abs((v.*what).low), std::abs((v.*what).high)});
  Difference d;
  for (const auto& [level, v] : body) {
    const Range &r = v.*what, &exact = line.at(level).*what;
    d.across = std::max(d.across, (r.high - r.low) / scale);
    d.to_line = std::max({d.to_line, std::abs(r.high - exact.low) / scale, std::abs(r.low - exact.low) / scale});
  }
  return d;
}
void check_equal(const Profile& body, const Profile& line) {
  REQUIRE(body.size() == line.size());
  for (const auto what : {&Level::position, &Level::velocity, &Level::pressure}) {
    const Difference d = difference(body, line, what);
    CHECK(d.across < 1e-9);
    CHECK(d.to_line < 1e-9);
  }
}

template <class Shape, class Transfer, class Update>
void check_scheme(const Shape& shape, const Transfer& transfer, const Update& update) {
  const double launch = GENERATE(100.0, -100.0);
  INFO("launch " << launch);
  const Profile line = run<1>(shape, transfer, update, launch, 0);
  REQUIRE(line.size() == 50);
  for (const int cells : {4, 1}) {
    const double w = cells * h;
    INFO(cells << " cells wide");
    using boundary::Periodic, boundary::Symmetry;
    const Periodic x{.axis = axis::x, .from = 0, .to = w}, y{.axis = axis::y, .from = 0, .to = w};
    const Symmetry left{.side = side::x_min, .at = 0}, right{.side = side::x_max, .at = w};
    const Symmetry front{.side = side::y_min, .at = 0}, back{.side = side::y_max, .at = w};
    const auto check = [&]<int D>(std::integral_constant<int, D>, const char* sides, const auto&... parts) {
      INFO(D << "-D, " << sides);
      check_equal(run<D>(shape, transfer, update, launch, w, parts...), line);
    };
    constexpr std::integral_constant<int, 2> plane{};
    constexpr std::integral_constant<int, 3> space{};
    check(plane, "periodic", x);
    check(plane, "symmetry", left, right);
    check(space, "periodic", x, y);
    check(space, "symmetry", left, right, front, back);
  }
}

TEST_CASE("a column stays one-dimensional and equals the 1-D run: linear FLIP MUSL") {
  check_scheme(shape::Linear{}, transfer::Flip{}, update::Musl{});
}
TEST_CASE("a column stays one-dimensional and equals the 1-D run: quadratic APIC USL") {
  check_scheme(shape::QuadraticBSpline{}, transfer::Apic{}, update::Usl{});
}
TEST_CASE("a column stays one-dimensional and equals the 1-D run: quadratic FLIP USL") {
  check_scheme(shape::QuadraticBSpline{}, transfer::Flip{}, update::Usl{});
}
TEST_CASE("a column stays one-dimensional and equals the 1-D run: cubic APIC USL") {
  check_scheme(shape::CubicBSpline{}, transfer::Apic{}, update::Usl{});
}
TEST_CASE("a column stays one-dimensional and equals the 1-D run: cubic FLIP MUSL") {
  check_scheme(shape::CubicBSpline{}, transfer::Flip{}, update::Musl{});
}

}  // namespace
