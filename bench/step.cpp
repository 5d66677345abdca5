/// \file
/// What does a step cost per particle, beside a fair textbook loop on the same scene in the same run? What do two
/// threads and single precision save?
///
/// The two things compared take steps in turn, so that a drift of the machine's speed hits both; counters are medians
/// over the rounds, ratios medians of the rounds' ratios. Threads stay on their cores. The textbook loop has a dense
/// grid, a structure of arrays and the order of the fill, which is good for it.
#include <benchmark/benchmark.h>

#include "scene.hpp"
#include "timing.hpp"

namespace {

constexpr int steps = 5;  // per turn

template <class Loop, class Shape, class Transfer, class Update>
void beside_textbook(benchmark::State& state, Shape shape, Transfer transfer, Update update) {
  bench::keep_on_cores(0, 0);
  const bench::Scene scene;
  auto solver = scene.library<double>(shape, transfer, update, mote::execution::Serial{});
  auto loop = scene.textbook<Loop>();
  const double dt = solver->step();  // the first step sorts, and touches the memory
  loop.step(dt);
  bench::Turns turns;
  for (auto _ : state) {
    turns(
        [&] {
          for (int i = 0; i < steps; ++i) solver->step(dt);
        },
        [&] {
          for (int i = 0; i < steps; ++i) loop.step(dt);
        });
    state.SetIterationTime(turns.last_second());
  }
  const double n = 1e9 / steps / double(solver->size());
  state.counters["mote_ns"] = n * turns.first();
  state.counters["textbook_ns"] = n * turns.second();
  state.counters["ratio"] = turns.ratio();
  state.counters["particles"] = double(solver->size());
}

using mote::shape::CubicBSpline;
using mote::shape::Linear;
using mote::shape::QuadraticBSpline;
using mote::transfer::AffineFlip;
using mote::transfer::Apic;
using mote::transfer::Flip;
using mote::update::Musl;
using mote::update::Usl;
template <textbook::Shape S, textbook::Transfer X, textbook::Update U>
using Loop = textbook::Loop<S, X, U>;
constexpr auto linear = textbook::Shape::linear, quadratic = textbook::Shape::quadratic, cubic = textbook::Shape::cubic;
constexpr auto flip = textbook::Transfer::flip, apic = textbook::Transfer::apic,
               affine_flip = textbook::Transfer::affine_flip;
constexpr auto usl = textbook::Update::usl, musl = textbook::Update::musl;

void linear_flip_musl(benchmark::State& s) { beside_textbook<Loop<linear, flip, musl>>(s, Linear{}, Flip{}, Musl{}); }
void linear_flip_usl(benchmark::State& s) { beside_textbook<Loop<linear, flip, usl>>(s, Linear{}, Flip{}, Usl{}); }
void quadratic_apic_usl(benchmark::State& s) {
  beside_textbook<Loop<quadratic, apic, usl>>(s, QuadraticBSpline{}, Apic{}, Usl{});
}
void quadratic_affine_flip_usl(benchmark::State& s) {
  beside_textbook<Loop<quadratic, affine_flip, usl>>(s, QuadraticBSpline{}, AffineFlip{}, Usl{});
}
void quadratic_flip_usl(benchmark::State& s) {
  beside_textbook<Loop<quadratic, flip, usl>>(s, QuadraticBSpline{}, Flip{}, Usl{});
}
void cubic_apic_usl(benchmark::State& s) { beside_textbook<Loop<cubic, apic, usl>>(s, CubicBSpline{}, Apic{}, Usl{}); }

/// Two solvers of the library in turns.
template <class A, class B>
void beside_each_other(benchmark::State& state, A& one, B& two, double (*clock)()) {
  one.step(), two.step();
  bench::Turns turns(clock);
  for (auto _ : state) {
    turns(
        [&] {
          for (int i = 0; i < steps; ++i) one.step();
        },
        [&] {
          for (int i = 0; i < steps; ++i) two.step();
        });
    state.SetIterationTime(turns.last_second());
  }
  const double n = 1e9 / steps / double(one.size());
  state.counters["first_ns"] = n * turns.first();
  state.counters["second_ns"] = n * turns.second();
  state.counters["gain"] = 1 / turns.ratio();
  if (clock == bench::wall_time) state.counters["share"] = turns.share();
}

template <class Shape, class Transfer, class Update>
void threads(benchmark::State& state, Shape shape, Transfer transfer, Update update) {
  const bench::Scene scene;
  auto one = scene.library<double>(shape, transfer, update, bench::pinned_threads(1));
  auto two = scene.library<double>(shape, transfer, update, bench::pinned_threads(2));
  beside_each_other(state, *one, *two, bench::wall_time);
}

void two_threads_quadratic_apic(benchmark::State& s) { threads(s, QuadraticBSpline{}, Apic{}, Usl{}); }
void two_threads_linear_flip_musl(benchmark::State& s) { threads(s, Linear{}, Flip{}, Musl{}); }

/// What the default transfer of the cavity costs beside APIC.
void affine_flip_for_apic(benchmark::State& state) {
  bench::keep_on_cores(0, 0);
  const bench::Scene scene;
  auto one = scene.library<double>(QuadraticBSpline{}, Apic{}, Usl{}, mote::execution::Serial{});
  auto two = scene.library<double>(QuadraticBSpline{}, AffineFlip{}, Usl{}, mote::execution::Serial{});
  beside_each_other(state, *one, *two, bench::own_time);
}

void float_quadratic_apic(benchmark::State& state) {
  bench::keep_on_cores(0, 0);
  const bench::Scene scene;
  auto full = scene.library<double>(QuadraticBSpline{}, Apic{}, Usl{}, mote::execution::Serial{});
  auto half = scene.library<float>(QuadraticBSpline{}, Apic{}, Usl{}, mote::execution::Serial{});
  beside_each_other(state, *full, *half, bench::own_time);
}

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const char* name, void (*f)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, f)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
  };
  add("textbook/linear/flip/musl", linear_flip_musl);
  add("textbook/linear/flip/usl", linear_flip_usl);
  add("textbook/quadratic/flip/usl", quadratic_flip_usl);
  add("textbook/quadratic/apic/usl", quadratic_apic_usl);
  add("textbook/quadratic/aflip/usl", quadratic_affine_flip_usl);
  add("textbook/cubic/apic/usl", cubic_apic_usl);
  add("two_threads/quadratic/apic/usl", two_threads_quadratic_apic);
  add("two_threads/linear/flip/musl", two_threads_linear_flip_musl);
  add("aflip/quadratic/usl", affine_flip_for_apic);
  add("float/quadratic/apic/usl", float_quadratic_apic);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
