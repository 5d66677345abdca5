// A quarter of the cavity scene between symmetry planes moves as that quarter of the whole does: to round-off, although
// the project asks for 1e-6 only.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <mote/mote.hpp>

#include "catch.hpp"

namespace {

using namespace mote;

constexpr double um = 1e-6;
const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                         strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6},
                         heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

using Place = std::array<long, 3>;  // initial position, in units of 10 pm
using Velocities = std::map<Place, Vec<double, 3>>;

/// Velocities at 3 ns of the particles that began in x, y > 0.
template <class Scheme, class... Sides>
Velocities run(const Scheme& scheme, geometry::Method fill, const Sides&... sides) {
  Solver solver{grid::Cartesian<3>{.spacing = 2.5 * um},
                scheme.shape,
                scheme.transfer,
                scheme.update,
                timestep::Fixed{0.4 * 2.5 * um / 7500},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                aluminium,
                sides...};
  const geometry::Box<3> block{.lower = {-20 * um, -20 * um, 0}, .upper = {20 * um, 20 * um, 50 * um}};
  const geometry::Ball<3> cavity{.centre = {0, 0, 10 * um}, .radius = 5 * um};
  solver.fill(block - cavity, aluminium, {.per_axis = 2, .velocity = {0, 0, 100}, .method = fill});
  auto& p = solver.particles();
  const auto id = p.template column<field::Id>();
  std::vector<Place> places(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto x = p.template get<field::Position>(i);
    for (int a = 0; a < 3; ++a) places[id[i]][std::size_t(a)] = std::lround(x[a] / (1e-5 * um));
  }
  solver.run({.until = 3e-9});
  Velocities velocities;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (places[id[i]][0] > 0 && places[id[i]][1] > 0) velocities[places[id[i]]] = p.template get<field::Velocity>(i);
  REQUIRE(velocities.size() == std::size_t(std::count_if(places.begin(), places.end(),
                                                         [](const Place& at) { return at[0] > 0 && at[1] > 0; })));
  return velocities;
}

template <class Scheme>
void check(const Scheme& scheme) {
  using boundary::Periodic, boundary::Symmetry;
  const auto fill = GENERATE(geometry::Method::lattice, geometry::Method::fraction);
  INFO((fill == geometry::Method::lattice ? "lattice" : "fraction"));
  const Velocities whole = run(scheme, fill, Periodic{.axis = axis::x, .from = -20 * um, .to = 20 * um},
                               Periodic{.axis = axis::y, .from = -20 * um, .to = 20 * um});
  const Velocities quarter =
      run(scheme, fill, Symmetry{.side = side::x_min, .at = 0}, Symmetry{.side = side::x_max, .at = 20 * um},
          Symmetry{.side = side::y_min, .at = 0}, Symmetry{.side = side::y_max, .at = 20 * um});
  REQUIRE(quarter.size() == whole.size());
  double largest = 0, difference = 0, lateral = 0;
  for (const auto& [place, v] : whole) {
    largest = std::max(largest, norm(v));
    lateral = std::max(lateral, std::hypot(v[0], v[1]));
    const double d = norm(v - quarter.at(place));
    if (!std::isfinite(d)) FAIL("a velocity is not a number");
    difference = std::max(difference, d);
  }
  CHECK(lateral > 0.1 * largest);  // the cavity is felt
  CHECK(difference < 1e-9 * largest);
}

template <class S, class X, class U>
struct Scheme {
  S shape;
  X transfer;
  U update;
};

TEST_CASE("a quarter equals its part of the whole: quadratic APIC USL") {
  check(Scheme<shape::QuadraticBSpline, transfer::Apic, update::Usl>{});
}
TEST_CASE("a quarter equals its part of the whole: quadratic FLIP USL") {
  check(Scheme<shape::QuadraticBSpline, transfer::Flip, update::Usl>{});
}
TEST_CASE("a quarter equals its part of the whole: linear FLIP MUSL") {
  check(Scheme<shape::Linear, transfer::Flip, update::Musl>{});
}
TEST_CASE("a quarter equals its part of the whole: contiguous GIMP FLIP USL") {
  check(Scheme<shape::ContiguousGimp, transfer::Flip, update::Usl>{});
}
TEST_CASE("a quarter equals its part of the whole: GIMP FLIP MUSL") {
  check(Scheme<shape::Gimp, transfer::Flip, update::Musl>{});
}
TEST_CASE("a quarter equals its part of the whole: cubic APIC USL") {
  check(Scheme<shape::CubicBSpline, transfer::Apic, update::Usl>{});
}
TEST_CASE("a quarter equals its part of the whole: cubic FLIP MUSL") {
  check(Scheme<shape::CubicBSpline, transfer::Flip, update::Musl>{});
}

}  // namespace
