// The manufactured bar against differences of its own displacement, and a solver fed with its force.
#include <mote/exact/axis_aligned.hpp>
#include <mote/exact/manufactured_bar.hpp>
#include <mote/load/body_force.hpp>
#include <numbers>

#include "catch.hpp"
#include "unit/exact/momentum.hpp"

namespace {

using namespace mote;
using exact::ManufacturedBar;

const ManufacturedBar paper{{.modulus = 1e4, .density = 1, .amplitude = 0.05}};
const ManufacturedBar longer{{.modulus = 3e3, .density = 2, .amplitude = -0.3, .length = 2.5}};

TEST_CASE("the manufactured bar balances momentum") {
  for (const ManufacturedBar* bar : {&paper, &longer}) {
    const double length = bar->parameters().length, period = bar->period();
    test::Departures worst;
    for (int i = 0; i < 23; ++i)
      for (int n = 0; n < 11; ++n)
        test::depart(worst, *bar, {(i + 0.3) / 23 * length}, (n + 0.2) / 11 * period, 2e-3 * length, 4e-3 * period);
    INFO("A " << bar->parameters().amplitude);
    // differences of sixth order of sines: (2 pi 4e-3)^6/140 = 2e-12 in time; their noise, 1e-16/(2e-3)^2 of u's own
    // size, is 3e-11, and F down to 0.25 in the longer bar adds its curvature
    CHECK(worst.velocity < 1e-10);
    CHECK(worst.inertia < 1e-10);
    CHECK(worst.gradient < 1e-11);
    CHECK(worst.stress < 1e-10);
    CHECK(worst.momentum < 3e-9);
    CHECK(worst.inverse < 1e-13);
  }
}

TEST_CASE("the manufactured bar is the paper's") {
  const double c = 100, pi = std::numbers::pi, t = 0.0037;
  CHECK(paper.speed() == Approx(c).epsilon(1e-15));
  CHECK(paper.period() == Approx(2 / c).epsilon(1e-15));
  for (const double point : {0.0, 0.11, 0.4, 0.77}) {
    const double u = 0.05 * std::sin(2 * pi * point) * std::cos(c * pi * t);
    const double f = 1 + 0.1 * pi * std::cos(2 * pi * point) * std::cos(c * pi * t);
    CHECK(paper.displacement({point}, t)[0] == Approx(u).epsilon(1e-14).margin(1e-17));
    CHECK(paper.body_force({point}, t)[0] ==
          Approx(c * c * pi * pi * u * (1 + 2 / (f * f))).epsilon(1e-13).margin(1e-12));
    CHECK(paper.stress({point}, t)(0, 0) == Approx(0.5e4 * (f - 1 / f)).epsilon(1e-13));
    CHECK(paper.stress({point}, t)(1, 1) == Approx(0).margin(1e-12));
  }
  for (const double end : {0.0, 1.0}) CHECK(std::abs(paper.displacement({end}, t)[0]) < 1e-16);
}

TEST_CASE("the manufactured bar is the axis-aligned solution in one dimension without lambda") {
  const exact::AxisAligned<1> same{{.material = longer.material(),
                                    .amplitude = {-0.3},
                                    .speed = longer.speed(),
                                    .phase = {std::numbers::pi / 2},
                                    .length = {2.5}}};
  CHECK(longer.material().bar_speed() == Approx(longer.speed()).epsilon(1e-15));
  for (const double x : {0.2, 1.0, 1.9}) {
    const double t = 0.013;
    CHECK(same.body_force_at({x}, t)[0] == Approx(longer.body_force_at({x}, t)[0]).epsilon(1e-12));
    CHECK(same.velocity_at({x}, t)[0] == Approx(longer.velocity_at({x}, t)[0]).epsilon(1e-12));
  }
}

TEST_CASE("a bar pressed almost flat is still inverted") {
  const ManufacturedBar bar{{.modulus = 1, .density = 1, .amplitude = 0.999 / (2 * std::numbers::pi)}};
  for (int i = -50; i <= 150; ++i) {  // also beyond the ends
    const double point = i / 100.0;
    // near the middle F = 1e-3 and x is flat: a round-off of 1e-16 in x is up to 1e-13 in X
    CHECK(bar.material_point(bar.position({point}, 0), 0)[0] == Approx(point).margin(3e-13));
  }
}

TEST_CASE("a load takes the manufactured bar's force") {
  const load::BodyForce<1> load{paper.body_force_field()};
  const Vec<double, 1> x = paper.position({0.2}, 0.001);
  CHECK(load.acceleration(x, 0.001)[0] == Approx(paper.body_force({0.2}, 0.001)[0]).epsilon(1e-13));
  CHECK(load.acceleration(x, 0.001)[0] != load.acceleration(x, 0.002)[0]);
  CHECK(paper.velocity_field(0.003)(paper.position({0.2}, 0.003))[0] ==
        Approx(paper.velocity({0.2}, 0.003)[0]).epsilon(1e-13));
}

TEST_CASE("the manufactured bar refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(ManufacturedBar({.modulus = 0, .density = 1, .amplitude = 0.1}), Contains("modulus is 0 Pa"));
  CHECK_THROWS_WITH(ManufacturedBar({.modulus = 1, .density = -1, .amplitude = 0.1}), Contains("-1 kg/m^3"));
  CHECK_THROWS_WITH(ManufacturedBar({.modulus = 1, .density = 1, .amplitude = 0.2}),
                    Contains("0.2 m") && Contains("0.159155"));
  CHECK_THROWS_AS(ManufacturedBar({.modulus = 1, .density = 1, .amplitude = std::nan("")}), InputError);
  CHECK_THROWS_WITH(ManufacturedBar({.modulus = 1, .density = 1, .amplitude = 0.2, .length = -1}), Contains("-1 m"));
}

}  // namespace
