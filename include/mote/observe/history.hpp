/// \file
/// History: a row of a CSV file, and a Sample in memory, per sampling time.
#pragma once

#include <functional>
#include <string>

#include <mote/grid/domain.hpp>
#include <mote/observe/extremes.hpp>
#include <mote/observe/file.hpp>
#include <mote/observe/ledger.hpp>
#include <mote/observe/void_component.hpp>

namespace mote::observe {

/// The cavity that a History follows, in three dimensions (VoidComponent says how).
struct Cavity {
  Vec<double, 3> centre;              ///< a point inside it at the start, m
  std::array<bool, 2> mirrored = {};  ///< x, y: the lower side is a symmetry plane through the cavity
};

/// What a History knows of one time, in SI units, of the whole body; v, momentum and impulse along its axis.
struct Sample {
  double time = 0;                                            ///< s
  std::size_t step = 0;                                       ///< steps done
  VelocityExtremes v = {};                                    ///< particles, m/s
  Range v_grid = {};                                          ///< nodes, m/s; see History
  Range pressure = {};                                        ///< Pa
  double t_max = detail::nan;                                 ///< K; nan without temperature
  VoidSize cavity = {detail::nan, detail::nan, detail::nan};  ///< m^3, m; nan if there is none or it is open
  double kinetic = 0, elastic = 0, plastic = 0, viscous = 0;  ///< J
  double transfer_loss = 0;                                   ///< J, see transfer_loss()
  double wall_loss = 0;                                       ///< J, of which planes took this at once
  double energy_error = 0;                                    ///< see energy_error()
  double mass = 0, momentum = 0, wall_impulse = 0;            ///< kg, kg m/s, N s
  double active_fraction = 1;                                 ///< of the particles, not asleep
};

namespace detail {

inline constexpr const char* history_header =
    "time_ns,step,vz_min_m_s,vz_max_m_s,vz_low_m_s,vz_high_m_s,vz_min_grid_m_s,vz_max_grid_m_s,p_min_mpa,p_max_mpa,"
    "t_max_k,cavity_volume_um3,cavity_width_um,cavity_height_um,kinetic_j,elastic_j,plastic_j,viscous_j,"
    "transfer_loss_j,energy_error,mass_kg,momentum_z_kg_m_s,wall_impulse_z_n_s,active_fraction";

inline void write_row(LineFile& file, const Sample& s) {
  constexpr double ns = 1e9, um = 1e6, um3 = 1e18, mpa = 1e-6;
  file.row(ns * s.time, s.step, s.v.min, s.v.max, s.v.low, s.v.high, s.v_grid.min, s.v_grid.max, mpa * s.pressure.min,
           mpa * s.pressure.max, s.t_max, um3 * s.cavity.volume, um * s.cavity.width, um * s.cavity.height, s.kinetic,
           s.elastic, s.plastic, s.viscous, s.transfer_loss, s.energy_error, s.mass, s.momentum, s.wall_impulse,
           s.active_fraction);
}

/// The solver's domain as VoidComponent sees it.
template <class Solver>
std::array<Extent, 3> void_domain(const Solver& solver, const std::array<bool, 2>& mirrored) {
  std::array<Extent, 3> extents;
  const auto& domain = solver.domain();
  for (int a = 0; a < 3; ++a) {
    Extent e{};
    e.from = solver.frame().node_position(a, 0), e.to = solver.frame().node_position(a, 1);
    if (const auto& lower = domain.plane(a, 0)) {
      e.from = solver.frame().node_position(a, lower->node), e.lower = Extent::plane;
      e.to = solver.frame().node_position(a, lower->node + 1);
    }
    if (const auto& upper = domain.plane(a, 1)) {
      e.to = solver.frame().node_position(a, upper->node), e.upper = Extent::plane;
      if (!domain.plane(a, 0)) e.from = solver.frame().node_position(a, upper->node - 1);
    }
    if (domain.periodic(a))
      e = {domain.lower(a), domain.lower(a) + domain.period(a), Extent::periodic, Extent::periodic};
    e.mirrored = a < 2 && mirrored[std::size_t(a)];
    extents[std::size_t(a)] = e;
  }
  return extents;
}

/// ledger(), pressure_range() and temperature_range() in one sweep over the particles.
template <class Solver>
struct Survey {
  using T = typename Solver::number;
  LedgerSums<Solver::dimension> ledger = {};
  PackRange<T> pressure = {}, temperature = {};

