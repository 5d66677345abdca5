#include <mote/eos/constant_gamma.hpp>

#include <cmath>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/heat/adiabatic.hpp>
#include <mote/material.hpp>
#include <mote/strength/von_mises.hpp>
#include <type_traits>

#include "catch.hpp"

namespace {

using namespace mote;

const eos::MieGruneisen aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const eos::ConstantGamma other{aluminium};
const double all_x[] = {0.4, 0.7, 0.9, 0.99, 1.01, 1.2, 1.5, 2};

}  // namespace

TEST_CASE("constant gamma: heat presses with gamma0 rho per unit of energy") {
  for (const double x : all_x) {
    CHECK(other.pressure(x, 1e6) - other.pressure(x, 0.0) == Approx(1.96 * 2700 / x * 1e6).epsilon(1e-10));
    CHECK(other.gamma_over_volume(x) * x == Approx(1.96).epsilon(1e-14));
    CHECK(other.pressure(x, 0.0) == Approx(aluminium.pressure(x, 0.0)).epsilon(1e-14));
    CHECK(other.reference_energy(x) == Approx(aluminium.reference_energy(x)).epsilon(1e-14));
    CHECK(other.reference_heating(x) == Approx(aluminium.reference_heating(x)).epsilon(1e-14));
    CHECK(other.internal_energy(x) == Approx(aluminium.internal_energy(x)).epsilon(1e-14));
  }
  CHECK(other.pressure(1.0, 1e6) == Approx(aluminium.pressure(1.0, 1e6)).epsilon(1e-14));
  CHECK_FALSE(other.admissible(0.25));
}

TEST_CASE("constant gamma: the sound speed at fixed energy is -V^2 dP/dV") {
  for (const double x : all_x)
    for (const double excess : {0.0, 1e5, 1e6}) {
      const double h = 1e-5;
      const double slope = (other.pressure(x + h, excess) - other.pressure(x - h, excess)) / (2 * h);
      CHECK(other.bulk_sound_speed2(x, excess) == Approx(-x * x / 2700 * slope).epsilon(1e-7));
    }
}

TEST_CASE("constant gamma: with the paper's closure a material cools as T0 x^-gamma0 in tension") {
  const Material metal{other, heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
  auto state = metal.initial<double>();
  for (int i = 0; i < 1000; ++i) metal.update(state, Mat<double, 3>{2e-4, 0, 0, 0, 0, 0, 0, 0, 0});
  const double x = get<field::VolumeRatio>(state);
  CHECK(x > 1.2);
  CHECK(get<field::Temperature>(state) == Approx(300 * std::pow(x, -1.96)).epsilon(1e-7));
}

TEST_CASE("constant gamma: packs and single precision, equal numbers are equal materials") {
  const Pack<double> x([](int i) { return all_x[i]; });
  const auto p = other.pressure(x, Pack<double>(1e5)), c2 = other.bulk_sound_speed2(x, Pack<double>(1e5));
  for (int i = 0; i < lanes; ++i) {
    CHECK(lane(p, i) == Approx(other.pressure(all_x[i], 1e5)).epsilon(1e-13));
    CHECK(lane(c2, i) == Approx(other.bulk_sound_speed2(all_x[i], 1e5)).epsilon(1e-13));
    const float single = float(all_x[i]);
    CHECK(double(other.pressure(single, 1e5f)) == Approx(other.pressure(double(single), 1e5)).epsilon(1e-4));
  }
  CHECK(other == eos::ConstantGamma{aluminium});
  CHECK_FALSE(other == eos::ConstantGamma{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350}});
  CHECK_THROWS_AS((Material{eos::ConstantGamma{eos::MieGruneisen{.rho0 = -1, .c0 = 1}}}), InputError);
}
