// The axis-aligned manufactured solution against differences of its own displacement.
#include <mote/exact/axis_aligned.hpp>
#include <mote/load/body_force.hpp>
#include <numbers>

#include "catch.hpp"
#include "unit/exact/momentum.hpp"

namespace {

using namespace mote;
using exact::AxisAligned;
using exact::NeoHookean;

const NeoHookean soft = NeoHookean::from_young(1, 1e4, 0.3);
const AxisAligned<2> paper{
    {.material = soft, .amplitude = {0.05, 0.05}, .speed = soft.bar_speed(), .phase = {0, std::numbers::pi}}};
const AxisAligned<3> box{{.material = NeoHookean{.rho0 = 3, .lambda = 5, .mu = 2},
                          .amplitude = {0.1, -0.07, 0.15},
                          .speed = 1.7,
                          .phase = {0.3, 1.2, -2},
                          .length = {1, 0.8, 1.5}}};

template <int D>
void check(const AxisAligned<D>& s) {
  const double period = 2 / s.parameters().speed;
  test::Departures worst;
  for (int i = 0; i < 40; ++i) {
    Vec<double, D> point{};
    for (int a = 0; a < D; ++a) point[a] = std::fmod(0.37 + (0.61803 + 0.1 * a) * i, 1.0) * s.parameters().length[a];
    test::depart(worst, s, point, (i + 0.4) / 40 * period, 2e-3, 4e-3 * period);
  }
  // noise of the second differences 1e-16/(2e-3)^2 = 3e-11, truncation (2 pi 4e-3)^6/140 = 2e-12
  CHECK(worst.velocity < 1e-10);
  CHECK(worst.inertia < 1e-10);
  CHECK(worst.gradient < 1e-11);
  CHECK(worst.stress < 1e-10);
  CHECK(worst.momentum < 3e-9);
  CHECK(worst.inverse < 1e-13);
}

TEST_CASE("the axis-aligned solution balances momentum") {
  check(paper);
  check(box);
  check(AxisAligned<1>{{.material = soft, .amplitude = {0.1}, .speed = 80, .phase = {1}}});
}

TEST_CASE("the axis-aligned solution is the paper's") {
  const double pi = std::numbers::pi, t = 0.004, c = soft.bar_speed();
  CHECK(c == Approx(100).epsilon(1e-14));
  const Vec<double, 2> point{0.21, 0.64};
  const double ux = 0.05 * std::sin(2 * pi * point[0]) * std::sin(c * pi * t);
  const double uy = 0.05 * std::sin(2 * pi * point[1]) * std::sin(c * pi * t + pi);
  CHECK(paper.displacement(point, t)[0] == Approx(ux).epsilon(1e-13));
  CHECK(paper.displacement(point, t)[1] == Approx(uy).epsilon(1e-13));
  // as printed: b_x = pi^2 u_x (4 mu/rho0 - c^2 - 4 [lambda (K - 1) - mu]/(rho0 F_xx^2)), K = ln(F_xx F_yy)
  const Mat<double, 3> f = paper.deformation_gradient(point, t);
  const double k = std::log(f(0, 0) * f(1, 1));
  const double b = pi * pi * ux * (4 * soft.mu - c * c - 4 * (soft.lambda * (k - 1) - soft.mu) / (f(0, 0) * f(0, 0)));
  CHECK(paper.body_force(point, t)[0] == Approx(b).epsilon(1e-13));
}

TEST_CASE("faces of the axis-aligned box do not move along their normals, nor do they shear") {
  for (const double a : {0.0, 1.0})
    for (const double b : {0.3, 0.8}) {
      CHECK(std::abs(paper.displacement({a, b}, 0.003)[0]) < 1e-16);
      CHECK(std::abs(paper.displacement({b, a}, 0.003)[1]) < 1e-16);
      CHECK(paper.stress({a, b}, 0.003)(0, 1) == 0);
    }
  CHECK(paper.stress({0.1, 0.3}, 0.003)(2, 2) != 0);  // plane strain
}

TEST_CASE("a load takes the axis-aligned solution's force") {
  const load::BodyForce<3> load{box.body_force_field()};
  const Vec<double, 3> point{0.2, 0.5, 1.1}, x = box.position(point, 0.4);
  CHECK(norm(load.acceleration(x, 0.4) - box.body_force(point, 0.4)) < 1e-12 * norm(box.body_force(point, 0.4)));
}

TEST_CASE("neo-Hookean constants are consistent") {
  CHECK(soft.young() == Approx(1e4).epsilon(1e-14));
  CHECK(soft.poisson() == Approx(0.3).epsilon(1e-14));
  CHECK(soft.bulk_modulus() == Approx(1e4 / (3 * 0.4)).epsilon(1e-14));
  // the stress of a small uniaxial strain is lambda + 2 mu times it: the difference is of second order
  Mat<double, 3> f = Mat<double, 3>::identity();
  f(0, 0) += 1e-6;
  CHECK(soft.stress(f)(0, 0) == Approx(1e-6 * std::pow(soft.longitudinal_speed(), 2)).epsilon(1e-5));
  CHECK(soft.stress(f)(1, 1) == Approx(1e-6 * soft.lambda).epsilon(1e-5));
  CHECK_THROWS_AS(NeoHookean::from_young(1, 1, 0.5), InputError);
  CHECK_THROWS_AS(NeoHookean::from_young(1, -1, 0.3), InputError);
  CHECK_THROWS_AS(NeoHookean::from_young(0, 1, 0.3), InputError);
}

TEST_CASE("the axis-aligned solution refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(AxisAligned<2>({.material = soft, .amplitude = {0.05, 0.16}, .speed = 1}), Contains("0.16 m"));
  CHECK_THROWS_WITH(AxisAligned<2>({.material = soft, .amplitude = {0.05, 0.05}, .speed = -1}), Contains("-1 m/s"));
  CHECK_THROWS_WITH(AxisAligned<1>({.material = NeoHookean{.rho0 = 1, .mu = 0}, .amplitude = {0.05}, .speed = 1}),
                    Contains("mu is 0 Pa"));
}

}  // namespace
