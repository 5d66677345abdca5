/// \file
/// What the default (quadratic AffineFlip USL) survives in one dimension, and why linear FLIP with USL does not.
/// Limits of the other schemes: docs/stability.md.
#include "line.hpp"

#include "catch.hpp"

namespace {

using namespace stability;
using LinearFlipUsl = Scheme<shape::Linear, transfer::Flip, update::Usl>;
using QuadraticApicUsl = Scheme<shape::QuadraticBSpline, transfer::Apic, update::Usl>;
using Catch::Matchers::ContainsSubstring;

/// (c0/c)^2: what of the modulus a pure change of volume feels.
const double bulk = 5350.0 * 5350 / spring.sound_speed2(spring.initial<double, 1>());

}  // namespace

// The last node's mass is w m, its force -sigma V w'/h, so f/m gives it dv = dt sigma/(rho h) w'/w, and the strain that
// the particle sees of that is courant^2 strain w'^2/w: for hats w'^2/w = 1/w, for quadratic splines 2. For these the
// next two nodes add 2.4 and -4/15: their f/m are 1.5/0.625 and 0.5/1.875, the particle's slopes 1 and -1. The default
// adds tail (1 - S+ S) dv; (1 - S+ S) dv is nowhere larger than dv in the norm of the masses, and here nearly dv at the
// last node.
TEST_CASE("a node with next to no mass strains linear hats without bound and quadratic splines by nothing much",
          "[stability][surface]") {
  const int digits = GENERATE(2, 4, 6, 8, 10, 12);
  const double part = std::pow(10, -digits), limit = bulk * (2 + 2.4 - 4.0 / 15),
               most = 1 + transfer::AffineFlip{}.tail;
  const auto linear = let_go<LinearFlipUsl>(part), quadratic = let_go<QuadraticApicUsl>(part),
             sharpened = let_go<Default>(part);
  CAPTURE(part, linear.strain, quadratic.strain, linear.kick, quadratic.kick);
  CHECK(linear.least_mass == Approx(part).epsilon(1e-3 + 5e-14 / part));  // round-off of a place near 104 h
  CHECK(quadratic.least_mass == Approx(part).epsilon(1e-3));
  CHECK(linear.kick == Approx(bulk / linear.least_mass).epsilon(1e-3));
  CHECK(-linear.strain == Approx(bulk / linear.least_mass).epsilon(0.05));
  CHECK(quadratic.kick == Approx(bulk * std::sqrt(2 / part)).epsilon(1e-3));
  CHECK(-quadratic.strain == Approx(limit).epsilon(4 * std::sqrt(part) + 1e-5));
  CHECK(-quadratic.strain < limit * (1 + 1e-5));
  CHECK(std::abs(sharpened.kick) < most * bulk * std::sqrt(2 / part));
  CHECK(std::abs(sharpened.strain) < most * limit);
}

TEST_CASE("a free bar swings quietly wherever its surface lies in a cell, down to nodal masses of 1e-12",
          "[stability][surface]") {
  for (int digits = 1; digits <= 12; ++digits) {
    const double most = swing<Default>(std::pow(10, -digits));
    CAPTURE(digits, most);
    CHECK(most < ripple(0.4, 4));
  }
}

// courant^2 pull (c0/c)^2/part = 110: the first step turns the last particle inside out, and must be reported
TEST_CASE("linear FLIP with USL is lost when a surface under tension barely reaches into a cell",
          "[stability][surface]") {
  CHECK(std::isinf(release<LinearFlipUsl>(1e-6, 1e-3)));
  CHECK(release<Default>(1e-6, 1e-3) < 2);
}

TEST_CASE("the default's bar gains no energy up to a Courant number of 0.75", "[stability]") {
  const double courant = GENERATE(0.1, 0.2, 0.4, 0.6, 0.75), strain = GENERATE(1e-3, 0.05);
  CAPTURE(courant, strain);
  const auto v = vibrate<Default>({.strain = strain, .courant = courant}, {20});
  CHECK(v.most_energy < ripple(courant) + strain * strain);  // the ripple is that of small strains
  CHECK(v.energy[0] < (courant < 0.6 ? 1 : 1.002));  // somewhere in the ripple
}

TEST_CASE("at a Courant number of 1 the default's bar does", "[stability]") {
  CHECK(vibrate<Default>({.courant = 1}, {20}).blew_up());
}

TEST_CASE("drift of the default's bar over 20 periods", "[stability]") {
  const auto v = vibrate<Default>({}, {20});
  CHECK(v.amplitude[0] == Approx(1).epsilon(0.01));
  CHECK(v.energy[0] == Approx(1).epsilon(0.02));
}

