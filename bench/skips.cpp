/// \file
/// What does it save to leave out what is not needed?
///
///   quarter   a symmetric quarter of the body instead of all of it, a whole run of the paper's scene (at best 4 x)
///   empty     eight times the room around a body that floats between planes (at best the same cost)
///   parts     heat, hardening and yield, strength left out of the material, beside the full one
///   sleep     measured with the sleep policy: its row belongs into main() below
///
/// One thread, quadratic APIC, double precision; both sides take steps in turn.
#include <benchmark/benchmark.h>

#include "scene.hpp"
#include "timing.hpp"

namespace {

using namespace mote;
using bench::um;

template <class Material, class... Boundaries>
auto solver_of(const Material& material, const Boundaries&... boundaries) {
  const auto make = [&] {
    return Solver{grid::Cartesian<3>{.spacing = um},
                  shape::QuadraticBSpline{},
                  transfer::Apic{},
                  timestep::Cfl{.courant = 0.4},
                  execution::Serial{},
                  boundaries...,
                  material};
  };
  return std::unique_ptr<decltype(make())>(new auto(make()));
}

// ---- quarter

auto quarter_of(const bench::Scene& scene) {
  using boundary::Symmetry;
  const double w = scene.half_width * um;
  auto solver = solver_of(bench::aluminium(), Symmetry{.side = side::x_min, .at = 0},
                          Symmetry{.side = side::x_max, .at = w}, Symmetry{.side = side::y_min, .at = 0},
                          Symmetry{.side = side::y_max, .at = w}, boundary::RigidWall{.side = side::z_min, .at = 0});
  solver->fill(scene.region(), bench::aluminium(), {.per_axis = 2, .velocity = {0, 0, scene.speed}});
  return solver;
}

/// The whole run of 15 ns, half a nanosecond of each in turn; all that the solver does counts, sorts too. The saving is
/// the median over these turns.
void quarter(benchmark::State& state) {
  bench::keep_on_cores(0, 0);
  const bench::Scene scene;
  auto full = scene.library<double>(shape::QuadraticBSpline{}, transfer::Apic{}, update::Usl{}, execution::Serial{});
  auto part = quarter_of(scene);
  const auto advance = [](auto& solver, double until) {
    return bench::seconds([&] {
      while (solver.time() < until * (1 - 1e-12)) solver.step(until - solver.time());
    });
  };
  double t_full = 0, t_part = 0;
  std::vector<double> savings;
  for (auto _ : state)
    for (int i = 1; i <= 30; ++i) {
      const double f = advance(*full, i * 0.5e-9), p = advance(*part, i * 0.5e-9);
      t_full += f, t_part += p;
      savings.push_back(f / p);
    }
  const auto ns = [](double t, const auto& s) { return 1e9 * t / double(s.steps()) / double(s.size()); };
  state.counters["full_s"] = t_full;
  state.counters["quarter_s"] = t_part;
  state.counters["saving"] = bench::median(savings);
  state.counters["full_ns"] = ns(t_full, *full);
  state.counters["quarter_ns"] = ns(t_part, *part);
  state.counters["steps"] = double(full->steps());
  state.counters["sorts"] = double(full->sorts());
}

// ---- empty space

/// A body of 40 x 40 x 50 cells in the middle of a box of planes that is `scale` times as wide as the narrow one, whose
/// planes are so far away that no block of nodes meets them.
auto floating(int scale) {
  using boundary::Symmetry;
  const double w = 32 * um * scale, h = 40 * um * scale;
  auto solver =
      solver_of(bench::aluminium(), Symmetry{.side = side::x_min, .at = -w}, Symmetry{.side = side::x_max, .at = w},
                Symmetry{.side = side::y_min, .at = -w}, Symmetry{.side = side::y_max, .at = w},
                Symmetry{.side = side::z_min, .at = -h}, Symmetry{.side = side::z_max, .at = h});
  const double a = 20 * um, b = 25 * um;
  solver->fill(geometry::Box<3>{.lower = {-a, -a, -b}, .upper = {a, a, b}}, bench::aluminium(),
               {.per_axis = 2, .velocity = [](const auto& x) {
                  return Vec<double, 3>{0, 0, 4e6 * x[2]};
                }});
  return solver;
}

/// Steps of solvers with and without something in turn; counters per particle. There are two of each, built and
/// called in either order: of two equal solvers the later one is faster by some 2%.
template <class MakeFull, class MakeWithout>
void in_turns(benchmark::State& state, const MakeFull& make_full, const MakeWithout& make_without) {
  bench::keep_on_cores(0, 0);
  const auto full = make_full();
  const auto without = make_without(), without_too = make_without();
  const auto full_too = make_full();
  const auto steps = [](auto& solver) {
    return [&solver] {
      for (int i = 0; i < 4; ++i) solver->step();
    };
  };
  steps(full)(), steps(without)(), steps(without_too)(), steps(full_too)();
  bench::Turns one, other;
  for (auto _ : state) {
    one(steps(full), steps(without));
    other(steps(without_too), steps(full_too));
    state.SetIterationTime(one.last_second());
  }
  const double n = 1e9 / 4 / double(full->size());
  state.counters["full_ns"] = n * 0.5 * (one.first() + other.second());
  state.counters["without_ns"] = n * 0.5 * (one.second() + other.first());
  state.counters["saving"] = std::sqrt(other.ratio() / one.ratio());
  state.counters["full_bytes"] = std::remove_cvref_t<decltype(*full)>::template bytes_per_particle<0>;
  state.counters["without_bytes"] = std::remove_cvref_t<decltype(*without)>::template bytes_per_particle<0>;
}

void empty(benchmark::State& state) {
  in_turns(
      state, [] { return floating(1); }, [] { return floating(2); });
}

// ---- parts of the material

template <class Material>
auto filled(const Material& material) {
  const bench::Scene scene;
  const double w = scene.half_width * um;
  auto solver = solver_of(material, boundary::Periodic{.axis = axis::x, .from = -w, .to = w},
                          boundary::Periodic{.axis = axis::y, .from = -w, .to = w},
                          boundary::RigidWall{.side = side::z_min, .at = 0});
  solver->fill(scene.region(), material, {.per_axis = 2, .velocity = {0, 0, scene.speed}});
  return solver;
}

template <class Material>
void parts(benchmark::State& state, const Material& material) {
  in_turns(
      state, [] { return filled(bench::aluminium()); }, [&] { return filled(material); });
}

/// A control: how far from 1 is the ratio of equals?
void nothing(benchmark::State& state) { parts(state, bench::aluminium()); }
void no_heat(benchmark::State& state) { parts(state, Material{bench::aluminium().eos, bench::aluminium().strength}); }
void elastic(benchmark::State& state) {
  parts(state, Material{bench::aluminium().eos, strength::Elastic{.shear_modulus = 69e9 / 2.66}});
}
void no_strength(benchmark::State& state) { parts(state, Material{bench::aluminium().eos}); }

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const char* name, void (*f)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, f)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(7);
  };
  benchmark::RegisterBenchmark("quarter", quarter)->Unit(benchmark::kMillisecond)->Iterations(1);
  add("empty", empty);
  add("parts/nothing", nothing);
  add("parts/no_heat", no_heat);
  add("parts/no_heat_no_yield", elastic);
  add("parts/no_strength", no_strength);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
