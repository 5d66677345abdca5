/// \file
/// The scene: aluminium with a spherical cavity, launched off a rigid wall. Everything that mote is asked to do is
/// here.
#pragma once

#include <filesystem>
#include <mote/mote.hpp>
#include <mote/observe/axis_profile.hpp>
#include <mote/observe/history.hpp>
#include <mote/observe/progress.hpp>
#include <mote/observe/vti.hpp>
#include <mote/observe/vtp.hpp>
#include <optional>

#include "result.hpp"

namespace cavity {

inline constexpr double um = 1e-6, ns = 1e-9, mpa = 1e6;

template <bool conducts>
auto aluminium(const Options& o) {
  const auto heat = [&] {
    if constexpr (conducts)
      return mote::heat::Conducting{.specific_heat = 880, .initial_temperature = 300, .conductivity = o.conductivity};
    else
      return mote::heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300};
  };
  return mote::Material{
      mote::eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
      mote::strength::VonMises{
          .shear_modulus = 69e9 / (2 * (1 + 0.33)), .yield = o.yield * mpa, .hardening = o.hardening * mpa},
      heat()};
}

template <class T>
T make_transfer(const Options& o) {
  T t;
  if constexpr (requires { t.blend; }) t.blend = o.flip_blend.value_or(t.blend);
  if constexpr (requires { t.order; }) t.order = o.order.value_or(t.order);
  return t;
}

/// Fills the body. Of the quarter, fill() leaves out what lies beyond the symmetry planes.
template <class Solver, class Material>
void fill(Solver& solver, const Material& metal, const Options& o) {
  namespace geometry = mote::geometry;
  const double w = half_width * um;
  const geometry::Box<3> block{.lower = {-w, -w, 0}, .upper = {w, w, height * um}};
  const mote::Fill<3> how{.per_axis = o.per_axis,
                          .velocity = {0.0, 0.0, o.speed},
                          .method = o.fill == Fill::lattice ? geometry::Method::lattice : geometry::Method::fraction,
                          .jitter = o.jitter,
                          .seed = std::uint64_t(o.seed)};
  if (o.radius > 0)
    solver.fill(block - geometry::Ball<3>{.centre = {0, 0, o.centre_z * um}, .radius = o.radius * um}, metal, how);
  else
    solver.fill(block, metal, how);
}

inline mote::observe::History make_history(const Options& o, const Voice& voice) {
  const bool quarter = o.domain == Domain::quarter;
  mote::observe::History history{.file = std::filesystem::path(o.out) / "history.csv",
                                 .every = o.sample * ns,
                                 .axis = mote::axis::z,
                                 .copies = quarter ? 4 : 1,
                                 .notice = voice.notice};
  if (o.radius > 0)
    history.cavity = mote::observe::Cavity{.centre = {0, 0, o.centre_z * um}, .mirrored = {quarter, quarter}};
  return history;
}

/// Runs a filled solver with everything that watches it.
template <class Solver>
Result run(Solver& solver, const Options& o, const Voice& voice) {
  using namespace mote;
  const std::filesystem::path out = o.out;
  const std::vector<int> mirror = o.domain == Domain::quarter ? std::vector{axis::x, axis::y} : std::vector<int>{};
  auto history = make_history(o, voice);
  observe::AxisProfile profile{.file = out / "axis.csv", .frames = o.frames};
  observe::Vtp particles{.stem = out / "frames" / "particles", .frames = o.frames, .mirror = mirror};
  observe::Vti nodes{.stem = out / "frames" / "grid", .frames = o.frames, .mirror = mirror};
  observe::Progress progress{.sink = voice.progress, .seconds = voice.seconds};
  Result result;
  try {
    solver.run({.until = o.until * ns}, history, profile, particles, nodes, progress);
  } catch (const NumericalError& error) {
    result.failure = error.what();
    if (o.frames > 0) particles.end(solver);
  }
  result.particles = solver.size();
  result.steps = solver.steps();
  result.threads = solver.executor().concurrency();
  result.step_seconds = solver.seconds();
  if (!history.samples.empty()) result.first = history.samples.front(), result.last = history.samples.back();
  return result;
}

/// Assembles a solver from these parts and the options, and runs it.
template <class Shape, class Transfer, class Update, class T, bool conducts>
Result simulate(const Options& o, const Voice& voice) {
  using namespace mote;
  const auto metal = aluminium<conducts>(o);
  const auto rest = [&] {
    if constexpr (conducts)
      return sleep::Never{};
    else
      return sleep::Quiescent{.tolerance = o.sleep_tolerance, .enabled = o.sleep.value_or(true)};
  };
  // optional, so that full and quarter are one type of solver, compiled once
  const bool full = o.domain == Domain::full;
  const double w = half_width * um;
  const auto period = [&](int a) {
    return full ? std::optional(boundary::Periodic{.axis = a, .from = -w, .to = w}) : std::nullopt;
  };
  const auto mirror = [&](Side s, double at) {
    return full ? std::nullopt : std::optional(boundary::Symmetry{.side = s, .at = at});
  };
  Solver solver{grid::Cartesian<3, T>{.spacing = o.spacing * um},
                Shape{},
                make_transfer<Transfer>(o),
                Update{},
                timestep::Cfl{.courant = o.courant},
                execution::Threads{o.threads},
                rest(),
                boundary::RigidWall{.side = side::z_min, .at = 0},
                period(axis::x),
                period(axis::y),
                mirror(side::x_min, 0),
                mirror(side::x_max, w),
                mirror(side::y_min, 0),
                mirror(side::y_max, w),
                metal};
  fill(solver, metal, o);
  return run(solver, o, voice);
}

/// Bytes of a particle's columns.
template <class Shape, class Transfer, class T>
constexpr int bytes_per_particle() {
  using namespace mote;
  using Any =
      decltype(Solver{grid::Cartesian<3, T>{}, Shape{}, Transfer{}, timestep::Cfl{}, aluminium<false>(Options{})});
  return Any::template bytes_per_particle<>;
}

/// An entry of the table in combinations.cpp: the words for the parts, and the parts.
template <class S, class X, class U, class T, bool conducts = false>
constexpr Combination combination(Shape shape, Transfer transfer, Update update) {
  return {shape,
          transfer,
          update,
          sizeof(T) == 4 ? Precision::single_ : Precision::double_,
          conducts,
          bytes_per_particle<S, X, T>(),
          &simulate<S, X, U, T, conducts>};
}

}  // namespace cavity
