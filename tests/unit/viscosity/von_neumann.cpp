// Shock viscosity: its formula, its work, and the time step that it allows.
#include <mote/viscosity/von_neumann.hpp>

#include <cmath>
#include <complex>
#include <mote/mote.hpp>
#include <string>

#include "catch.hpp"

namespace {

using namespace mote;
using Matrix = Mat<double, 3>;

const eos::MieGruneisen hugoniot{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const viscosity::VonNeumann shock{.linear = 0.3, .quadratic = 1.7};
const Material fluid{hugoniot, shock};
const Material metal{hugoniot, shock, strength::Elastic{.shear_modulus = 25.94e9}};

constexpr Step step{.dt = 1e-11, .spacing = 1e-6};

}  // namespace

TEST_CASE("viscosity: q = rho (A1 c h |D| + A2 h^2 D^2) in compression, zero in expansion") {
  CHECK(shock.pressure(2700.0, 5000.0, 200.0) == Approx(2700 * (0.3 * 5000 * 200 + 1.7 * 200 * 200)).epsilon(1e-14));
  CHECK(shock.pressure(2700.0, 5000.0, -200.0) == 0);
  CHECK(shock.pressure(2700.0, 5000.0, 0.0) == 0);
  // in the material, at rest: D = -e/dt with the mid-point strain e
  for (const double e : {1e-4, 1e-3}) {
    auto state = metal.initial<double>();
    metal.update(state, Matrix{-e, 0, 0, 0, 0, 0, 0, 0, 0}, step);
    const double closing = e / (1 - e / 2) * step.spacing / step.dt,
                 c = std::sqrt(metal.sound_speed2(metal.initial<double>()));
    const double q = 2700 * (0.3 * c * closing + 1.7 * closing * closing);
    CHECK(get<field::ViscousPressure>(state) == Approx(q).epsilon(1e-12));
    CHECK(trace(metal.stress(state)) / 3 == Approx(-metal.pressure(state) - q).epsilon(1e-12));
    CHECK(get<field::ViscousWork>(state) == Approx(0.5 * q * e / 2700).epsilon(1e-12));
    metal.update(state, Matrix{e, 0, 0, 0, 0, 0, 0, 0, 0}, step);
    CHECK(get<field::ViscousPressure>(state) == 0);
  }
}

TEST_CASE("viscosity: all three dimensions count, a turn and a shear at constant volume do not") {
  auto one = fluid.initial<double>(), all = one, turned = one, sheared = one;
  fluid.update(one, Matrix{-3e-4, 0, 0, 0, 0, 0, 0, 0, 0}, step);
  fluid.update(all, Matrix::identity() * -1e-4, step);
  CHECK(get<field::ViscousPressure>(all) == Approx(get<field::ViscousPressure>(one)).epsilon(1e-3));
  const double a = 0.3, c = -2 * std::pow(std::sin(a / 2), 2), s = std::sin(a);
  fluid.update(turned, Matrix{c, -s, 0, s, c, 0, 0, 0, 0}, step);
  CHECK(get<field::ViscousPressure>(turned) < 1e-12 * 2700 * 5350 * 1e5);
  fluid.update(sheared, Matrix{0, 0.3, 0, 0, 0, 0, 0, 0, 0}, step);
  CHECK(get<field::ViscousPressure>(sheared) < 1e-12 * 2700 * 5350 * 1e5);
}

TEST_CASE("viscosity: its work is that of the mean of old and new q") {
  auto state = fluid.initial<double>();
  double work = 0;
  for (int i = 0; i < 50; ++i) {
    const auto before = state;
    fluid.update(state, Matrix::identity() * (1e-3 * std::sin(0.2 * i)), step);
    const double dv = (get<field::VolumeRatio>(state) - get<field::VolumeRatio>(before)) / 2700;
    work -= 0.5 * (get<field::ViscousPressure>(before) + get<field::ViscousPressure>(state)) * dv;
    REQUIRE(get<field::ViscousWork>(state) == Approx(work).epsilon(1e-11));
  }
  CHECK(work > 0);
}

TEST_CASE(
    "viscosity: a material without it stores nothing and needs no step, and with it, pressure and sound are the same") {
  const Material inviscid{hugoniot};
  CHECK(std::is_same_v<decltype(inviscid)::particle_fields, fields<field::VolumeRatio>>);
  CHECK_FALSE(decltype(inviscid)::viscous);
  auto a = inviscid.initial<double>();
  auto b = fluid.initial<double>();
  inviscid.update(a, Matrix::identity() * -1e-3);
  fluid.update(b, Matrix::identity() * -1e-3, step);
  CHECK(fluid.pressure(b) == inviscid.pressure(a));
  CHECK(fluid.sound_speed2(b) == inviscid.sound_speed2(a));
  CHECK(inviscid.signal_speed2(a) == inviscid.sound_speed2(a));
  CHECK(fluid.signal_speed2(b) > fluid.sound_speed2(b));
}

TEST_CASE("viscosity: the signal speed is c (z + sqrt(1 + z^2)), z = A1 + A2 h |D|/c") {
  const double c = 5000;
  for (const double u : {0.0, 10.0, 1000.0, 1e5}) {
    const double z = 0.3 + 1.7 * u / c, speed = c * (z + std::sqrt(1 + z * z));
    CHECK(shock.signal_speed2(2700.0, c * c, shock.pressure(2700.0, c, u)) == Approx(speed * speed).epsilon(1e-12));
  }
  // without sound, that of the damping alone: z c = A2 h |D|
  CHECK(shock.signal_speed2(2700.0, 0.0, 2700 * 1.7 * 100.0 * 100) ==
        Approx(std::pow(2 * 1.7 * 100, 2)).epsilon(1e-12));
  CHECK(viscosity::VonNeumann{.linear = 0, .quadratic = 0}.signal_speed2(2700.0, c * c, 0.0) == Approx(c * c));
}

TEST_CASE("viscosity: h over the signal speed is the stability limit of a chain of masses") {
  // the shortest wave: K/m = (2 c/h)^2, C/K = A1 h/c; v += dt (-K x - C v), x += dt v
  for (const double a1 : {0.0, 0.2, 1.0, 5.0}) {
    const viscosity::VonNeumann linear{.linear = a1, .quadratic = 0};
    const double c = 5000, h = 1e-6, k = 4 * c * c / (h * h), damping = k * a1 * h / c;
    const double limit = h / std::sqrt(linear.signal_speed2(2700.0, c * c, 0.0));
    const auto growth = [&](double dt) {  // the larger eigenvalue of the step
      const double trace = 2 - dt * damping - dt * dt * k, det = 1 - dt * damping;
      const std::complex<double> root = std::sqrt(std::complex<double>(0.25 * trace * trace - det));
      return std::max(std::abs(0.5 * trace + root), std::abs(0.5 * trace - root));
    };
    CHECK(growth(0.999 * limit) < 1 + 1e-12);
    CHECK(growth(1.001 * limit) > 1 + 1e-4);
  }
}

TEST_CASE("viscosity: the solver's time step allows for it") {
  const auto first_step = [](const auto& material) {
    Solver solver{grid::Cartesian<1>{.spacing = 1e-6}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{.courant = 0.4},
                  material};
    solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1e-5}}, material, {});
    return solver.step();
  };
  CHECK(first_step(Material{hugoniot}) == Approx(0.4e-6 / 5350).epsilon(1e-12));
  CHECK(first_step(fluid) == Approx(0.4e-6 / (5350 * (0.3 + std::sqrt(1.09)))).epsilon(1e-12));
}

