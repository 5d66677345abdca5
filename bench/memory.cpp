/// \file
/// How many bytes of memory does a particle take, all in all?
///
/// Quadratic APIC in double precision, the paper's scene: the largest resident size of the process less that before
/// anything was built, per particle, after the fill and after steps and sorts. The bar is 300 bytes; the columns alone
/// take Solver::bytes_per_particle. Counts on being the only benchmark of its process.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "scene.hpp"
#include "timing.hpp"

namespace {

/// Bytes, since the process began.
double peak() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);  // Linux counts in KiB
}

void bytes_per_particle(benchmark::State& state) {
  bench::keep_on_cores(0, 0);
  const double before = peak();
  double filled = 0, stepped = 0;
  for (auto _ : state) {
    auto solver = bench::Scene{}.library<double>(mote::shape::QuadraticBSpline{}, mote::transfer::Apic{},
                                                 mote::update::Usl{}, mote::execution::Serial{});
    const auto n = double(solver->size());
    filled = (peak() - before) / n;
    for (int i = 0; i < 5; ++i) solver->step();
    solver->refresh();
    for (int i = 0; i < 5; ++i) solver->step();
    stepped = (peak() - before) / n;
    state.counters["particles"] = n;
    state.counters["column_bytes"] = std::remove_reference_t<decltype(*solver)>::bytes_per_particle<0>;
  }
  state.counters["peak_after_fill"] = filled;
  state.counters["peak_after_steps"] = stepped;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("quadratic/apic", bytes_per_particle)->Iterations(1)->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
