/// \file
/// Rows of the benchmark of phases; bench/phases/*.cpp makes those of one kernel and transfer each.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <string>

#include "counts.hpp"
#include "scene.hpp"

namespace bench {

inline constexpr int phase_count = 5;
/// The last three are MUSL's; USL ends with gather.
inline constexpr std::array<const char*, phase_count> phase_names{"scatter", "grid", "gather", "second_grid", "deform"};

/// Seconds of each phase, step by step.
struct PhaseTimes {
  std::array<std::vector<double>, phase_count> of;

  template <class F>
  void time(std::size_t phase, F&& f) {
    of[phase].push_back(seconds(f));
  }
};

/// update::Usl with a clock between its phases.
struct TimedUsl {
  using role = mote::role::Update;
  static constexpr bool remaps = mote::update::Usl::remaps;
  PhaseTimes* times;

  template <class P>
  void operator()(P& step) const {
    times->time(0, [&] { step.scatter_momentum_and_force(); });
    times->time(1, [&] { step.update_grid(); });
    times->time(2, [&] { step.gather_velocity_and_deform(); });
  }
};

/// update::Musl with a clock between its phases.
struct TimedMusl {
  using role = mote::role::Update;
  static constexpr bool remaps = mote::update::Musl::remaps;
  PhaseTimes* times;

  template <class P>
  void operator()(P& step) const {
    times->time(0, [&] { step.scatter_momentum_and_force(); });
    times->time(1, [&] { step.update_grid(); });
    times->time(2, [&] { step.gather_velocity_and_remap(); });
    times->time(3, [&] { step.constrain_remapped(); });
    times->time(4, [&] { step.deform(); });
  }
};

/// Counts in the order of phase_names.
template <class Update, class C>
std::vector<Count> counts_of(const C& c) {
  if constexpr (Update::remaps)
    return {c.scatter(), c.grid(), c.remap(), c.second_grid(), c.deform()};
  else
    return {c.scatter(), c.grid(), c.gather()};
}

template <class T, class Shape, class Transfer, class Update>
void measure_phases(benchmark::State& state) {
  const Machine& m = machine();
  PhaseTimes times;
  const Scene scene;
  auto solver = scene.template library<T>(Shape{}, Transfer{}, Update{&times}, mote::execution::Serial{});
  solver->step();  // sorts, and touches the memory
  times = {};
  std::vector<double> steps;
  for (auto _ : state) {
    steps.push_back(seconds([&] { solver->step(); }));
    state.SetIterationTime(steps.back());
  }
  const double n = 1e9 / double(solver->size());
  Count all;
  double floors = 0;
  const auto counts = counts_of<Update>(Counts<Shape, Transfer, T, decltype(aluminium())>{.per_cell = 8});
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string name = phase_names[i];
    state.counters[name + "_ns"] = n * median(times.of[i]);
    state.counters[name + "_floor_ns"] = 1e9 * counts[i].template floor<T>(m);
    all = all + counts[i];
    floors += 1e9 * counts[i].template floor<T>(m);
  }
  state.counters["step_ns"] = n * median(steps);
  state.counters["flops"] = all.flops;
  state.counters["bytes"] = all.bytes;
  state.counters["floor_ns"] = floors;
  state.counters["over_floor"] = n * median(steps) / floors;
  state.counters["sort_ns"] = n * seconds([&] { solver->refresh(); });
  state.counters["particles"] = double(solver->size());
}

template <class T, class Shape, class Transfer, class Update>
void add_row(const std::string& name) {
  benchmark::RegisterBenchmark(name.c_str(), measure_phases<T, Shape, Transfer, Update>)
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(11);
}

/// Rows of one kernel and transfer: both precisions, USL and, if `musl`, MUSL.
template <class Shape, class Transfer, bool musl = true>
void add_rows(const std::string& name) {
  add_row<double, Shape, Transfer, TimedUsl>(name + "/usl/double");
  add_row<float, Shape, Transfer, TimedUsl>(name + "/usl/float");
  if constexpr (musl) {
    add_row<double, Shape, Transfer, TimedMusl>(name + "/musl/double");
    add_row<float, Shape, Transfer, TimedMusl>(name + "/musl/float");
  }
}

void add_linear_flip();
void add_linear_apic();
void add_quadratic_flip();
void add_quadratic_apic();
void add_quadratic_aflip();
void add_cubic_flip();
void add_cubic_apic();

}  // namespace bench
