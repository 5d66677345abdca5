/// \file
/// The paper's scene: a quarter of the body with the cavity, against its converged values.
#pragma once

#include <array>
#include <mote/mote.hpp>
#include <mote/observe/history.hpp>

#include "report.hpp"

namespace accuracy {

using namespace mote;

/// Volume at 7.2 ns, um^3; `low` at 2, 3 and 7.2 ns and `high` at 7.2 ns, m/s.
struct CavityNumbers {
  double volume;
  std::array<double, 4> speeds;
};

/// Converged values (docs/accuracy.md says how, and how sure they are).
inline CavityNumbers converged(double launch) {
  if (launch == 100) return {1057.4, {-170.0, -200.8, -171.7, 300.6}};
  return {3901, {-731.3, -720.2, -273.7, 1061.6}};
}

/// A history that keeps the time that it takes to itself.
struct Watch {
  observe::History history;
  double seconds = 0;

  static constexpr bool only_when_due = true;
  template <class Solver, class Run>
  void begin(const Solver& solver, const Run& run) {
    seconds += bench::seconds([&] { history.begin(solver, run); });
  }
  double due() const { return history.due(); }
  template <class Solver>
  void observe(const Solver& solver) {
    seconds += bench::seconds([&] { history.observe(solver); });
  }
  template <class Solver>
  void end(const Solver& solver) {
    seconds += bench::seconds([&] { history.end(solver); });
  }
  const observe::Sample& at(double ns) const {
    const observe::Sample* nearest = &history.samples.front();
    for (const auto& s : history.samples)
      if (std::abs(s.time - 1e-9 * ns) < std::abs(nearest->time - 1e-9 * ns)) nearest = &s;
    return *nearest;
  }
};

inline auto aluminium() {
  return Material{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                  strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6},
                  heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
}

/// Calls f(solver) with the filled scene.
template <class Shape, class Transfer, class Update, class F>
auto with_scene(const Transfer& transfer, double launch, double um, int per_axis, const F& f) {
  const auto metal = aluminium();
  Solver solver{grid::Cartesian<3>{.spacing = um * 1e-6},
                Shape{},
                transfer,
                Update{},
                timestep::Cfl{.courant = 0.4},
                sleep::Quiescent{},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                boundary::Symmetry{.side = side::x_max, .at = 20e-6},
                boundary::Symmetry{.side = side::y_min, .at = 0},
                boundary::Symmetry{.side = side::y_max, .at = 20e-6},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                metal};
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {20e-6, 20e-6, 50e-6}} -
                  geometry::Ball<3>{.centre = {0, 0, 10e-6}, .radius = 5e-6},
              metal, {.per_axis = per_axis, .velocity = {0.0, 0.0, launch}, .method = geometry::Method::fraction});
  return f(solver);
}

/// The cost of a step of one transfer over that of another, from 7.2 ns on: three steps of each in turns.
template <class Shape, class Update, class A, class B>
void compare_cost(const char* words, const A& a, const B& b) {
  with_scene<Shape, A, Update>(a, 100, 1, 2, [&](auto& first) {
    with_scene<Shape, B, Update>(b, 100, 1, 2, [&](auto& second) {
      first.run({.until = 7.2e-9}), second.run({.until = 7.2e-9});
      bench::Turns turns;
      const auto three = [](auto& solver) {
        return [&solver] {
          for (int i = 0; i < 3; ++i) solver.step();
        };
      };
      for (int round = 0; round < 15; ++round) turns(three(first), three(second));
      std::printf("# cost %s: %.3f (%.1f and %.1f ns per particle-step, %.0f%% and %.0f%% awake)\n", words,
                  turns.ratio(), 1e9 * turns.first() / 3 / double(first.size()),
                  1e9 * turns.second() / 3 / double(second.size()), 100 * first.active_fraction(),
                  100 * second.active_fraction());
    });
  });
}

/// What a run of the scene gives.
struct CavityRun {
  Row row;
  bool done = true;
  CavityNumbers found = {};
  std::string comment;
};

template <class Solver>
CavityRun run_until_7_2_ns(Solver& solver) {
  Watch watch{.history = {.every = 0.2e-9, .axis = axis::z, .copies = 4}};
  watch.history.cavity = observe::Cavity{.centre = {0, 0, 10e-6}, .mirrored = {true, true}};
  CavityRun run;
  const double all = bench::seconds([&] {
    try {
      solver.run({.until = 7.2e-9}, watch);
    } catch (const NumericalError& e) {
      run.done = false, run.comment = e.what();
    }
  });
  run.row.particles = solver.size(), run.row.steps = solver.steps(), run.row.seconds = all - watch.seconds;
  if (!run.done) return run;
  const auto &a = watch.at(2), &b = watch.at(3), &c = watch.at(7.2);
  run.found = {1e18 * c.cavity.volume, {a.v.low, b.v.low, c.v.low, c.v.high}};
  char text[200];
  std::snprintf(text, sizeof text,
                "V %.1f low %.1f %.1f %.1f high %.1f v %.0f to %.0f p %.2f to %.2f GPa energy %.2f%%", run.found.volume,
                a.v.low, b.v.low, c.v.low, c.v.high, c.v.min, c.v.max, 1e-9 * c.pressure.min, 1e-9 * c.pressure.max,
                100 * c.energy_error);
  run.comment = text;
  return run;
}

/// Two rows: `volume_SPEED`, the relative error of the cavity's volume at 7.2 ns, and `speeds_SPEED`, the largest of
/// the relative errors of `low` at 2, 3 and 7.2 ns and `high` at 7.2 ns. The numbers themselves go into a comment
/// above.
template <class Shape, class Transfer, class Update>
void cavity(const std::string& name, const Transfer& transfer, double launch, double um, int per_axis) {
  const CavityRun run = with_scene<Shape, Transfer, Update>(transfer, launch, um, per_axis,
                                                            [](auto& solver) { return run_until_7_2_ns(solver); });
  const std::string speed = std::to_string(int(launch));
  std::printf("# %s %s h %g per_axis %d: %s\n", name.c_str(), speed.c_str(), um, per_axis, run.comment.c_str());
  Row volume = run.row;
  volume.problem = "volume_" + speed, volume.scheme = name, volume.h = um, volume.per_axis = per_axis;
  Row speeds = volume;
  speeds.problem = "speeds_" + speed;
  if (run.done) {
    const auto right = converged(launch);
    volume.error = std::abs(run.found.volume / right.volume - 1), speeds.error = 0;
    for (std::size_t i = 0; i < right.speeds.size(); ++i)
      speeds.error = std::max(speeds.error, std::abs(run.found.speeds[i] / right.speeds[i] - 1));
  }
  volume.print(), speeds.print();
}

/// Both launches on all meshes.
template <class Shape, class Update, class Transfer>
void run_cavity(const Wanted& wanted, const std::string& shape, const std::string& name, const std::string& update,
                const Transfer& transfer, std::vector<double> meshes = {1, 0.5, 0.25}) {
  for (const double launch : {100.0, 400.0})
    if (wanted("cavity_" + std::to_string(int(launch)), shape, name, update))
      for (const double um : meshes)
        if (um >= wanted.finest)
          cavity<Shape, Transfer, Update>(shape + " " + name + " " + update, transfer, launch, um, 2);
}

}  // namespace accuracy
