/// \file
/// AxisProfile: means over short bins of a thin column of particles along the last axis.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <mote/core/vec.hpp>
#include <mote/observe/file.hpp>
#include <mote/observe/schedule.hpp>

namespace mote::observe {

/// Means over the particles of one bin.
struct AxisBin {
  double position;     ///< of the bin's middle, m
  double velocity;     ///< component along the axis, mass-weighted, m/s
  double pressure;     ///< volume-weighted, Pa
  double temperature;  ///< mass-weighted, K; nan without one
  double density;      ///< mass of the particles over their current volume, kg/m^3
};

namespace detail {

struct BinSums {
  double mass = 0, momentum = 0, heat = 0, heated = 0, volume = 0, push = 0;

  AxisBin mean(double position) const {
    return {position, momentum / mass, push / volume, heated > 0 ? heat / heated : nan, mass / volume};
  }
};

/// Numbers of the particles with |x_a - centre_a| < width across the axis, in their order; periods count.
template <class Solver, class Particles>
std::vector<std::vector<std::size_t>> column_of(const Solver& solver, const Particles& particles,
                                                const Vec<double, 3>& centre, double width) {
  constexpr int D = Solver::dimension;
  std::vector<std::vector<std::size_t>> found(chunks(particles.size()));
  for_chunks(solver.executor(), particles.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      bool inside = true;
      for (int a = 0; a < D - 1 && inside; ++a) {
        double off = double(particles.template column<field::Position>(a)[p]) - centre[a];
        if (const double period = solver.domain().period(a); period > 0) off -= period * std::round(off / period);
        inside = std::abs(off) < width;
      }
      if (inside) found[first / chunk].push_back(p);
    }
  });
  return found;
}

}  // namespace detail

/// Means over bins along the last axis, bin i from i * bin to (i + 1) * bin (m), of the particles less than one grid
/// spacing off the axis through `centre` (of which the last component does not count; in one dimension all particles
/// do). By rising position; bins without particles are left out.
template <class Solver>
std::vector<AxisBin> axis_profile(const Solver& solver, const Vec<double, 3>& centre, double bin) {
  constexpr int D = Solver::dimension, z = D - 1;
  using T = typename Solver::number;
  require(bin > 0, "the bins of an axis profile are ", bin, " m long; they must be > 0");
  std::map<std::int64_t, detail::BinSums> bins;
  solver.for_each_body([&](const auto& material, const auto& particles) {
    using State = particle_fields_of<std::remove_cvref_t<decltype(material)>>;
    Values<T, D, State> values;
    for (const auto& found : detail::column_of(solver, particles, centre, solver.spacing()))
      for (const std::size_t p : found) {
        const double at = solver.domain().wrapped_position(z, double(particles.template column<field::Position>(z)[p]));
        auto& sums = bins[std::int64_t(std::floor(at / bin))];
        particles.load(p, values);
        const double m = double(particles.template column<field::Mass>()[p]);
        const double volume = m * double(get<field::VolumeRatio>(values)) / material.rho0();
        sums.mass += m, sums.volume += volume;
        sums.momentum += m * double(particles.template column<field::Velocity>(z)[p]);
        sums.push += volume * double(material.pressure(values));
        if constexpr (contains<State, field::Temperature>)
          sums.heat += m * double(get<field::Temperature>(values)), sums.heated += m;
      }
  });
  std::vector<AxisBin> means;
  for (const auto& [i, sums] : bins) means.push_back(sums.mean((double(i) + 0.5) * bin));
  return means;
}

/// Writes an axis_profile() at each frame time as rows `time_ns,z_um,vz_m_s,p_mpa,t_k,rho_kg_m3` of `file`.
///
/// z is the last axis. Throws OutputError if a row cannot be written; rows before it stay.
struct AxisProfile {
  std::filesystem::path file = {};  ///< empty: only `bins`
  double every = 0.5e-9;            ///< s, > 0
  std::optional<int> frames = {};   ///< instead of `every`: so many, evenly spaced, first and last included; 0: none
  double bin = 0.5e-6;              ///< length of a bin, m
  Vec<double, 3> centre = {};       ///< a point on the axis, m

  std::vector<AxisBin> bins = {};  ///< the last profile
  static constexpr bool only_when_due = true;

  template <class Solver, class Run>
  void begin(const Solver& solver, const Run& run) {
    schedule_ = Schedule::of(every, frames, solver.time(), run.until);
    bins.clear();
    file_ = file.empty() ? nullptr : std::make_unique<LineFile>(file, "time_ns,z_um,vz_m_s,p_mpa,t_k,rho_kg_m3");
    observe(solver);
  }
  double due() const { return schedule_.due(); }
  template <class Solver>
  void observe(const Solver& solver) {
    if (schedule_.wants(solver.time())) sample(solver);
  }
  template <class Solver>
  void end(const Solver& solver) {
    if (schedule_.wants_end(solver.time())) sample(solver);
    if (file_) file_->close();
  }

  template <class Solver>
  void sample(const Solver& solver) {
    bins = axis_profile(solver, centre, bin);
    if (file_)
      for (const AxisBin& b : bins)
        file_->row(1e9 * solver.time(), 1e6 * b.position, b.velocity, 1e-6 * b.pressure, b.temperature, b.density);
    schedule_.done(solver.time());
  }

  // What it remembers; not to be set.
  Schedule schedule_ = {};
  std::unique_ptr<LineFile> file_ = {};
};

}  // namespace mote::observe
