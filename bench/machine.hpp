/// \file
/// What this machine can do at most: multiply-adds per second on one core, and bytes per second of an in-place update
/// of many columns on one core and on two. Measured in the same run as what they are compared with.
#pragma once

#include <mote/core/aligned.hpp>
#include <mote/core/pack.hpp>
#include <mote/passes/stencil.hpp>

#include "timing.hpp"

namespace bench {

struct Machine {
  double flops_double, flops_float;     ///< 1/s, one core; a multiply-add is two operations
  double bandwidth_one, bandwidth_two;  ///< bytes/s, reads and writes

  template <class T>
  double flops() const {
    return sizeof(T) == 8 ? flops_double : flops_float;
  }
};

namespace detail {

/// The fastest of some rounds: a limit is what the machine does when nobody disturbs it.
inline double fastest(const std::vector<double>& times) { return *std::min_element(times.begin(), times.end()); }

/// Independent chains of multiply-adds on full vectors: enough to hide the latency (4 cycles, 2 a cycle), few enough to
/// stay in 16 registers; unrolled by hand, or g++ keeps them in memory. \return something that depends on all of them
template <class T, int chains, int width>
[[gnu::noinline]] T multiply_add(int repeats, T a, T b) {
  using mote::passes::unrolled;
  using V = typename mote::Simd<T, width>::V;
  const V va = a - V{}, vb = b - V{};
  V x[chains];
  unrolled<chains>([&](auto c) __attribute__((always_inline)) { x[c] = T(c) - V{}; });
  for (int i = 0; i < repeats; ++i)
    unrolled<chains>([&](auto c) __attribute__((always_inline)) { x[c] = va * x[c] + vb; });
  for (int c = 1; c < chains; ++c) x[0] += x[c];
  return x[0][0];
}

/// Operations per second.
template <class T>
double measure_flops() {
  constexpr int width = mote::detail::vector_bytes / int(sizeof(T)), chains = 12, repeats = 1'000'000;
  std::vector<double> times;
  volatile T a = T(0.5), wanted = 0;
  for (int round = 0; round < 15; ++round)
    times.push_back(seconds([&] { wanted = multiply_add<T, chains, width>(repeats, a, T(0.25)); }));
  return 2.0 * width * chains * repeats / fastest(times);
}

/// x <- a x + b on 26 columns (those of quadratic APIC) of 600,000 numbers, pack by pack, each read once and written
/// once. \return bytes per second
inline double measure_bandwidth(int threads) {
  constexpr std::size_t columns = 26, numbers = 600'000, chunk = 2000;
  using V = mote::Pack<double>;
  const auto executor = pinned_threads(threads);
  std::vector<mote::StaggeredVector<double>> column;
  for (std::size_t c = 0; c < columns; ++c)
    column.emplace_back(numbers, 1.0, mote::detail::StaggeredAllocator<double>(int(c)));
  std::vector<double> times;
  for (int round = 0; round < 15; ++round)
    times.push_back(seconds(
        [&] {
          executor.for_each(numbers / chunk, [&](std::size_t k) {
            for (std::size_t i = k * chunk; i < (k + 1) * chunk; i += mote::lanes)
              for (auto& data : column) mote::write(V(0.5) * mote::read<V>(data.data() + i) + V(0.5), data.data() + i);
          });
        },
        wall_time));
  return 2.0 * sizeof(double) * columns * numbers / fastest(times);
}

}  // namespace detail

inline Machine measure_machine() {
  keep_on_cores(0, 0);
  return {detail::measure_flops<double>(), detail::measure_flops<float>(), detail::measure_bandwidth(1),
          detail::measure_bandwidth(2)};
}

/// This machine, measured at the first call.
inline const Machine& machine() {
  static const Machine measured = measure_machine();
  return measured;
}

}  // namespace bench
