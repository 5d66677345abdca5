#include <mote/eos/logarithmic_bulk.hpp>

#include <cmath>

#include "catch.hpp"

namespace {
using namespace mote;
const eos::LogarithmicBulk rubber{.rho0 = 1100, .bulk_modulus = 2e9};
}  // namespace

TEST_CASE("logarithmic bulk: K at rest, Kirchhoff pressure linear in the logarithm") {
  CHECK(rubber.pressure(1.0, 0.0) == 0);
  CHECK(rubber.bulk_sound_speed2(1.0, 0.0) == Approx(2e9 / 1100));
  for (const double x : {0.3, 0.7, 0.99, 1.2, 2.5}) CHECK(x * rubber.pressure(x, 0.0) == Approx(-2e9 * std::log(x)));
}

TEST_CASE("logarithmic bulk: sound speed and energy against differences") {
  for (const double x : {0.3, 0.7, 0.99, 1.0, 1.2, 2.5, 4.0}) {
    const double d = 1e-6 * x;
    const double slope = (rubber.pressure(x + d, 0.0) - rubber.pressure(x - d, 0.0)) / (2 * d);
    CHECK(rubber.bulk_sound_speed2(x, 0.0) == Approx(-x * x / 1100 * slope).epsilon(1e-7));
    const double work = (rubber.reference_energy(x + d) - rubber.reference_energy(x - d)) / (2 * d);
    CHECK(-rubber.pressure(x, 0.0) / 1100 == Approx(work).margin(1e-4));
  }
  CHECK(rubber.bulk_sound_speed2(std::exp(1.0), 0.0) == Approx(0).margin(1e-6));
}

TEST_CASE("logarithmic bulk: no modulus, no pressure, impossible numbers are refused") {
  const eos::LogarithmicBulk none{.rho0 = 1};
  CHECK_NOTHROW(none.validate());
  CHECK(none.pressure(0.5, 0.0) == 0);
  CHECK(none.bulk_sound_speed2(0.5, 0.0) == 0);
  CHECK(none.reference_energy(0.5) == 0);
  CHECK_THROWS_WITH((eos::LogarithmicBulk{.rho0 = 1, .bulk_modulus = -2}.validate()),
                    "mote: the bulk modulus is -2 Pa; it must be >= 0");
  CHECK_THROWS_AS((eos::LogarithmicBulk{.rho0 = 0}.validate()), InputError);
}