  Survey& operator+=(const Survey& b) {
    ledger += b.ledger, pressure += b.pressure, temperature += b.temperature;
    return *this;
  }
  static Survey of(const Solver& solver) {
    return sum_by_chunk<Survey>(
        solver, [](Survey& s, const auto& material, const auto& particles, std::size_t i, int n) {
          const auto values = load_state<T, field::Velocity, field::Mass>(material, particles, i, n);
          add_to_ledger(s.ledger, material, values, n);
          s.pressure.add(material.pressure(values));
          add_temperature(s.temperature, values);
        });
  }
};

/// Measures the void in all bodies of a 3-D solver.
template <class Solver>
VoidSize measure_void(VoidComponent& cavity, const Solver& solver) {
  std::vector<ParticleColumns<typename Solver::number>> bodies;
  solver.for_each_body([&](const auto& material, const auto& particles) {
    const auto x = [&](int a) { return particles.template column<field::Position>(a); };
    bodies.push_back({x(0), x(1), x(2), particles.template column<field::Mass>(),
                      particles.template column<field::VolumeRatio>(), 1 / material.rho0()});
  });
  return cavity.measure(std::span<const ParticleColumns<typename Solver::number>>(bodies));
}

}  // namespace detail

/// Samples the run every `every` seconds, the start and the end included, into `samples` and as rows of `file`:
///
///     time_ns, step                                     step: steps done
///     vz_min_m_s, vz_max_m_s, vz_low_m_s, vz_high_m_s   velocity_extremes()
///     vz_min_grid_m_s, vz_max_grid_m_s                  grid_velocity_range(); nan at the start
///     p_min_mpa, p_max_mpa, t_max_k                     pressure_range(), temperature_range()
///     cavity_volume_um3, _width_um, _height_um          VoidComponent; nan once it is open
///     kinetic_j ... viscous_j, mass_kg, momentum_z_kg_m_s, wall_impulse_z_n_s    ledger()
///     transfer_loss_j, energy_error                     transfer_loss(), energy_error(), since the start of the run
///     active_fraction                                   Solver::active_fraction(); 1 at the start
///
/// One object serves one run at a time; run() begins it anew. Throws OutputError if a row cannot be written: rows
/// before it stay.
struct History {
  std::filesystem::path file = {};  ///< empty: only `samples`
  double every = 0.1e-9;            ///< s, > 0
  int axis = -1;                    ///< component of v, momentum and impulse; -1: the last
  int copies = 1;                   ///< how many times the body holds what runs; 4 for a quarter
  double volume = 12.5e-18;         ///< of the whole body that `low` and `high` average over, m^D
  std::optional<Cavity> cavity = {};
  std::function<void(const std::string&)> notice = {};  ///< is told once if the cavity opens to the outside

  static constexpr bool only_when_due = true;
  std::vector<Sample> samples = {};  ///< of the run, the last one at the back

  template <class Solver, class Run>
  void begin(const Solver& solver, const Run& run) {
    require(copies >= 1, "a history is of ", copies, " copies; it must be of 1 or more");
    component_ = detail::resolved_axis(axis, Solver::dimension);
    schedule_ = Schedule::periodic(every, solver.time(), run.until);
    samples.clear();
    void_.reset();
    if constexpr (Solver::dimension == 3)
      if (cavity) void_.emplace(solver.spacing(), detail::void_domain(solver, cavity->mirrored), cavity->centre);
    file_ = file.empty() ? nullptr : std::make_unique<LineFile>(file, detail::history_header);
    sample(solver, false);
  }
  double due() const { return schedule_.due(); }
  template <class Solver>
  void observe(const Solver& solver) {
    if (schedule_.wants(solver.time())) sample(solver, true);
  }
  template <class Solver>
  void end(const Solver& solver) {
    if (schedule_.wants_end(solver.time())) sample(solver, solver.steps() > 0);
    if (file_) file_->close();
  }

  // What it remembers between samples; not to be set.
  Schedule schedule_ = {};
  std::unique_ptr<LineFile> file_ = {};
  std::optional<VoidComponent> void_ = {};
  Ledger start_ = {};
  int component_ = 0;

  template <class Solver>
  void sample(const Solver& solver, bool nodes_are_of_step) {
    const auto survey = detail::Survey<Solver>::of(solver);
    const Ledger now = detail::whole_ledger(solver, survey.ledger, copies);
    if (samples.empty()) start_ = now;
    Sample s;
    s.time = solver.time(), s.step = solver.steps();
    s.v = velocity_extremes(solver, component_, volume / copies);
    if (nodes_are_of_step) {
      s.v_grid = grid_velocity_range(solver, component_);
      s.active_fraction = solver.active_fraction();
    }
    s.pressure = survey.pressure.range();
    s.t_max = survey.temperature.range().max;
    if constexpr (Solver::dimension == 3)
      if (void_) s.cavity = detail::measure_void(*void_, solver);
    s.kinetic = now.kinetic, s.elastic = now.elastic, s.plastic = now.plastic, s.viscous = now.viscous;
    s.transfer_loss = mote::observe::transfer_loss(start_, now),
    s.energy_error = mote::observe::energy_error(start_, now);
    s.wall_loss = now.wall_loss - start_.wall_loss;
    s.mass = now.mass, s.momentum = now.momentum[component_], s.wall_impulse = now.wall_impulse[component_];
    const bool opens = s.cavity.open && (samples.empty() || !samples.back().cavity.open);
    samples.push_back(s);
    if (file_) detail::write_row(*file_, s);
    schedule_.done(s.time);
    if (opens && notice)
      notice(text("the cavity is open to the outside from ", 1e9 * s.time, " ns on; its size is nan"));
  }
};

}  // namespace mote::observe
