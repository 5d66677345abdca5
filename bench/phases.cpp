/// \file
/// Where does a step's time go, and how far is each phase from what the machine could do?
///
/// One thread, the paper's scene: nanoseconds per particle of each phase and of the whole step for every kernel,
/// transfer, precision and update order, beside the counted operations and bytes (counts.hpp) and the roofline floor
/// that they set on this machine, which is measured in the same run. The floor of a step is the sum of its phases'
/// floors. Medians over eleven steps; sort_ns is one sort, which a run needs a few times only.
#include "phases.hpp"

namespace {

/// \param anew not what the floors of this run are made of, but once more: has the machine changed its speed?
void machine_limits(benchmark::State& state, bool anew) {
  bench::Machine m{};
  for (auto _ : state) m = anew ? bench::measure_machine() : bench::machine();
  state.counters["fma_double_gflops"] = 1e-9 * m.flops_double;
  state.counters["fma_float_gflops"] = 1e-9 * m.flops_float;
  state.counters["bandwidth_one_gbs"] = 1e-9 * m.bandwidth_one;
  state.counters["bandwidth_two_gbs"] = 1e-9 * m.bandwidth_two;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::RegisterBenchmark("machine/before", machine_limits, false)->Iterations(1)->Unit(benchmark::kMillisecond);
  bench::add_linear_flip();
  bench::add_linear_apic();
  bench::add_quadratic_flip();
  bench::add_quadratic_apic();
  bench::add_quadratic_aflip();
  bench::add_cubic_flip();
  bench::add_cubic_apic();
  benchmark::RegisterBenchmark("machine/after", machine_limits, true)->Iterations(1)->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
