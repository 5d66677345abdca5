// The vibrating bar against differences of the wave equation, energy and the published numbers.
#include <mote/exact/vibrating_bar.hpp>
#include <numbers>

#include "catch.hpp"
#include "unit/exact/momentum.hpp"

namespace {

using namespace mote;
using exact::BarEnds;
using exact::VibratingBar;

const VibratingBar published{{.length = 25, .modulus = 100, .density = 1, .speed = 0.1}};

TEST_CASE("the vibrating bar has the published numbers") {
  CHECK(published.frequency() == Approx(0.6283).epsilon(1e-4));
  CHECK(published.mean_velocity(0) == Approx(0.06366).epsilon(1e-4));
  CHECK(published.velocity(25, 0) == Approx(0.1).epsilon(1e-15));
  CHECK(published.period() == Approx(10).epsilon(1e-14));
}

TEST_CASE("the vibrating bar satisfies the wave equation, its ends and the balance of energy") {
  for (const BarEnds ends : {BarEnds::fixed_free, BarEnds::fixed_fixed})
    for (const int mode : {1, 2, 5}) {
      INFO("mode " << mode);
      const double length = 2, modulus = 7, density = 3;
      const VibratingBar bar{
          {.length = length, .modulus = modulus, .density = density, .speed = -0.3, .mode = mode, .ends = ends}};
      const double t = 0.37 * bar.period(), dx = 0.01 / mode, dt = 0.01 / bar.frequency();
      const double stress_scale = modulus * 0.3 / bar.wave_speed(), accel_scale = 0.3 * bar.frequency();
      // sixth order with steps of 0.015 to 0.03 rad: truncation (0.03)^6/140 = 5e-12, noise 1e-16/(0.01)^2 = 1e-12
      for (const double x : {0.1, 0.8, 1.7}) {
        const auto in_time = [&](double e) { return bar.displacement(x, t + e); };
        const auto along = [&](double e) { return bar.displacement(x + e, t); };
        CHECK(bar.velocity(x, t) == Approx(test::slope(in_time, dt)).margin(1e-10 * 0.3));
        CHECK(bar.stress(x, t) == Approx(modulus * test::slope(along, dx)).margin(1e-10 * stress_scale));
        CHECK(density * test::bend(in_time, dt) ==
              Approx(modulus * test::bend(along, dx)).margin(1e-9 * density * accel_scale));
      }
      CHECK(bar.displacement(0, t) == 0);
      CHECK(bar.displacement(1, 0) == 0);
      if (ends == BarEnds::fixed_free)
        CHECK(bar.stress(length, t) == Approx(0).margin(1e-14 * stress_scale));
      else
        CHECK(bar.displacement(length, t) == Approx(0).margin(1e-15));
      double kinetic = 0, strain = 0, mean = 0;  // the mid-point rule is exact for whole waves
      const int n = 1000;
      for (int i = 0; i < n; ++i) {
        const double x = (i + 0.5) / n * length;
        kinetic += 0.5 * density * std::pow(bar.velocity(x, t), 2) * length / n;
        strain += 0.5 / modulus * std::pow(bar.stress(x, t), 2) * length / n;
        mean += bar.velocity(x, t) / n;
      }
      CHECK(bar.kinetic_energy(t) == Approx(kinetic).epsilon(1e-12));
      CHECK(bar.strain_energy(t) == Approx(strain).epsilon(1e-12));
      CHECK(bar.mean_velocity(t) == Approx(mean).epsilon(1e-4).margin(1e-15));  // second order: (5 pi/1000)^2/24 = 1e-5
    }
}

TEST_CASE("the vibrating bar refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(VibratingBar({.length = 0, .modulus = 1, .density = 1, .speed = 1}), Contains("length is 0 m"));
  CHECK_THROWS_WITH(VibratingBar({.length = 1, .modulus = -2, .density = 1, .speed = 1}), Contains("-2 Pa"));
  CHECK_THROWS_WITH(VibratingBar({.length = 1, .modulus = 1, .density = 0, .speed = 1}), Contains("0 kg/m^3"));
  CHECK_THROWS_WITH(VibratingBar({.length = 1, .modulus = 1, .density = 1, .speed = 1, .mode = 0}),
                    Contains("mode is 0"));
  CHECK_THROWS_AS(VibratingBar({.length = 1, .modulus = 1, .density = 1, .speed = std::nan("")}), InputError);
}

}  // namespace
