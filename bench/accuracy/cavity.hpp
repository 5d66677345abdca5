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
  if (launch == 100) return {1058, {-170.4, -206, -173, 301}};
  return {3900, {-731, -722, -277, 1062}};
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

/// Two rows: `volume_SPEED`, the relative error of the cavity's volume at 7.2 ns, and `speeds_SPEED`, the largest of
/// the relative errors of `low` at 2, 3 and 7.2 ns and `high` at 7.2 ns. The numbers themselves go into a comment
/// above.
template <class Shape, class Transfer, class Update>
void cavity(const std::string& name, const Transfer& transfer, double launch, double um, int per_axis) {
  const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                       strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6},
                       heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
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
  Watch watch{.history = {.every = 0.2e-9, .axis = axis::z, .copies = 4}};
  watch.history.cavity = observe::Cavity{.centre = {0, 0, 10e-6}, .mirrored = {true, true}};
  const std::string speed = std::to_string(int(launch));
  Row row{.problem = "volume_" + speed, .scheme = name, .h = um, .per_axis = per_axis, .particles = solver.size()};
  bool done = true;
  const double all = bench::seconds([&] {
    try {
      solver.run({.until = 7.2e-9}, watch);
    } catch (const NumericalError& e) {
      done = false;
      std::printf("# %s %s h %g: %s\n", name.c_str(), speed.c_str(), um, e.what());
    }
  });
  row.steps = solver.steps(), row.seconds = all - watch.seconds;
  Row speeds = row;
  speeds.problem = "speeds_" + speed;
  if (done) {
    const auto &a = watch.at(2), &b = watch.at(3), &c = watch.at(7.2);
    const auto right = converged(launch);
    const std::array<double, 4> found{a.v.low, b.v.low, c.v.low, c.v.high};
    const double volume = 1e18 * c.cavity.volume;
    row.error = std::abs(volume / right.volume - 1), speeds.error = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
      speeds.error = std::max(speeds.error, std::abs(found[i] / right.speeds[i] - 1));
    std::printf(
        "# %s %s h %g per_axis %d: V %.1f low %.1f %.1f %.1f high %.1f v %.0f to %.0f p %.2f to %.2f GPa energy "
        "%.2f%%\n",
        name.c_str(), speed.c_str(), um, per_axis, volume, found[0], found[1], found[2], found[3], c.v.min, c.v.max,
        1e-9 * c.pressure.min, 1e-9 * c.pressure.max, 100 * c.energy_error);
  }
  row.print(), speeds.print();
}

/// Both launches on all meshes.
template <class Shape, class Update, class Transfer>
void run_cavity(const Wanted& wanted, const std::string& shape, const std::string& name, const std::string& update,
                const Transfer& transfer) {
  for (const double launch : {100.0, 400.0})
    if (wanted("cavity_" + std::to_string(int(launch)), shape, name, update))
      for (const double um : {1.0, 0.5, 0.25})
        if (um >= wanted.finest)
          cavity<Shape, Transfer, Update>(shape + " " + name + " " + update, transfer, launch, um, 2);
}

}  // namespace accuracy
