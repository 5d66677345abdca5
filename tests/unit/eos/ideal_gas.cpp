#include <mote/eos/ideal_gas.hpp>

#include <cmath>
#include <string>

#include "catch.hpp"

namespace {

using namespace mote;

const eos::IdealGas air{.rho0 = 1.2, .gamma = 1.4, .initial_pressure = 1e5};
const double all_x[] = {0.1, 0.2, 0.5, 0.9, 1, 1.1, 2, 10};

}  // namespace

TEST_CASE("ideal gas: P = (gamma - 1) rho E, E = E_ref + excess") {
  for (const double x : all_x)
    for (const double excess : {0.0, -1e4, 1e6}) {
      const double energy = 1e5 / (1.2 * 0.4) * std::pow(x, -0.4) + excess;
      CHECK(air.pressure(x, excess) == Approx(0.4 * 1.2 / x * energy).epsilon(1e-13));
      CHECK(air.internal_energy(x) + excess == Approx(energy).epsilon(1e-13));
      CHECK(isentropic_sound_speed2(air, x, excess) == Approx(1.4 * air.pressure(x, excess) * x / 1.2).epsilon(1e-12));
    }
  CHECK(air.pressure(0.5, 0.0) == Approx(1e5 * std::pow(2, 1.4)).epsilon(1e-14));
}

TEST_CASE("ideal gas: sound speed and energy against differences of the pressure") {
  for (const double x : all_x)
    for (const double excess : {0.0, 1e5}) {
      const double h = 1e-4 * x;
      const double slope = (air.pressure(x + h, excess) - air.pressure(x - h, excess)) / (2 * h);
      CHECK(air.bulk_sound_speed2(x, excess) == Approx(-x * x / 1.2 * slope).epsilon(1e-6));
      const double work = (air.reference_energy(x + h) - air.reference_energy(x - h)) / (2 * h);
      CHECK(-air.pressure(x, 0.0) / 1.2 == Approx(work).epsilon(1e-6));
    }
  CHECK(air.reference_energy(1.0) == 0);
  CHECK(air.reference_heating(0.5) == 0);
  CHECK_FALSE(air.admissible(0.0));
}

TEST_CASE("ideal gas: a strong shock compresses six times") {
  // the Hugoniot through rest: E - E0 = (P + P0)(V0 - V)/2
  const double x = 1 / 5.9, p0 = 1e5, v0 = 1 / 1.2;
  const double p = p0 * (6 - x) / (6 * x - 1);
  const double energy = air.internal_energy(1.0) + 0.5 * (p + p0) * (1 - x) * v0;
  CHECK(air.pressure(x, energy - air.internal_energy(x)) == Approx(p).epsilon(1e-12));
}

TEST_CASE("ideal gas: packs give what numbers give, single precision nearly so") {
  const Pack<double> x([](int i) { return all_x[i]; });
  const auto p = air.pressure(x, Pack<double>(1e4)), c2 = air.bulk_sound_speed2(x, Pack<double>(1e4));
  for (int i = 0; i < lanes; ++i) {
    CHECK(lane(p, i) == Approx(air.pressure(all_x[i], 1e4)).epsilon(1e-14));
    CHECK(lane(c2, i) == Approx(air.bulk_sound_speed2(all_x[i], 1e4)).epsilon(1e-14));
    CHECK(double(air.pressure(float(all_x[i]), 1e4f)) == Approx(air.pressure(all_x[i], 1e4)).epsilon(1e-5));
  }
}

TEST_CASE("ideal gas: impossible parameters are refused in a sentence") {
  const auto complaint = [](const eos::IdealGas& gas) -> std::string {
    try {
      gas.validate();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(complaint(air).empty());
  CHECK(complaint({.rho0 = 1, .gamma = 1, .initial_pressure = 1}) ==
        "mote: the ratio of the heat capacities gamma is 1; it must be > 1");
  CHECK(complaint({.rho0 = 0, .gamma = 2, .initial_pressure = 1}) ==
        "mote: the density rho0 is 0 kg/m^3; it must be > 0");
  CHECK(complaint({.rho0 = 1, .gamma = 2, .initial_pressure = 0}) ==
        "mote: the initial pressure is 0 Pa; it must be > 0");
}