TEST_CASE("viscosity: energies of a bar that hits a wall add up but for the transfers, to first order in the step") {
  const auto errors = [](double dt) {
    const Material m{hugoniot, energy::Full{}, viscosity::VonNeumann{.linear = 0.5, .quadratic = 4}};
    Solver solver{grid::Cartesian<1>{.spacing = 1e-6},
                  shape::QuadraticBSpline{},
                  transfer::Flip{},
                  timestep::Fixed{dt},
                  boundary::RigidWall{.side = side::x_min, .at = 0},
                  m};
    solver.fill(geometry::Box<1>{.lower = {0}, .upper = {30e-6}}, m, {.velocity = {-500}});
    const auto start = observe::ledger(solver);
    solver.run({.until = 3e-9});
    const auto now = observe::ledger(solver);
    CHECK(now.viscous > 0.01 * start.kinetic);
    CHECK(now.elastic > 0.1 * start.kinetic);
    // work of the forces on the grid against what the particles took up
    return std::abs(now.elastic + now.viscous + now.work - start.work) / start.kinetic;
  };
  const double coarse = errors(20e-12), fine = errors(10e-12), finest = errors(5e-12);
  INFO(coarse << ' ' << fine << ' ' << finest);
  CHECK(coarse < 0.01);
  CHECK(std::log2(coarse / fine) > 0.8);
  CHECK(std::log2(fine / finest) > 0.8);
}

TEST_CASE("viscosity: the ledger and the history carry its work") {
  Solver solver{grid::Cartesian<1>{.spacing = 1e-6}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, fluid};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1e-5}}, fluid,
              {.velocity = [](const Vec<double, 1>& x) { return Vec<double, 1>{-1e8 * x[0]}; }});
  observe::History history;
  solver.run({.until = 0.2e-9}, history);
  double sum = 0;
  for (std::size_t i = 0; i < solver.size(); ++i)
    sum += solver.particles().get<field::Mass>(i) * solver.particles().get<field::ViscousWork>(i);
  CHECK(sum > 0);
  CHECK(observe::ledger(solver).viscous == Approx(sum).epsilon(1e-12));
  CHECK(history.samples.back().viscous == Approx(sum).epsilon(1e-12));
}

TEST_CASE("viscosity: impossible parameters are refused in a sentence") {
  const auto complaint = [](const viscosity::VonNeumann& part) -> std::string {
    try {
      part.validate();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(complaint(shock).empty());
  CHECK(complaint({.linear = -1}) == "mote: the linear viscosity is -1; it must be >= 0 and < 1e6");
  CHECK(complaint({.quadratic = -2}) == "mote: the quadratic viscosity is -2; it must be >= 0 and < 1e12");
  CHECK_THROWS_AS((Material{hugoniot, viscosity::VonNeumann{.linear = std::nan("")}}), InputError);
}
