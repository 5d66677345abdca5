#include <mote/heat/adiabatic.hpp>

#include <cmath>
#include <mote/eos/linear_bulk.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <string>

#include "catch.hpp"

namespace {

using namespace mote;

const eos::MieGruneisen aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const heat::Adiabatic heating{.specific_heat = 880, .initial_temperature = 300};

template <class T>
using Warm = Values<T, 3, fields<field::Temperature>>;

/// Temperature after n equal increments of x from 1 to `to`.
template <class T = double>
T temperature(T to, int n) {
  Warm<T> state;
  heating.initialise(state);
  for (int i = 0; i < n; ++i)
    heating.update(state, aluminium, T(1) + (to - T(1)) * T(double(i) / n), T(1) + (to - T(1)) * T(double(i + 1) / n),
                   T(0));
  return get<field::Temperature>(state);
}

/// dT/dx = h(x)/cv - gamma0 T, classical Runge-Kutta of fourth order, h written out once more.
double by_runge_kutta(double to, int n) {
  const auto slope = [](double x, double kelvin) {
    const double q = 1 - x, d = 1 - 1.34 * q;
    return (q > 0 ? -5350.0 * 5350 * 1.34 * q * q / (d * d * d) / 880 : 0) - 1.96 * kelvin;
  };
  double x = 1, kelvin = 300;
  const double h = (to - 1) / n;
  for (int i = 0; i < n; ++i, x += h) {
    const double a = slope(x, kelvin), b = slope(x + h / 2, kelvin + h / 2 * a),
                 c = slope(x + h / 2, kelvin + h / 2 * b), d = slope(x + h, kelvin + h * c);
    kelvin += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return kelvin;
}

/// The error falls four times when the steps are halved.
template <class F>
void check_second_order(const F& error) {
  double last = std::abs(error(10));
  for (const int n : {20, 40, 80}) {
    const double now = std::abs(error(n));
    CHECK(std::log2(last / now) == Approx(2).margin(0.1));
    last = now;
  }
}

}  // namespace

TEST_CASE("adiabatic: it begins with the initial temperature") {
  Warm<double> state;
  heating.initialise(state);
  CHECK(get<field::Temperature>(state) == 300);
  heating.update(state, aluminium, 1.0, 1.0, 0.0);
  CHECK(get<field::Temperature>(state) == 300);
}

TEST_CASE("adiabatic: in tension T = T0 exp(-gamma0 (x - 1)), to second order in the steps") {
  for (const double x : {1.01, 1.1, 1.5}) {
    const double exact = 300 * std::exp(-1.96 * (x - 1));
    CHECK(temperature(x, 2000) == Approx(exact).epsilon(1e-7));
    CHECK(exact < 300);
    check_second_order([&](int n) { return temperature(x, n) - exact; });
  }
}

TEST_CASE("adiabatic: in compression the shock heats, to second order in the steps") {
  for (const double x : {0.95, 0.8, 0.6}) {
    const double exact = by_runge_kutta(x, 4000);
    CHECK(temperature(x, 8000) == Approx(exact).epsilon(2e-7));
    CHECK(exact > 300 * std::exp(1.96 * (1 - x)));  // more than the isentrope would
    check_second_order([&](int n) { return temperature(x, n) - exact; });
  }
}

TEST_CASE("adiabatic: compression and release along the curve return to the start") {
  Warm<double> state;
  heating.initialise(state);
  const int n = 50;
  const auto x = [&](int i) { return 1 - 0.2 * i / n; };
  for (int i = 0; i < n; ++i) heating.update(state, aluminium, x(i), x(i + 1), 0.0);
  CHECK(get<field::Temperature>(state) > 400);
  for (int i = n; i > 0; --i) heating.update(state, aluminium, x(i), x(i - 1), 0.0);
  CHECK(get<field::Temperature>(state) == Approx(300).epsilon(1e-13));
}

TEST_CASE("adiabatic: plastic work warms by dW/cv") {
  Warm<double> state;
  heating.initialise(state);
  heating.update(state, aluminium, 1.0, 1.0, 880 * 25.0);
  CHECK(get<field::Temperature>(state) == Approx(325).epsilon(1e-14));
  heating.update(state, eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1}, 1.0, 0.9, 880 * 10.0);  // no heat of its own
  CHECK(get<field::Temperature>(state) == Approx(335).epsilon(1e-14));
}

TEST_CASE("adiabatic: the temperature stays positive in a huge stretch") {
  CHECK(temperature(10.0, 100) > 0);
  CHECK(temperature(10.0, 100) < 1e-4);
}

TEST_CASE("adiabatic: packs give what numbers give, single precision nearly so") {
  const auto to = [](int i) { return 0.7 + 0.1 * i; };
  const auto pack = temperature(Pack<double>(to), 10);
  for (int i = 0; i < lanes; ++i) {
    CHECK(lane(pack, i) == Approx(temperature(to(i), 10)).epsilon(1e-14));
    CHECK(double(temperature(float(to(i)), 10)) == Approx(temperature(to(i), 10)).epsilon(1e-5));
  }
}

TEST_CASE("adiabatic: impossible parameters are refused in a sentence") {
  const auto complaint = [](const heat::Adiabatic& part) -> std::string {
    try {
      part.validate();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(complaint(heating).empty());
  CHECK(complaint({.specific_heat = 0}) == "mote: the specific heat is 0 J/(kg K); it must be > 0");
  CHECK(complaint({.specific_heat = 1, .initial_temperature = -1}) ==
        "mote: the initial temperature is -1 K; it must be > 0");
}
