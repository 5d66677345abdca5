// The complete energy equation: against its own differential equation, exact jumps, differences, and the work done.
#include <mote/energy/full.hpp>

#include <cmath>
#include <mote/eos/constant_gamma.hpp>
#include <mote/eos/ideal_gas.hpp>
#include <mote/eos/linear_bulk.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/eos/tension_cutoff.hpp>
#include <mote/heat/adiabatic.hpp>
#include <mote/material.hpp>
#include <mote/strength/von_mises.hpp>
#include <mote/viscosity/von_neumann.hpp>
#include <random>

#include "catch.hpp"

namespace {

using namespace mote;
using Matrix = Mat<double, 3>;

const eos::MieGruneisen hugoniot{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const strength::VonMises plastic{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
const heat::Adiabatic heating{.specific_heat = 880, .initial_temperature = 300};
const viscosity::VonNeumann shock{.linear = 0.2, .quadratic = 2};

const Material fluid{hugoniot, energy::Full{}, heating};
const Material metal{hugoniot, energy::Full{}, plastic, heating, shock};

template <class S>
double& x_of(S& state) {
  return get<field::VolumeRatio>(state);
}
template <class S>
double& energy_of(S& state) {
  return get<field::InternalEnergy>(state);
}
Matrix stretch(double factor) { return {0, 0, 0, 0, 0, 0, 0, 0, factor - 1}; }

/// Moves a state from its x to another in n steps.
template <class M, class S>
void lead(const M& material, S& state, double to, int n) {
  const double from = x_of(state);
  for (int i = 1; i <= n; ++i)
    material.update(state, stretch((from + (to - from) * i / n) / x_of(state)), {.dt = 1, .spacing = 1});
}

/// dE/dx = -P/rho0 by classical Runge-Kutta, the pressure written out once more; gamma/V or gamma constant.
double isentrope(double to, bool constant_gamma, int n = 2000) {
  const auto slope = [&](double x, double e) {
    const double q = 1 - x, d = 1 - 1.34 * std::max(q, 0.0), curve = 2700 * 5350.0 * 5350 * q / (d * d);
    return -(curve + (constant_gamma ? 1.96 / x : 1.96) * 2700 * (e - curve * q / (2 * 2700))) / 2700;
  };
  const double h = (to - 1) / n;
  double x = 1, e = 0;
  for (int i = 0; i < n; ++i, x += h) {
    const double a = slope(x, e), b = slope(x + h / 2, e + h / 2 * a), c = slope(x + h / 2, e + h / 2 * b),
                 d = slope(x + h, e + h * c);
    e += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return e;
}

/// The error falls four times when the steps are halved.
template <class F>
void check_second_order(const F& error) {
  double last = std::abs(error(20));
  for (const int n : {40, 80, 160}) {
    const double now = std::abs(error(n));
    INFO(n << " steps, error " << now << ", before " << last);
    CHECK(std::log2(last / now) == Approx(2).margin(0.1));
    last = now;
  }
}

/// The sound speed of a state against the pressure along the isentrope through it.
template <class M, class S>
void check_sound_speed(const M& material, const S& state) {
  const double step = 1e-5;
  double p[2];
  for (int i = 0; i < 2; ++i) {
    S moved = state;
    lead(material, moved, x_of(moved) + (i ? step : -step), 1);
    p[i] = material.pressure(moved);
  }
  S at = state;
  INFO("x = " << x_of(at) << ", E = " << energy_of(at));
  CHECK(material.sound_speed2(state) ==
        Approx(-x_of(at) * x_of(at) / material.rho0() * (p[1] - p[0]) / (2 * step)).epsilon(1e-7));
}

}  // namespace

TEST_CASE("full: without dissipation E follows the isentrope, to second order in the steps") {
  const Material other{eos::ConstantGamma{hugoniot}, energy::Full{}};
  for (const double x : {0.7, 0.9}) {
    const double exact = isentrope(x, false), of_other = isentrope(x, true);
    CHECK(std::abs(exact - of_other) > 1e-4 * exact);
    check_second_order([&](int n) {
      auto state = fluid.initial<double>();
      lead(fluid, state, x, n);
      return energy_of(state) / exact - 1;
    });
    check_second_order([&](int n) {
      auto state = other.initial<double>();
      lead(other, state, x, n);
      return energy_of(state) / of_other - 1;
    });
  }
  auto state = fluid.initial<double>();  // in tension P is linear in V along the isentrope, and the rule exact
  lead(fluid, state, 1.1, 7);
  CHECK(energy_of(state) == Approx(0.5 * 5350 * 5350 * 0.01).epsilon(1e-12));
}

TEST_CASE("full: the isentrope lies below the Hugoniot, and a cycle returns to the start") {
  auto state = fluid.initial<double>();
  CHECK(energy_of(state) == 0);
  lead(fluid, state, 0.7, 50);
  CHECK(fluid.pressure(state) < hugoniot.hugoniot_pressure(0.7));
  CHECK(fluid.pressure(state) > 0.8 * hugoniot.hugoniot_pressure(0.7));
  CHECK(fluid.elastic_energy(state) == energy_of(state));
  lead(fluid, state, 1, 50);  // the rule is symmetric in time
  CHECK(std::abs(energy_of(state)) < 1e-8 * 1e6);
  CHECK(std::abs(fluid.pressure(state)) < 1e-8 * 1e11);
  CHECK(get<field::Temperature>(state) == Approx(300).epsilon(1e-12));
}

TEST_CASE("full: work along the Rayleigh line leads to the Hugoniot, exactly, and to its temperature") {
  // a steady shock: P + q = P1 (1 - x)/(1 - x1), so that E = P1 (1 - x)^2/(2 rho0 (1 - x1))
  for (const double u : {100.0, 1000.0, 3000.0}) {
    const double speed = 5350 + 1.34 * u, end = 1 - u / speed;
    const auto energy = [&](double x) { return 0.5 * u * u * std::pow((1 - x) / (1 - end), 2); };
    const auto arrive = [&](int n) {
      auto state = fluid.initial<double>();
      for (int i = 0; i < n; ++i) {
        const double a = 1 + (end - 1) * i / n, b = 1 + (end - 1) * (i + 1) / n;
        const double p = 0.5 * (hugoniot.pressure(a, energy(a) - hugoniot.internal_energy(a)) +
                                hugoniot.pressure(b, energy(b) - hugoniot.internal_energy(b)));
        const double work = energy(b) - energy(a) + p * (b - a) / 2700;
        energy::Full::update(state, hugoniot, a, b, work);
        heating.update(state, detail::WithoutReferenceHeating<eos::MieGruneisen>{hugoniot}, a, b, work);
        x_of(state) = b;
      }
      return state;
    };
    auto state = arrive(200);
    CHECK(energy_of(state) == Approx(0.5 * u * u).epsilon(1e-12));
    CHECK(fluid.pressure(state) == Approx(2700 * speed * u).epsilon(1e-12));
    // the paper's temperature on the same curve comes from the curve's own heating
    auto on_curve = fluid.initial<double>();
    const int n = 20000;
    for (int i = 0; i < n; ++i)
      heating.update(on_curve, hugoniot, 1 + (end - 1) * i / n, 1 + (end - 1) * (i + 1) / n, 0.0);
    check_second_order([&](int steps) {
      auto warm = arrive(steps);
      return get<field::Temperature>(warm) - get<field::Temperature>(on_curve);
    });
  }
}

TEST_CASE("full: the bulk sound speed is the slope of P along the isentrope") {
  for (const double x : {0.55, 0.8, 0.95, 1.05, 1.3})
    for (const double excess : {-1e4, 0.0, 1e5, 1e6}) {
      const auto at = [&](const auto& material) {
        auto state = material.template initial<double>();
        x_of(state) = x;
        energy_of(state) = material.eos.internal_energy(x) + excess;
        check_sound_speed(material, state);
      };
      at(Material{hugoniot, energy::Full{}});
      at(Material{eos::ConstantGamma{hugoniot}, energy::Full{}});
      at(Material{eos::LinearBulk{.rho0 = 2700, .bulk_modulus = 77e9}, energy::Full{}});
      at(Material{eos::IdealGas{.rho0 = 1.2, .gamma = 1.4, .initial_pressure = 1e5}, energy::Full{}});
      if (x < 1.01) at(Material{eos::TensionCutoff{hugoniot, {.limit = 2e9}}, energy::Full{}});
    }
}

TEST_CASE("full: an ideal gas follows P V^gamma, and E = P V/(gamma - 1)") {
  const Material gas{eos::IdealGas{.rho0 = 1.2, .gamma = 1.4, .initial_pressure = 1e5}, energy::Full{}};
  auto state = gas.initial<double>();
  CHECK(gas.pressure(state) == Approx(1e5).epsilon(1e-14));
  CHECK(gas.elastic_energy(state) == 0);
  check_second_order([&](int n) {
    auto moved = gas.initial<double>();
    lead(gas, moved, 0.5, n);
    return gas.pressure(moved) / (1e5 * std::pow(2, 1.4)) - 1;
  });
  lead(gas, state, 0.5, 1000);
  CHECK(gas.pressure(state) * 0.5 / 1.2 / 0.4 == Approx(energy_of(state)).epsilon(1e-13));
}

TEST_CASE("full: with strength and viscosity the work becomes elastic energy, W_p and W_q") {
  // uniaxial, from a state in which the metal flows; the velocity is not constant, so q changes on the way. The work of
  // the mean stress is balanced to round-off, in any number of steps.
  const auto length = [](double t) { return 0.99 - 0.08 * t - 0.03 * t * t; };
  for (const int n : {7, 50}) {
    auto state = metal.initial<double>();
    metal.update(state, stretch(length(0)), {.dt = 1, .spacing = 1});
    metal.update(state, stretch(length(1.0 / n) / length(0)), {.dt = 1.0 / n, .spacing = 1e3});
    const auto start = state;
    double work = 0, dilation = 0;
    for (int i = 1; i < n; ++i) {
      const Matrix a = stretch(length(double(i + 1) / n) / length(double(i) / n));
      auto before = state;
      metal.update(state, a, {.dt = 1.0 / n, .spacing = 1e3});
      const auto both = metal.stress(before) + metal.stress(state);
      const double x = 0.5 * (x_of(before) + x_of(state)), dx = x_of(state) - x_of(before);
      work += 0.5 * ddot(both, Kinematics<double>(a).strain) * x / 2700;
      // |s|^2/(4 G rho0) dx: the shear energy per mass grows with the volume, which no stress pays for
      const auto &s0 = get<field::DeviatoricStress>(before), &s1 = get<field::DeviatoricStress>(state);
      dilation += 0.5 * (ddot(s0, s0) + ddot(s1, s1)) / (4 * 25.94e9 * 2700) * dx;
    }
    const auto total = [](const auto& s) {
      return metal.elastic_energy(s) + get<field::PlasticWork>(s) + get<field::ViscousWork>(s);
    };
    CHECK(std::abs(work + dilation - total(state) + total(start)) < 1e-12 * work);
    CHECK(get<field::ViscousWork>(state) > 0.01 * work);
    CHECK(get<field::PlasticWork>(state) > 0.01 * work);
  }
}

TEST_CASE("full: heat warms by dW/cv, compression by gamma/V alone") {
  const Material warm{eos::LinearBulk{.rho0 = 2700, .bulk_modulus = 77e9}, energy::Full{}, plastic, heating, shock};
  auto state = warm.initial<double>();
  for (int i = 0; i < 100; ++i) warm.update(state, stretch(0.999), {.dt = 1e-3, .spacing = 1e3});
  const double work = get<field::PlasticWork>(state) + get<field::ViscousWork>(state);
  CHECK(get<field::PlasticWork>(state) > 1e3);
  CHECK(get<field::ViscousWork>(state) > 1e3);
  CHECK(get<field::Temperature>(state) == Approx(300 + work / 880).epsilon(1e-12));

  auto cold = fluid.initial<double>();
  lead(fluid, cold, 0.8, 4000);
  CHECK(get<field::Temperature>(cold) == Approx(300 * std::exp(1.96 * 0.2)).epsilon(1e-7));
  const Material other{eos::ConstantGamma{hugoniot}, energy::Full{}, heating};
  auto second = other.initial<double>();
  lead(other, second, 0.8, 4000);
  CHECK(get<field::Temperature>(second) == Approx(300 * std::pow(0.8, -1.96)).epsilon(1e-7));
}

TEST_CASE("full: a pressure that is not linear in the energy is met to second order too") {
  // beyond the limit the tension does constant work
  const Material brittle{eos::TensionCutoff{hugoniot, {.limit = 1e9}}, energy::Full{}};
  auto state = brittle.initial<double>();
  lead(brittle, state, 1.3, 1000);
  CHECK(brittle.pressure(state) == -1e9);
  const double opens = brittle.eos.opens_at;
  CHECK(energy_of(state) ==
        Approx(0.5 * 5350 * 5350 * (opens - 1) * (opens - 1) + 1e9 / 2700 * (1.3 - opens)).epsilon(1e-4));
  lead(brittle, state, 1, 1000);
  CHECK(std::abs(energy_of(state)) < 1e-8 * 1e5);
  CHECK(std::abs(brittle.pressure(state)) < 1e-2);
}

TEST_CASE("full: packs give what numbers give, single precision nearly so") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> random(-1, 1);
  auto pack = metal.initial<Pack<double>>();
  decltype(metal.initial<double>()) one[lanes];
  decltype(metal.initial<float>()) single[lanes];
  for (int l = 0; l < lanes; ++l) metal.initialise(one[l]), metal.initialise(single[l]);
  const Step step{.dt = 1e-10, .spacing = 1e-6};
  for (int n = 0; n < 20; ++n) {
    Mat<Pack<double>, 3> a{};
    for (auto& c : a.c) c = Pack<double>([&](int l) { return (l % 2 ? 1e-2 : 1e-4) * random(engine); });
    metal.update(pack, a, step);
    for (int l = 0; l < lanes; ++l) {
      Matrix b{};
      Mat<float, 3> f{};
      for (int c = 0; c < 9; ++c) f.c[c] = float(b.c[c] = lane(a.c[c], l));
      metal.update(one[l], b, step);
      metal.update(single[l], f, step);
    }
  }
  const auto c2 = metal.signal_speed2(pack), elastic = metal.elastic_energy(pack), p = metal.pressure(pack);
  for (int l = 0; l < lanes; ++l) {
    CHECK(lane(get<field::InternalEnergy>(pack), l) == Approx(energy_of(one[l])).epsilon(1e-11).margin(1e-9));
    CHECK(lane(get<field::ViscousPressure>(pack), l) == Approx(get<field::ViscousPressure>(one[l])).epsilon(1e-11));
    CHECK(lane(get<field::ViscousWork>(pack), l) == Approx(get<field::ViscousWork>(one[l])).epsilon(1e-11));
    CHECK(lane(p, l) == Approx(metal.pressure(one[l])).epsilon(1e-11).margin(1e-13 * 77e9));
    CHECK(lane(c2, l) == Approx(metal.signal_speed2(one[l])).epsilon(1e-12));
    CHECK(lane(elastic, l) == Approx(metal.elastic_energy(one[l])).epsilon(1e-10).margin(1e-9));
    CHECK(double(metal.pressure(single[l])) == Approx(metal.pressure(one[l])).margin(4e-6 * 77e9));
    CHECK(double(metal.signal_speed2(single[l])) == Approx(metal.signal_speed2(one[l])).epsilon(1e-4));
  }
}

namespace {

/// A strength that is called lane by lane.
struct Slow : strength::VonMises {
  static constexpr bool scalar_only = true;
};

}  // namespace

TEST_CASE("full: a strength for numbers alone gets the same energy and viscosity") {
  const Material by_lane{hugoniot, energy::Full{}, Slow{plastic}, shock};
  const Material by_pack{hugoniot, energy::Full{}, plastic, shock};
  auto a = by_lane.initial<Pack<double>>();
  auto b = by_pack.initial<Pack<double>>();
  for (int i = 0; i < 10; ++i) {
    Mat<Pack<double>, 3> l{};
    l(2, 2) = Pack<double>([](int lane) { return -1e-3 * lane; });
    by_lane.update(a, l, {.dt = 1e-10, .spacing = 1e-6});
    by_pack.update(b, l, {.dt = 1e-10, .spacing = 1e-6});
  }
  for (int l = 0; l < lanes; ++l) {
    CHECK(lane(get<field::InternalEnergy>(a), l) == Approx(lane(get<field::InternalEnergy>(b), l)).epsilon(1e-12));
    CHECK(lane(get<field::ViscousWork>(a), l) == Approx(lane(get<field::ViscousWork>(b), l)).epsilon(1e-12));
  }
}
