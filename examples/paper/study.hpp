/// \file
/// The cavity program's scene and its default scheme with other materials, and frames at chosen times.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../cavity/scene.hpp"

namespace study {

/// What study adds to the cavity program's options.
struct Extra {
  std::string material = "default";
  std::vector<double> frames, particles;  ///< ns, rising: times of grid and of particle frames
};

/// An observer that writes frames, at a list of times instead of evenly spaced ones.
template <class Writer>
struct At {
  Writer writer;
  std::vector<double> times;  ///< s, rising
  std::size_t next = 0;
  static constexpr bool only_when_due = true;

  template <class Solver, class Run>
  void begin(const Solver& solver, const Run& run) {
    writer.frames = 0;  // none by itself
    writer.begin(solver, run);
    observe(solver);
  }
  double due() const { return next < times.size() ? times[next] : std::numeric_limits<double>::infinity(); }
  template <class Solver>
  void observe(const Solver& solver) {
    if (solver.time() < due()) return;
    writer.write(solver);
    while (due() <= solver.time()) ++next;
  }
  template <class Solver>
  void end(const Solver& solver) {
    observe(solver);
  }
};

inline std::vector<double> seconds(std::vector<double> ns) {
  for (double& t : ns) t *= cavity::ns;
  return ns;
}

/// Runs the filled solver; of the body, frames hold the quarter that is simulated.
template <class Solver>
cavity::Result watch(Solver& solver, const cavity::Options& o, const Extra& extra, const cavity::Voice& voice) {
  using namespace mote;
  const std::filesystem::path out = o.out;
  auto history = cavity::make_history(o, voice);
  observe::AxisProfile profile{.file = out / "axis.csv", .every = 0.2 * cavity::ns};
  At<observe::Vti> nodes{{.stem = out / "frames" / "grid"}, seconds(extra.frames)};
  At<observe::Vtp> particles{{.stem = out / "frames" / "particles"}, seconds(extra.particles)};
  observe::Progress progress{.sink = voice.progress, .seconds = voice.seconds};
  cavity::Result result;
  try {
    solver.run({.until = o.until * cavity::ns}, history, profile, nodes, particles, progress);
  } catch (const NumericalError& error) {
    result.failure = error.what();
  }
  result.particles = solver.size(), result.steps = solver.steps();
  result.threads = solver.executor().concurrency(), result.step_seconds = solver.seconds();
  if (!history.samples.empty()) result.first = history.samples.front(), result.last = history.samples.back();
  return result;
}

/// A quarter of the scene, made of this metal, in the cavity program's default scheme.
template <class Metal>
cavity::Result simulate(const Metal& metal, const cavity::Options& o, const Extra& extra, const cavity::Voice& voice) {
  using namespace mote;
  const auto rest = [&] {
    if constexpr (requires { metal.heat.conductivity; })
      return sleep::Never{};  // heat flows in material at rest too
    else
      return sleep::Quiescent{.tolerance = o.sleep_tolerance, .enabled = o.sleep.value_or(true)};
  };
  const double w = cavity::half_width * cavity::um;
  Solver solver{grid::Cartesian<3>{.spacing = o.spacing * cavity::um},
                shape::QuadraticBSpline{},
                cavity::make_transfer<transfer::AffineFlip>(o),
                update::Usl{},
                timestep::Cfl{.courant = o.courant},
                execution::Threads{o.threads},
                rest(),
                boundary::Symmetry{.side = side::x_min, .at = 0},
                boundary::Symmetry{.side = side::x_max, .at = w},
                boundary::Symmetry{.side = side::y_min, .at = 0},
                boundary::Symmetry{.side = side::y_max, .at = w},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                metal};
  cavity::fill(solver, metal, o);
  return watch(solver, o, extra, voice);
}

// The parts of the default material, from which a choice departs.
inline mote::eos::MieGruneisen pressure_law() { return {.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96}; }
inline mote::heat::Adiabatic warmth() { return {.specific_heat = 880, .initial_temperature = 300}; }
inline constexpr double young = 69e9, poisson = 0.33, shear = young / (2 * (1 + poisson));
inline mote::strength::VonMises flow_law(const cavity::Options& o) {
  return {.shear_modulus = shear, .yield = o.yield * cavity::mpa, .hardening = o.hardening * cavity::mpa};
}

/// One reading of the paper's equations.
struct Choice {
  const char *name, *what;
  cavity::Result (*run)(const cavity::Options&, const Extra&, const cavity::Voice&);
};

// Each list is compiled in a file of its own name.
extern const std::vector<Choice> choices_numbers, choices_eos, choices_strength;

}  // namespace study
