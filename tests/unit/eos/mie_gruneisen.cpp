#include <mote/eos/mie_gruneisen.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "catch.hpp"

namespace {

using namespace mote;
using eos::MieGruneisen;

const MieGruneisen aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const double stiffness = 2700 * 5350.0 * 5350.0;

/// x = V/V0 from strong compression (the pole is at 0.2537) to wide tension, V0 itself included.
const double all_x[] = {0.3, 0.5, 0.7, 0.9, 0.99, 0.9993, 0.9999, 1 - 1e-7, 1, 1 + 1e-7, 1.0001, 1.01, 1.2, 2};

Approx near(double value, double relative) { return Approx(value).epsilon(relative).margin(0); }

/// Fourth order difference quotient of f at x.
template <class F>
double slope(const F& f, double x, double h) {
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

/// Five points of Gauss and Legendre in each of n parts.
template <class F>
double integral(const F& f, double from, double to, int n) {
  const double node[] = {0, 0.5384693101056831, 0.9061798459386640};
  const double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = 0;
  const double half = 0.5 * (to - from) / n;
  for (int i = 0; i < n; ++i) {
    const double middle = from + (2 * i + 1) * half;
    sum += weight[0] * f(middle);
    for (int k = 1; k < 3; ++k) sum += weight[k] * (f(middle - node[k] * half) + f(middle + node[k] * half));
  }
  return sum * half;
}

std::string complaint(const MieGruneisen& eos) {
  try {
    eos.validate();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Mie-Grueneisen: the pressure is zero at V0, and continuous and smooth there") {
  CHECK(aluminium.hugoniot_pressure(1.0) == 0);
  for (const double h : {1e-3, 1e-4, 1e-5}) {
    const double below = aluminium.hugoniot_pressure(1 - h), above = aluminium.hugoniot_pressure(1 + h);
    CHECK(below - above == near(2 * stiffness * h, 3 * h));  // no jump
    // both one-sided slopes are -rho0 c0^2
    CHECK(std::abs(below / (stiffness * h) - 1) < 3 * h);
    CHECK(std::abs(above / (-stiffness * h) - 1) < 1e-10);
    CHECK(aluminium.bulk_sound_speed2(1 - h, 0.0) == near(5350.0 * 5350, 7 * h));
    CHECK(aluminium.bulk_sound_speed2(1 + h, 0.0) == near(5350.0 * 5350, 7 * h));
  }
}

TEST_CASE("Mie-Grueneisen: tension has negative pressure, and more stretch has more of it") {
  double last = 0;
  for (double x = 1.001; x < 3; x += 0.001) {
    const double p = aluminium.pressure(x, 0.0);
    REQUIRE(p < last);
    last = p;
  }
  CHECK(aluminium.pressure(1.1, 0.0) == near(-0.1 * stiffness, 1e-13));
}

TEST_CASE("Mie-Grueneisen: compression follows the Hugoniot U = c0 + lambda u") {
  // momentum P = rho0 U u and mass u = U (1 - x) across the shock
  for (const double u : {1.0, 100.0, 1000.0, 5000.0}) {
    const double shock = 5350 + 1.34 * u;
    CHECK(aluminium.hugoniot_pressure(1 - u / shock) == near(2700 * shock * u, 1e-11));
  }
}

TEST_CASE("Mie-Grueneisen: heat presses with gamma0 rho0 per unit of energy") {
  for (const double x : all_x)
    CHECK(aluminium.pressure(x, 1e6) - aluminium.pressure(x, 0.0) == Approx(1.96 * 2700 * 1e6).epsilon(1e-10));
}

TEST_CASE("Mie-Grueneisen: the sound speed is -V^2 dP/dV at fixed energy") {
  for (const double excess : {0.0, 1e5, 1e6})
    for (const double x : all_x) {
      if (std::abs(x - 1) < 1e-3) continue;  // the difference would reach over the kink in curvature
      const auto p = [&](double y) { return aluminium.pressure(y, excess); };
      CHECK(aluminium.bulk_sound_speed2(x, excess) == near(-x * x / 2700 * slope(p, x, 2e-4), 1e-8));
    }
}

TEST_CASE("Mie-Grueneisen: the reference energy is the integral of P_H dV") {
  const auto p = [](double x) { return -aluminium.hugoniot_pressure(x) / 2700; };
  for (const double x : all_x)
    CHECK(aluminium.reference_energy(x) == Approx(integral(p, 1, x, 200)).epsilon(1e-10).margin(1e-12));
  CHECK(aluminium.reference_energy(1.0) == 0);
}

TEST_CASE("Mie-Grueneisen: series and closed form of the reference energy meet") {
  const auto p = [](double x) { return -aluminium.hugoniot_pressure(x) / 2700; };
  for (double lq = 1e-4; lq < 0.5; lq *= 1.05) {
    const double x = 1 - lq / 1.34;
    REQUIRE(aluminium.reference_energy(x) == near(integral(p, 1, x, 20), 1e-10));
    REQUIRE(double(aluminium.reference_energy(float(x))) == near(integral(p, 1, double(float(x)), 20), 3e-5));
  }
}

TEST_CASE("Mie-Grueneisen: the reference heating is d(E_H)/dx + P_H V0, and zero in tension") {
  for (const double x : all_x) {
    if (x > 1) {
      CHECK(aluminium.reference_heating(x) == 0);
    } else {
      const auto energy = [](double y) { return aluminium.hugoniot_pressure(y) * (1 - y) / (2 * 2700); };
      const double expected =
          slope(energy, x, std::min(1e-3 * (x - 0.2537), (1 - x) / 3)) + aluminium.hugoniot_pressure(x) / 2700;
      // two large numbers cancel
      if (x < 0.9995)
        CHECK(std::abs(aluminium.reference_heating(x) - expected) < 1e-9 * 5350 * 5350 / std::pow(x - 0.2537, 3));
      CHECK(aluminium.reference_heating(x) <= 0);
    }
  }
  CHECK(aluminium.reference_heating(0.9) == near(-5350.0 * 5350 * 1.34 * 0.01 / std::pow(1 - 0.134, 3), 1e-13));
}

TEST_CASE("Mie-Grueneisen: without a slope, the law is linear") {
  const MieGruneisen linear{.rho0 = 2700, .c0 = 5350};
  for (const double x : all_x) {
    CHECK(linear.pressure(x, 1e6) == Approx(stiffness * (1 - x)).margin(1e-3));
    CHECK(linear.reference_energy(x) == Approx(0.5 * 5350 * 5350 * (1 - x) * (1 - x)));
    CHECK(linear.reference_heating(x) == 0);
    CHECK(linear.bulk_sound_speed2(x, 0.0) == near(5350.0 * 5350 * x * x, 1e-14));
  }
}

TEST_CASE("Mie-Grueneisen: states beyond the pole are not admissible") {
  const double pole = 1 - 1 / 1.34;
  CHECK(aluminium.smallest_x() == near(pole, 1e-15));
  CHECK(aluminium.smallest_x() == near(0.2537, 1e-3));
  CHECK(aluminium.admissible(pole + 1e-9));
  CHECK(aluminium.admissible(1.0));
  CHECK(aluminium.admissible(5.0));
  CHECK_FALSE(aluminium.admissible(pole));
  CHECK_FALSE(aluminium.admissible(pole - 1e-9));
  CHECK_FALSE(aluminium.admissible(-1.0));
  CHECK_FALSE(aluminium.admissible(std::numeric_limits<double>::quiet_NaN()));
  // at the pole the pressure has no bound
  CHECK(aluminium.hugoniot_pressure(pole + 1e-6) > 1e9 * 1e9);
  // without a pole above zero, zero is the limit
  CHECK(MieGruneisen{.rho0 = 1, .c0 = 1, .lambda = 0.5}.smallest_x() == 0);
  CHECK_FALSE(MieGruneisen{.rho0 = 1, .c0 = 1, .lambda = 0.5}.admissible(0.0));
  CHECK(MieGruneisen{.rho0 = 1, .c0 = 1, .lambda = 1}.smallest_x() == 0);
}

TEST_CASE("Mie-Grueneisen: packs give what numbers give, single precision nearly so") {
  for (int from = 0; from + lanes <= int(std::size(all_x)); ++from) {
    const Pack<double> x([&](int i) { return all_x[from + i]; }), w([&](int i) { return 1e5 * i; });
    const auto p = aluminium.pressure(x, w), c2 = aluminium.bulk_sound_speed2(x, w), e = aluminium.reference_energy(x),
               heating = aluminium.reference_heating(x);
    const auto covered = aluminium.admissible(x);
    for (int i = 0; i < lanes; ++i) {
      const double xi = all_x[from + i], wi = 1e5 * i;
      const float xf = float(xi), wf = float(wi);
      CHECK(lane(p, i) == Approx(aluminium.pressure(xi, wi)).epsilon(1e-14));
      CHECK(lane(c2, i) == near(aluminium.bulk_sound_speed2(xi, wi), 1e-14));
      CHECK(lane(e, i) == Approx(aluminium.reference_energy(xi)).epsilon(1e-14));
      CHECK(lane(heating, i) == Approx(aluminium.reference_heating(xi)).epsilon(1e-14));
      CHECK(covered[std::size_t(i)] == aluminium.admissible(xi));
      // the number that single precision holds, not the one it rounds
      const double exact = double(xf);
      CHECK(double(aluminium.pressure(xf, wf)) == Approx(aluminium.pressure(exact, wi)).epsilon(1e-5));
      CHECK(double(aluminium.bulk_sound_speed2(xf, wf)) == near(aluminium.bulk_sound_speed2(exact, wi), 1e-5));
      CHECK(double(aluminium.reference_energy(xf)) == Approx(aluminium.reference_energy(exact)).epsilon(3e-5));
      CHECK(double(aluminium.reference_heating(xf)) == Approx(aluminium.reference_heating(exact)).epsilon(1e-5));
    }
  }
}

TEST_CASE("Mie-Grueneisen: impossible parameters are refused in a sentence") {
  CHECK(complaint(aluminium).empty());
  CHECK(complaint({.rho0 = 0, .c0 = 1}) == "mote: the density rho0 is 0 kg/m^3; it must be > 0");
  CHECK(complaint({.rho0 = 1, .c0 = -5}) == "mote: the sound speed c0 is -5 m/s; it must be > 0");
  CHECK(complaint({.rho0 = 1, .c0 = 1, .lambda = -1}) == "mote: the Hugoniot slope lambda is -1; it must be >= 0");
  CHECK(complaint({.rho0 = 1, .c0 = 1, .gamma0 = -2}) ==
        "mote: the Grueneisen coefficient gamma0 is -2; it must be >= 0");
  CHECK(complaint({.rho0 = std::nan(""), .c0 = 1}) != "");
  CHECK(complaint({.rho0 = 1, .c0 = 1, .lambda = std::nan("")}) != "");
}
