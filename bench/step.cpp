/// \file
/// What does a step cost per particle, beside a fair textbook loop on the same scene in the same run?
///
/// Both take steps in turn, one thread each, so that a drift of the machine's speed hits both; counters are medians
/// over the rounds. The textbook loop has a dense grid, a structure of arrays and the order of the fill, which is good
/// for it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "scene.hpp"

namespace {

using Clock = std::chrono::steady_clock;

template <class F>
double seconds(F&& f) {
  const auto start = Clock::now();
  f();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
  return v[v.size() / 2];
}

template <class Loop, class Shape, class Transfer, class Update>
void beside_textbook(benchmark::State& state, Shape shape, Transfer transfer, Update update) {
  const bench::Scene scene;
  auto solver = scene.library<double>(shape, transfer, update, mote::execution::Serial{});
  auto loop = scene.textbook<Loop>();
  const double dt = solver->step();  // the first step sorts, and touches the memory
  loop.step(dt);
  std::vector<double> ours, theirs;
  constexpr int steps = 5;
  for (auto _ : state) {
    ours.push_back(seconds([&] {
                     for (int i = 0; i < steps; ++i) solver->step(dt);
                   }) /
                   steps);
    theirs.push_back(seconds([&] {
                       for (int i = 0; i < steps; ++i) loop.step(dt);
                     }) /
                     steps);
    state.SetIterationTime(ours.back());
  }
  const double n = 1e9 / double(solver->size());
  state.counters["mote_ns"] = n * median(ours);
  state.counters["textbook_ns"] = n * median(theirs);
  state.counters["ratio"] = median(theirs) / median(ours);
  state.counters["particles"] = double(solver->size());
}

using mote::shape::Linear;
using mote::shape::QuadraticBSpline;
using mote::transfer::Apic;
using mote::transfer::Flip;
using mote::update::Musl;
using mote::update::Usl;
template <textbook::Shape S, textbook::Transfer X, textbook::Update U>
using Loop = textbook::Loop<S, X, U>;
constexpr auto linear = textbook::Shape::linear, quadratic = textbook::Shape::quadratic;
constexpr auto flip = textbook::Transfer::flip, apic = textbook::Transfer::apic;
constexpr auto usl = textbook::Update::usl, musl = textbook::Update::musl;

void linear_flip_musl(benchmark::State& s) { beside_textbook<Loop<linear, flip, musl>>(s, Linear{}, Flip{}, Musl{}); }
void linear_flip_usl(benchmark::State& s) { beside_textbook<Loop<linear, flip, usl>>(s, Linear{}, Flip{}, Usl{}); }
void quadratic_apic_usl(benchmark::State& s) {
  beside_textbook<Loop<quadratic, apic, usl>>(s, QuadraticBSpline{}, Apic{}, Usl{});
}
void quadratic_flip_usl(benchmark::State& s) {
  beside_textbook<Loop<quadratic, flip, usl>>(s, QuadraticBSpline{}, Flip{}, Usl{});
}

template <class Shape, class Transfer, class Update>
void threads(benchmark::State& state, Shape shape, Transfer transfer, Update update) {
  const bench::Scene scene;
  auto one = scene.library<double>(shape, transfer, update, mote::execution::Threads(1));
  auto two = scene.library<double>(shape, transfer, update, mote::execution::Threads(2));
  one->step(), two->step();
  std::vector<double> t1, t2;
  constexpr int steps = 5;
  for (auto _ : state) {
    t1.push_back(seconds([&] {
                   for (int i = 0; i < steps; ++i) one->step();
                 }) /
                 steps);
    t2.push_back(seconds([&] {
                   for (int i = 0; i < steps; ++i) two->step();
                 }) /
                 steps);
    state.SetIterationTime(t2.back());
  }
  state.counters["one_thread_ns"] = 1e9 * median(t1) / double(one->size());
  state.counters["speed_up"] = median(t1) / median(t2);
}

void two_threads_quadratic_apic(benchmark::State& s) { threads(s, QuadraticBSpline{}, Apic{}, Usl{}); }
void two_threads_linear_flip_musl(benchmark::State& s) { threads(s, Linear{}, Flip{}, Musl{}); }

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const char* name, void (*f)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, f)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
  };
  add("linear_flip_musl", linear_flip_musl);
  add("linear_flip_usl", linear_flip_usl);
  add("quadratic_apic_usl", quadratic_apic_usl);
  add("quadratic_flip_usl", quadratic_flip_usl);
  add("two_threads/quadratic_apic", two_threads_quadratic_apic);
  add("two_threads/linear_flip_musl", two_threads_linear_flip_musl);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
