/// \file
/// How does the cost per particle-step depend on the number of particles, and on how many lie in a cell?
///
/// Quadratic APIC in double precision on blocks of aluminium on the wall, periodic along x and y and grown along these,
/// 50 cells high (the smallest 20). A periodic block without a cavity: nothing but the size differs between the rows.
/// Each row takes steps in turn with a reference, the block of 640,000 particles at 8 per cell on one thread, so that
/// rows of different minutes can be compared: `relative` is their ratio. What does not fit into the memory is skipped.
#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

#include "scene.hpp"
#include "timing.hpp"

namespace {

using namespace mote;

/// A block of width x width x height cells, per_axis^3 particles in each.
struct Block {
  int width, height = 50, per_axis = 2;
  double particles() const { return double(width) * width * height * per_axis * per_axis * per_axis; }
};

template <class Executor>
auto solver_of(const Block& block, const Executor& executor) {
  const double w = block.width * bench::um, h = block.height * bench::um;
  const auto make = [&] {
    return Solver{grid::Cartesian<3>{.spacing = bench::um},
                  shape::QuadraticBSpline{},
                  transfer::Apic{},
                  timestep::Cfl{.courant = 0.4},
                  executor,
                  boundary::Periodic{.axis = axis::x, .from = 0, .to = w},
                  boundary::Periodic{.axis = axis::y, .from = 0, .to = w},
                  boundary::RigidWall{.side = side::z_min, .at = 0},
                  bench::aluminium()};
  };
  auto solver = std::unique_ptr<decltype(make())>(new auto(make()));
  solver->fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {w, w, h}}, bench::aluminium(),
               {.per_axis = block.per_axis, .velocity = {0, 0, 100}});
  return solver;
}

/// Bytes that the system would lend; without limit where it does not say.
double available_bytes() {
  std::ifstream file("/proc/meminfo");
  std::string key, unit;
  for (double kilobytes; file >> key >> kilobytes; std::getline(file, unit))
    if (key == "MemAvailable:") return 1024 * kilobytes;
  return 1e30;
}

void row(benchmark::State& state, const Block& block, int threads) {
  const double particles = block.particles();
  if (available_bytes() < 450 * particles + 1e9) return state.SkipWithError("not enough memory");
  auto reference = solver_of({.width = 40}, bench::pinned_threads(1));
  auto solver = solver_of(block, bench::pinned_threads(threads));
  reference->step(), solver->step();
  const int steps = std::max(1, int(1.3e6 / particles));  // a turn of both takes about as long
  bench::Turns turns(threads > 1 ? bench::wall_time : bench::own_time);
  for (auto _ : state) {
    turns([&] { reference->step(), reference->step(); },
          [&] {
            for (int i = 0; i < steps; ++i) solver->step();
          });
    state.SetIterationTime(turns.last_second());
  }
  const double each_reference = 2.0 * double(reference->size()), each = steps * particles;
  state.counters["particles"] = double(solver->size());
  state.counters["per_cell"] = block.per_axis * block.per_axis * block.per_axis;
  state.counters["on_threads"] = threads;
  if (threads > 1) state.counters["share"] = turns.share();
  state.counters["ns"] = 1e9 * turns.second() / each;
  state.counters["reference_ns"] = 1e9 * turns.first() / each_reference;
  state.counters["relative"] = turns.ratio() * each_reference / each;
  state.counters["sort_ns"] = 1e9 * bench::seconds([&] { solver->refresh(); }) / particles;
}

void add(const std::string& name, const Block& block, int threads = 1) {
  benchmark::RegisterBenchmark(name.c_str(), row, block, threads)
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(7);
}

}  // namespace

int main(int argc, char** argv) {
  add("particles/1e4", {.width = 8, .height = 20});
  add("particles/1e5", {.width = 16});
  add("particles/1e6", {.width = 50});
  add("particles/1e7", {.width = 158});
  add("per_cell/1", {.width = 113, .per_axis = 1});
  add("per_cell/8", {.width = 40});
  add("per_cell/27", {.width = 22, .per_axis = 3});
  add("two_threads", {.width = 40}, 2);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