TEST_CASE("drift of the default's bar over 1000 periods", "[stability][slow]") {
  const auto v = vibrate<Default>({}, {20, 1000});
  CHECK_FALSE(v.end.failed());
  CHECK(v.most_energy < ripple(0.4));
  CHECK(v.amplitude[1] == Approx(1).epsilon(0.07));
}

// With particles crossing cells, stresses that cancel on the nodes add up over hundreds of periods; nothing on the grid
// sees or damps them, and they must stay below what the swing has lost (docs/stability.md).
TEST_CASE("drift of the default's bar over 1000 periods of strain 0.05", "[stability][slow]") {
  CHECK(vibrate<Default>({.strain = 0.05}, {1000}).most_energy < ripple(0.4) + 0.05 * 0.05);
}

TEST_CASE("1 to 27 particles per cell, and jittered lattices", "[stability]") {
  for (const int n : {1, 2, 3, 8, 27}) {
    CAPTURE(n);
    CHECK(vibrate<Default>({.per_axis = n}, {5}).most_energy < ripple(0.4));
  }
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    CHECK(vibrate<Default>({.strain = 0.01, .jitter = 0.5, .seed = seed}, {5}).most_energy < ripple(0.4));
  }
}

TEST_CASE("flung at the wall up to 270 GPa", "[stability][violence]") {
  for (const double speed : {1000.0, 2500.0, 5000.0, 6870.0}) {
    const auto c = crash<Default>(speed);
    CAPTURE(speed, c.end.error, c.pressure, c.middle);
    CHECK_FALSE(c.end.failed());
    CHECK(c.finite);
    // what rings in a shock without viscosity shifts the mean near the pole of the equation of state
    if (speed <= 5000) CHECK(c.middle == Approx(1).epsilon(0.055));
    CHECK(crash<Default>(speed, 0.4, viscous_metal).middle == Approx(1).epsilon(0.02));
  }
}

TEST_CASE("beyond the pole of the equation of state there is a NumericalError, never a number",
          "[stability][violence]") {
  const double pole = 1 - 1 / 1.34;
  for (const double speed : {1e4, 2e4, 5e4, 1e5}) {
    const auto c = crash<Default>(speed, 0.9);
    CAPTURE(speed, c.end.error, c.volume.least);
    if (c.end.failed())
      CHECK_THAT(c.end.error, ContainsSubstring("particle"));
    else
      CHECK((c.finite && c.volume.least > pole));
  }
  // a step that leaps over the pole, whatever pressure would have said
  const auto solver = make_line<Default>(metal, 2);
  solver->fill(cells(96, 104), metal, {.per_axis = 2, .velocity = [](const Vec<double, 1>& x) {
                                         return Vec<double, 1>{-1e5 * (x[0] / h - 100)};
                                       }});
  CHECK_THROWS_AS(solver->run({.until = 1e-8}), NumericalError);
  CHECK_THROWS_AS(solver->step(), UsageError);
}

TEST_CASE("torn from the wall beyond any spall strength", "[stability][violence]") {
  for (const double speed : {400.0, 1000.0, 5000.0}) {
    const auto t = tear<Default>(speed);
    CAPTURE(speed, t.end.error, t.pressure.least, t.pressure.most, t.volume.most);
    CHECK_FALSE(t.end.failed());
    CHECK(t.finite);
  }
}

TEST_CASE("bodies that collide at 5 km/s", "[stability][violence]") {
  const auto c = collide<Default>(5000);
  CAPTURE(c.end.error, c.pressure, c.energy);
  CHECK_FALSE(c.end.failed());
  CHECK(c.finite);
  CHECK(std::abs(c.momentum) < 1e-10);
}

TEST_CASE("dust pulled to three times its length keeps its volume's account", "[stability][stretch]") {
  const int per_axis = GENERATE(2, 3);
  const auto s = stretch<Default>(per_axis);
  CAPTURE(per_axis, s.least, s.most);
  CHECK(s.least == Approx(1).epsilon(0.002));
  CHECK(s.most == Approx(1).epsilon(0.002));
}

TEST_CASE("a single particle flies over 1000 cells", "[stability]") {
  const auto f = fly_alone<Default>();
  CHECK_FALSE(f.end.failed());
  CHECK(f.speed < 1e-9);
  CHECK(f.volume.least > 0.9);
  CHECK(f.volume.most < 1.1);
}
