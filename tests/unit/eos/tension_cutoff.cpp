#include <mote/eos/tension_cutoff.hpp>

#include <cmath>
#include <mote/eos/constant_gamma.hpp>
#include <mote/eos/ideal_gas.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/heat/adiabatic.hpp>
#include <mote/material.hpp>

#include "catch.hpp"

namespace {

using namespace mote;

const eos::MieGruneisen aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const double limit = 1.2e9, opens = 1 + 1.2e9 / (2700 * 5350.0 * 5350);
const eos::TensionCutoff brittle{aluminium, {.limit = limit}};
const double all_x[] = {0.5, 0.9, 1, 1.01, 1.015, 1.016, 1.2, 3};

}  // namespace

TEST_CASE("tension cut-off: P >= -limit, and the equation of state elsewhere") {
  for (const double x : all_x)
    for (const double excess : {0.0, 1e4, 1e6}) {
      const double whole = aluminium.pressure(x, excess);
      CHECK(brittle.pressure(x, excess) == (whole < -limit ? -limit : whole));
    }
  CHECK(brittle.opens_at == Approx(opens).epsilon(1e-14));
  CHECK(brittle.pressure(3.0, 0.0) == -limit);
  CHECK(brittle.rho0 == 2700);
  CHECK_FALSE(brittle.admissible(0.25));
}

TEST_CASE("tension cut-off: the reference energy is the work of the cut pressure") {
  for (const double x : all_x) {
    const int n = 20000;
    double work = 0;
    for (int i = 0; i < n; ++i) work -= brittle.pressure(1 + (x - 1) * (i + 0.5) / n, 0.0) * (x - 1) / n / 2700;
    CHECK(brittle.reference_energy(x) == Approx(work).epsilon(1e-5).margin(1e-9));
  }
}

TEST_CASE("tension cut-off: sound runs as in the state that opened, and void neither stiffens nor cools") {
  for (const double x : {0.7, 1.01}) {
    CHECK(brittle.bulk_sound_speed2(x, 1e4) == aluminium.bulk_sound_speed2(x, 1e4));
    CHECK(isentropic_sound_speed2(brittle, x, 1e4) == isentropic_sound_speed2(aluminium, x, 1e4));
    CHECK(brittle.gamma_over_volume(x) == 1.96);
  }
  for (const double x : {1.1, 3.0, 100.0}) {
    CHECK(brittle.bulk_sound_speed2(x, 0.0) == Approx(5350 * 5350 * opens * opens).epsilon(1e-13));
    // an energy far below the curve, as energy::Full has it there
    CHECK(isentropic_sound_speed2(brittle, x, -1e7) == Approx(5350 * 5350 * opens * opens).epsilon(1e-13));
    CHECK(brittle.gamma_over_volume(x) == 0);
  }
  const Material metal{brittle, heat::Adiabatic{.specific_heat = 880}};
  auto state = metal.initial<double>();
  for (int i = 0; i < 700; ++i) metal.update(state, Mat<double, 3>{1e-3, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(get<field::VolumeRatio>(state) > 2);
  CHECK(get<field::Temperature>(state) == Approx(300 * std::exp(-1.96 * (opens - 1))).epsilon(2e-3));
}

TEST_CASE("tension cut-off: on any law, packs and single precision") {
  const eos::TensionCutoff other{eos::ConstantGamma{aluminium}, {.limit = limit}};
  CHECK(other.opens_at == Approx(opens).epsilon(1e-14));
  CHECK(other.pressure(0.9, 1e5) == eos::ConstantGamma{aluminium}.pressure(0.9, 1e5));
  const Pack<double> x([](int i) { return all_x[i]; }), e(1e3);
  const auto p = brittle.pressure(x, e), c2 = brittle.bulk_sound_speed2(x, e),
             c2s = isentropic_sound_speed2(brittle, x, e), energy = brittle.reference_energy(x),
             gamma = brittle.gamma_over_volume(x);
  for (int i = 0; i < lanes; ++i) {
    CHECK(lane(p, i) == Approx(brittle.pressure(all_x[i], 1e3)).epsilon(1e-13));
    CHECK(lane(c2, i) == Approx(brittle.bulk_sound_speed2(all_x[i], 1e3)).epsilon(1e-13));
    CHECK(lane(c2s, i) == Approx(isentropic_sound_speed2(brittle, all_x[i], 1e3)).epsilon(1e-13));
    CHECK(lane(energy, i) == Approx(brittle.reference_energy(all_x[i])).epsilon(1e-13));
    CHECK(lane(gamma, i) == brittle.gamma_over_volume(all_x[i]));
    const float single = float(all_x[i]);
    CHECK(double(brittle.pressure(single, 1e3f)) == Approx(brittle.pressure(double(single), 1e3)).epsilon(1e-4));
  }
}

TEST_CASE("tension cut-off: impossible limits are refused") {
  const auto with = [](const auto& eos, double value) { return eos::TensionCutoff{eos, {.limit = value}}; };
  CHECK_THROWS_WITH(with(aluminium, -1), "mote: the limit of tension is -1 Pa; it must be > 0");
  CHECK_THROWS_AS(with(aluminium, std::nan("")), InputError);
  CHECK_THROWS_AS(with(aluminium, 1e13), InputError);
  CHECK_THROWS_AS(with(eos::IdealGas{.rho0 = 1, .gamma = 1.4, .initial_pressure = 1e5}, 1e5), InputError);
  CHECK_THROWS_AS(with(eos::MieGruneisen{.rho0 = -1, .c0 = 1}, 1e5), InputError);
}
