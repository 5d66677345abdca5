// The Hugoniot against the jump conditions, the equation of state, another way to the temperature, and limits.
#include <mote/exact/hugoniot.hpp>

#include "catch.hpp"

namespace {

using namespace mote;
using exact::Hugoniot;
using exact::ShockState;

const eos::MieGruneisen metal{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const heat::Adiabatic warmth{.specific_heat = 880, .initial_temperature = 300};
const Hugoniot aluminium{metal, warmth};

TEST_CASE("states on the Hugoniot conserve mass, momentum and energy and lie on the equation of state") {
  for (const double u : {1e-3, 1.0, 100.0, 1000.0, 5000.0, 20000.0}) {
    INFO("u " << u);
    const ShockState s = aluminium.from_particle_speed(u);
    CHECK(s.shock_speed == Approx(5350 + 1.34 * u).epsilon(1e-15));
    CHECK(s.density * (s.shock_speed - u) == Approx(2700 * s.shock_speed).epsilon(1e-13));
    CHECK(s.pressure == Approx(2700 * s.shock_speed * u).epsilon(1e-14));
    // q = 1 - x loses digits in weak shocks
    const double lost = 1e-15 / (1 - s.x);
    CHECK(s.energy == Approx(0.5 * s.pressure * (1 - s.x) / 2700).epsilon(1e-13 + lost));
    CHECK(s.pressure == Approx(metal.hugoniot_pressure(s.x)).epsilon(1e-13 + 8 * lost));
  }
  CHECK(aluminium.from_particle_speed(0).pressure == 0);
  CHECK(aluminium.from_particle_speed(0).temperature == 300);
}

TEST_CASE("the Hugoniot's three doors lead to the same state") {
  for (const double u : {0.5, 300.0, 4000.0}) {
    const ShockState s = aluminium.from_particle_speed(u);
    CHECK(aluminium.from_pressure(s.pressure).particle_speed == Approx(u).epsilon(1e-14));
    CHECK(aluminium.from_volume_ratio(s.x).particle_speed == Approx(u).epsilon(1e-11));  // 1e-16/(1 - x)
  }
  const Hugoniot linear{eos::MieGruneisen{.rho0 = 1000, .c0 = 2000}};
  CHECK(linear.from_pressure(1e9).particle_speed == Approx(500).epsilon(1e-15));
}

/// The temperature from energies instead of the equation of heat: down the isentrope from the initial state, whose
/// energy is integrated (dE = -P_s dV with P_s = P_H + (gamma/V)(E_s - E_H)), then at constant volume to E_H.
double temperature_by_energy(double x_end, int n) {
  const double g = metal.gamma0, cv = warmth.specific_heat;
  const auto hugoniot_energy = [&](double x) { return metal.hugoniot_pressure(x) * (1 - x) / (2 * metal.rho0); };
  const auto rate = [&](double x, double e) {
    return -(metal.hugoniot_pressure(x) / metal.rho0 + g * (e - hugoniot_energy(x)));
  };
  double e = 0, x = 1;
  const double h = (x_end - 1) / n;
  for (int i = 0; i < n; ++i) {
    const double a = rate(x, e), b = rate(x + h / 2, e + h / 2 * a), c = rate(x + h / 2, e + h / 2 * b),
                 d = rate(x + h, e + h * c);
    e += h / 6 * (a + 2 * b + 2 * c + d);
    x = 1 + (i + 1) * h;
  }
  return warmth.initial_temperature * std::exp(g * (1 - x_end)) + (hugoniot_energy(x_end) - e) / cv;
}

TEST_CASE("the temperature on the Hugoniot is that of its energy above the isentrope") {
  for (const double u : {10.0, 500.0, 2000.0, 8000.0}) {
    INFO("u " << u);
    const ShockState s = aluminium.from_particle_speed(u);
    // the energies are some 100 times the thermal part of a weak shock: 1e-14 of them
    CHECK(s.temperature == Approx(temperature_by_energy(s.x, 20000)).epsilon(1e-10));
  }
  // a weak shock heats beyond the isentrope by lambda c0^2 q^3/(3 cv), of third order in its strength
  const ShockState weak = aluminium.from_volume_ratio(0.999);
  const double isentrope = 300 * std::exp(1.96e-3), beyond = weak.temperature - isentrope;
  CHECK(beyond == Approx(1.34 * 5350 * 5350 * 1e-9 / (3 * 880)).epsilon(4e-3));  // next order: some 3 q
}

TEST_CASE("a cold Hugoniot has no temperature, one without gamma only the shock's own heat") {
  CHECK(std::isnan(Hugoniot{metal}.from_particle_speed(100).temperature));
  const eos::MieGruneisen plain{.rho0 = 2700, .c0 = 5350, .lambda = 1.34};
  const ShockState s = Hugoniot{plain, warmth}.from_particle_speed(2000);
  // heat: E_H less the work along the curve
  CHECK(880 * (s.temperature - 300) == Approx(s.energy - plain.reference_energy(s.x)).epsilon(1e-10));
}

TEST_CASE("the Hugoniot refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(aluminium.from_particle_speed(-1), Contains("-1 m/s"));
  CHECK_THROWS_AS(aluminium.from_particle_speed(std::nan("")), InputError);
  CHECK_THROWS_WITH(aluminium.from_pressure(-2), Contains("-2 Pa"));
  CHECK_THROWS_WITH(aluminium.from_volume_ratio(0.25), Contains("0.25") && Contains("0.253731"));
  CHECK_THROWS_WITH(aluminium.from_volume_ratio(1.1), Contains("1.1"));
  const Hugoniot half{eos::MieGruneisen{.rho0 = 1, .c0 = 100, .lambda = 0.5}};
  CHECK_THROWS_WITH(half.from_particle_speed(200), Contains("200 m/s"));
  CHECK_THROWS_AS((Hugoniot{eos::MieGruneisen{.rho0 = -1, .c0 = 100}}), InputError);
  CHECK_THROWS_AS((Hugoniot{metal, heat::Adiabatic{.specific_heat = 0}}), InputError);
}

}  // namespace
