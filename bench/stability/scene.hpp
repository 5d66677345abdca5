/// \file
/// The parts of mote_bench_stability in three dimensions.
#pragma once

#include "../../tests/stability/scene.hpp"
#include "report.hpp"

namespace stability {

template <class S>
class SceneReport {
  const char* scheme_;

  void row(const char* experiment, double parameter, const char* quantity, double value) const {
    std::printf("%s,%s,%.6g,%s,%.6g\n", experiment, scheme_, parameter, quantity, value);
    std::fflush(stdout);
  }
  void place(const char* experiment, double time, const char* which, const Place& p) const {
    std::fprintf(stderr,
                 "%s,%s,%.2f ns,%s P %.3f GPa, particle %u at (%.2f, %.2f, %.2f) um, V/V0 %.4f, plastic work %.0f "
                 "J/kg, mass %.3f, vz %.1f m/s\n",
                 experiment, scheme_, time, which, 1e-9 * p.pressure, p.id, 1e6 * p.at[0], 1e6 * p.at[1], 1e6 * p.at[2],
                 p.volume_ratio, p.energy, p.mass, p.velocity);
  }

 public:
  explicit SceneReport(const char* scheme) : scheme_(scheme) {}

  /// Runs to `until` ns; a row per `every` ns of the extremes, and the largest kick a node got in between.
  void run(const char* experiment, const Block& block, double until, double every) const {
    const auto solver = make_block<S>(block);
    const auto start = observe::ledger(*solver);
    Kick most;
    double p_max = 0, p_min = 0, next = 0;
    const auto end = march(*solver, until * 1e-9, [&] {
      const double t = 1e9 * solver->time();
      const auto kick = largest_kick(*solver);
      if (kick.velocity > most.velocity) most = kick;
      if (t < next && t < until) return true;
      next += every;
      const auto e = extremes(*solver, block.per_axis);
      p_max = std::max(p_max, e.high.pressure), p_min = std::min(p_min, e.low.pressure);
      place(experiment, t, "low", e.low), place(experiment, t, "high", e.high);
      row(experiment, t, "p_min_gpa", 1e-9 * e.low.pressure), row(experiment, t, "p_max_gpa", 1e-9 * e.high.pressure);
      row(experiment, t, "above_0.3_gpa", e.above), row(experiment, t, "below_-1.5_gpa", e.below);
      row(experiment, t, "kick_m_s", most.velocity), row(experiment, t, "kick_mass", most.mass);
      row(experiment, t, "kick_z_um", 1e6 * most.height);
      most = {};
      return std::isfinite(e.high.pressure);
    });
    if (block.centre == 10 && block.radius == 5) {
      const auto under =
          layers(*solver, block.per_axis, std::size_t(6 / block.spacing), 2.5e-6, 1e-6 * block.half_width);
      for (std::size_t k = 0; k < under.size(); ++k) {
        const double z = (double(k) + 0.5) * block.spacing / block.per_axis;
        row(experiment, z, "layer_mean_gpa", 1e-9 * under[k].mean);
        row(experiment, z, "layer_scatter_gpa", 1e-9 * under[k].scatter);
        row(experiment, z, "layer_max_gpa", 1e-9 * under[k].pressure.most);
      }
    }
    row(experiment, -1, "ended_ns", 1e9 * end.time), row(experiment, -1, "NumericalError", end.failed());
    row(experiment, -1, "p_min_gpa", 1e-9 * p_min), row(experiment, -1, "p_max_gpa", 1e-9 * p_max);
    row(experiment, -1, "energy_error", observe::energy_error(start, observe::ledger(*solver)));
    if (end.failed()) std::fprintf(stderr, "%s %s: %s\n", experiment, scheme_, end.error.c_str());
  }
};

/// The table's small scenes: a block of 10 x 10 x 24 um (a quarter) with a cavity of 3 um.
template <class S>
void small_scenes(const SceneReport<S>& report) {
  const Block small{.half_width = 10, .height = 24, .radius = 3, .centre = 8};
  const auto with = [&](auto change) {
    Block b = small;
    change(b);
    return b;
  };
  for (const double v : {1000, 2000, 5000})
    report.run(text("small_", v, "_m_s").c_str(), with([&](Block& b) { b.speed = v; }), 4, 1);
  for (const double v : {-1000, -5000})
    report.run(text("small_", v, "_m_s").c_str(), with([&](Block& b) { b.speed = v; }), 2, 0.5);
  for (const int n : {1, 3})
    report.run(text("small_", n * n * n, "_per_cell").c_str(), with([&](Block& b) { b.per_axis = n; }), 4, 1);
  report.run("small_touches_wall", with([](Block& b) { b.centre = 3; }), 4, 1);
  report.run("small_half_cell_from_wall", with([](Block& b) { b.centre = 3.5; }), 4, 1);
  report.run("small_half_cell_from_top", with([](Block& b) { b.centre = 20.5; }), 8, 2);
  report.run("small_two_a_cell_apart", with([](Block& b) { b.second_centre = 15, b.speed = 400; }), 8, 2);
}

}  // namespace stability
