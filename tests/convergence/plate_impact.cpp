// An aluminium flyer on a copper target in one dimension, beside the exact impact: the scene of
// examples/plate_impact.cpp. Measured at h = 10 um: both sides within 0.31% in stress and 0.16% in velocity; more on a
// finer grid, but not so with the interface at rest on the grid. docs/verification.md has the table and the cause.
#include "catch.hpp"

#include <array>

#include <mote/mote.hpp>

namespace {

using namespace mote;

const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                         strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                         heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
const Material copper{eos::MieGruneisen{.rho0 = 8930, .c0 = 3940, .lambda = 1.489, .gamma0 = 2.02},
                      strength::VonMises{.shear_modulus = 47.7e9, .yield = 120e6},
                      heat::Adiabatic{.specific_heat = 383, .initial_temperature = 300}};
using Metal = std::remove_const_t<decltype(copper)>;

/// Errors of the means over the middle 60% of a plateau, relative; of the velocity relative to the impact's speed. And
/// the largest of the velocity ahead of all waves, m/s.
struct Errors {
  double stress = 0, velocity = 0, temperature = 0, ahead = 0;
};

constexpr double speed = 500, duration = 0.5e-6;  // m/s, s

/// Seen by someone who moves along z at `frame` m/s.
template <class Particles>
Errors errors(const Metal& metal, const Particles& plate, const exact::Stretch& plateau, const exact::Stretch& rest,
              double frame) {
  Errors e;
  double n = 0;
  for (std::size_t i = 0; i < plate.size(); ++i) {
    Metal::State<double, 1> state;
    plate.load(i, state);
    const double z = plate.template column<field::Position>()[i] + frame * duration;
    const double v = plate.template column<field::Velocity>()[i] + frame;
    if (std::max(rest.from - z, z - rest.to) < -0.4e-3) e.ahead = std::max(e.ahead, std::abs(v - rest.state.velocity));
    if (std::abs(z - 0.5 * (plateau.from + plateau.to)) > 0.3 * (plateau.to - plateau.from)) continue;
    e.stress += metal.stress(state)(0, 0), e.velocity += v, e.temperature += get<field::Temperature>(state), ++n;
  }
  e.stress = std::abs(e.stress / n / plateau.state.stress - 1);
  e.velocity = std::abs(e.velocity / n - plateau.state.velocity) / speed;
  e.temperature = std::abs(e.temperature / n / plateau.state.temperature - 1);
  return e;
}

/// In the flyer and in the target.
std::array<Errors, 2> run(double spacing, double frame) {
  Solver solver{grid::Cartesian<1>{.spacing = spacing},
                shape::QuadraticBSpline{},
                transfer::Flip{.blend = 0.65},
                timestep::Cfl{.courant = 0.4},
                copper,
                aluminium};
  solver.fill(geometry::Box<1>{.lower = {-4e-3}, .upper = {0}}, aluminium,
              {.per_axis = 4, .velocity = {speed - frame}});
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {3e-3}}, copper, {.per_axis = 4, .velocity = {-frame}});
  const auto before = observe::ledger(solver);
  solver.run({.until = duration});
  const double size = before.mass * speed;
  CHECK(std::abs(observe::ledger(solver).momentum[0] - before.momentum[0]) < 1e-12 * size);

  const auto all = exact::profile(exact::impact(aluminium, copper, speed), duration);
  REQUIRE(all.size() == 6);
  return {errors(aluminium, solver.particles(aluminium), all[2], all[0], frame),
          errors(copper, solver.particles(copper), all[3], all[5], frame)};
}

}  // namespace

TEST_CASE("plate impact: both plateaus within 0.5% in stress and 0.4% in velocity", "[impact]") {
  for (const Errors& e : run(10e-6, 0)) {
    CHECK(e.stress < 0.005);
    CHECK(e.velocity < 0.0012);  // 0.4% of the interface's, which is 0.3 of the flyer's
    CHECK(e.temperature < 0.002);
    CHECK(e.ahead < 1e-2);
  }
}

TEST_CASE("plate impact: with the interface at rest on the grid the stress is within 0.2%, on a finer grid too",
          "[impact]") {
  const double frame = exact::impact(aluminium, copper, speed).velocity;
  for (const double spacing : {10e-6, 5e-6})
    for (const Errors& e : run(spacing, frame)) {
      CAPTURE(spacing);
      CHECK(e.stress < 0.002);
      CHECK(e.velocity < 5e-4);  // 0.17% of the interface's
    }
}
