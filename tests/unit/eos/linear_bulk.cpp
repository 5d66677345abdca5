#include <mote/eos/linear_bulk.hpp>

#include <string>

#include "catch.hpp"

namespace {

using namespace mote;
using eos::LinearBulk;

const LinearBulk steel{.rho0 = 7800, .bulk_modulus = 160e9};
const double all_x[] = {0.3, 0.9, 0.999, 1, 1.0001, 1.01, 1.2, 2};

std::string complaint(const LinearBulk& eos) {
  try {
    eos.validate();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("linear bulk: the pressure is K (1 - x), whatever the energy") {
  for (const double x : all_x) {
    CHECK(steel.pressure(x, 0.0) == Approx(160e9 * (1 - x)).epsilon(1e-14));
    CHECK(steel.pressure(x, 1e6) == steel.pressure(x, 0.0));
    CHECK(steel.reference_heating(x) == 0);
  }
  CHECK(steel.gamma_over_volume() == 0);
}

TEST_CASE("linear bulk: tension has negative pressure, and more stretch has more of it") {
  CHECK(steel.pressure(1.0, 0.0) == 0);
  CHECK(steel.pressure(1.1, 0.0) < 0);
  CHECK(steel.pressure(1.2, 0.0) < steel.pressure(1.1, 0.0));
}

TEST_CASE("linear bulk: the sound speed is -V^2 dP/dV") {
  for (const double x : all_x) {
    const double h = 1e-4, slope = (steel.pressure(x + h, 1e5) - steel.pressure(x - h, 1e5)) / (2 * h);
    CHECK(steel.bulk_sound_speed2(x, 1e5) == Approx(-x * x / 7800 * slope).epsilon(1e-10));
  }
}

TEST_CASE("linear bulk: the reference energy is the integral of P dV") {
  for (const double x : all_x) {
    const double mean = 0.5 * (steel.pressure(x, 0.0) + steel.pressure(1.0, 0.0));  // exact for a linear law
    CHECK(steel.reference_energy(x) == Approx(mean * (1 - x) / 7800).epsilon(1e-12));
  }
}

TEST_CASE("linear bulk: packs give what numbers give, single precision nearly so") {
  const Pack<double> x([](int i) { return all_x[i]; });
  const auto p = steel.pressure(x, x), c2 = steel.bulk_sound_speed2(x, x), e = steel.reference_energy(x);
  for (int i = 0; i < lanes; ++i) {
    CHECK(lane(p, i) == Approx(steel.pressure(all_x[i], 0.0)).epsilon(1e-14));
    CHECK(lane(c2, i) == Approx(steel.bulk_sound_speed2(all_x[i], 0.0)).epsilon(1e-14));
    CHECK(lane(e, i) == Approx(steel.reference_energy(all_x[i])).epsilon(1e-14));
    CHECK(steel.admissible(x)[std::size_t(i)]);
    const float xf = float(all_x[i]);
    CHECK(double(steel.pressure(xf, 0.f)) == Approx(steel.pressure(double(xf), 0.0)).epsilon(1e-6));
    CHECK(double(steel.bulk_sound_speed2(xf, 0.f)) == Approx(steel.bulk_sound_speed2(double(xf), 0.0)).epsilon(1e-6));
    CHECK(double(steel.reference_energy(xf)) == Approx(steel.reference_energy(double(xf))).epsilon(1e-6));
  }
}

TEST_CASE("linear bulk: a volume must be positive") {
  CHECK(steel.admissible(1e-9));
  CHECK_FALSE(steel.admissible(0.0));
  CHECK_FALSE(steel.admissible(-1.0));
}

TEST_CASE("linear bulk: impossible parameters are refused in a sentence") {
  CHECK(complaint(steel).empty());
  CHECK(complaint({.rho0 = -1, .bulk_modulus = 1}) == "mote: the density rho0 is -1 kg/m^3; it must be > 0");
  CHECK(complaint({.rho0 = 1, .bulk_modulus = 0}) == "mote: the bulk modulus is 0 Pa; it must be > 0");
}
