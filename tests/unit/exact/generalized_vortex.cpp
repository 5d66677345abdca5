// The generalized vortex against differences of its own displacement.
#include <mote/exact/generalized_vortex.hpp>
#include <mote/load/body_force.hpp>
#include <numbers>

#include "catch.hpp"
#include "unit/exact/momentum.hpp"

namespace {

using namespace mote;
using exact::GeneralizedVortex;
using exact::NeoHookean;
using exact::VortexStart;

const NeoHookean soft = NeoHookean::from_young(1000, 1000, 0.3);
const GeneralizedVortex<2> resting{{.material = soft}};
const GeneralizedVortex<2> moving{{.material = soft, .start = VortexStart::moving}};
const GeneralizedVortex<3> deep{{.material = NeoHookean{.rho0 = 2, .lambda = 7, .mu = 3},
                                 .amplitude = -0.6,
                                 .period = 2.5,
                                 .inner = 1,
                                 .outer = 2}};

template <int D>
void check(const GeneralizedVortex<D>& s) {
  const auto& p = s.parameters();
  test::Departures worst;
  for (int i = 0; i < 60; ++i) {
    // from a tenth of the width inside the hole to a tenth outside: the force is smooth there
    const double r = p.inner + (p.outer - p.inner) * (-0.1 + 1.2 * std::fmod(0.618 * i, 1.0)), angle = 0.7 * i;
    Vec<double, D> point{};
    point[0] = r * std::cos(angle);
    point[1] = r * std::sin(angle);
    if constexpr (D == 3) point[2] = 0.3;
    test::depart(worst, s, point, (i + 0.4) / 60 * p.period, 1e-3 * (p.outer - p.inner), 4e-3 * p.period);
  }
  // noise of the second differences 1e-16/(1e-3 width)^2 = 4e-10, of P's slope under gamma up to 6; truncation of the
  // motion in time (2 pi 4e-3)^6/140 = 2e-12 for each of the harmonics that an angle of A rad makes
  CHECK(worst.velocity < 3e-10);
  CHECK(worst.inertia < 1e-10);
  CHECK(worst.gradient < 1e-11);
  CHECK(worst.stress < 1e-10);
  CHECK(worst.momentum < 3e-9);
  CHECK(worst.inverse < 1e-13);
}

TEST_CASE("the generalized vortex balances momentum") {
  check(resting);
  check(moving);
  check(deep);
}

TEST_CASE("the vortex's stress is pure shear along circles, and its edges are free and at rest") {
  const double t = 0.3;
  for (const double r : {0.8, 0.95, 1.0, 1.2}) {
    const Vec<double, 2> point{r * std::cos(0.4), r * std::sin(0.4)}, x = resting.position(point, t);
    const double c = x[0] / r, s = x[1] / r, d = 1e-6;
    const double gamma = r * (resting.angle(r + d, t) - resting.angle(r - d, t)) / (2 * d);
    const Mat<double, 3> to_ring{c, s, 0, -s, c, 0, 0, 0, 1};
    const auto sigma = rotate(to_ring, resting.stress(point, t));
    CHECK(det(resting.deformation_gradient(point, t)) == Approx(1).epsilon(1e-14));
    CHECK(sigma(0, 0) == Approx(0).margin(1e-12 * soft.mu));
    CHECK(sigma(0, 1) == Approx(soft.mu * gamma).margin(1e-8 * soft.mu));
    CHECK(sigma(1, 1) == Approx(soft.mu * gamma * gamma).margin(1e-8 * soft.mu));
    CHECK(norm(x) == Approx(r).epsilon(1e-15));
  }
  for (const double r : {0.75, 1.25}) {
    CHECK(resting.angle(r, t) == 0);
    CHECK(norm(resting.displacement({r, 0}, t)) == 0);
    CHECK(norm(resting.velocity({0, r}, t)) == 0);
    const auto sigma = resting.stress({r, 0}, t);
    CHECK(ddot(sigma, sigma) == Approx(0).margin(1e-24 * soft.mu * soft.mu));
  }
  CHECK(resting.angle(1, 0.5) == Approx(1).epsilon(1e-15));
  CHECK(resting.angle(1, 1) == Approx(0).margin(1e-30));
}

TEST_CASE("the vortex starts as it says") {
  const Vec<double, 2> point{0.6, 0.8};
  CHECK(norm(resting.displacement(point, 0)) == 0);
  CHECK(norm(resting.velocity(point, 0)) == 0);
  CHECK(norm(moving.displacement(point, 0)) == 0);
  CHECK(moving.velocity(point, 0)[0] == Approx(-0.8 * std::numbers::pi).epsilon(1e-14));
  CHECK(moving.velocity(point, 0)[1] == Approx(0.6 * std::numbers::pi).epsilon(1e-14));
}

TEST_CASE("a load takes the vortex's force, wherever a node may be") {
  const load::BodyForce<2> load{resting.body_force_field()};
  const Vec<double, 2> point{0.3, -0.9}, x = resting.position(point, 0.2), b = resting.body_force(point, 0.2);
  CHECK(norm(load.acceleration(x, 0.2) - b) < 1e-13 * norm(b));
  CHECK(norm(load.acceleration({0, 0}, 0.2)) == 0);
  for (const double far : {1e-12, 0.1, 3.0}) CHECK(std::isfinite(norm(load.acceleration({far, 0}, 0.2))));
}

TEST_CASE("the generalized vortex refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(GeneralizedVortex<2>({.material = soft, .period = 0}), Contains("0 s"));
  CHECK_THROWS_WITH(GeneralizedVortex<2>({.material = soft, .inner = 2}), Contains("2 and 1.25"));
  CHECK_THROWS_AS(GeneralizedVortex<2>({.material = soft, .amplitude = std::nan("")}), InputError);
}

}  // namespace
