// mote inside a program of yours: your time loop, your threads, your hands on the columns, a material without a solver.
#include <algorithm>
#include <cstdio>
#include <future>
#include <mote/mote.hpp>
#include <vector>

/// An executor is a copyable type with this role and two members. The answer does not depend on it, to the last bit.
struct Tasks {
  using role = mote::role::Execution;
  int count;

  int concurrency() const { return count; }
  /// Calls f(0) ... f(n - 1) in any order on any thread, returns when all are done, and passes on what an f threw.
  template <class F>
  void for_each(std::size_t n, const F& f) const {
    std::vector<std::future<void>> tasks;
    for (std::size_t t = 0; t < std::size_t(count); ++t)
      tasks.push_back(std::async(std::launch::async, [this, &f, n, t] {
        for (std::size_t i = t; i < n; i += std::size_t(count)) f(i);
      }));
    for (auto& task : tasks) task.get();
  }
};

int main() {
  using namespace mote;
  const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                           strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6}};

  // A material needs no solver: its state is a value that you keep where you like.
  auto state = aluminium.initial<double>();
  Mat<double, 3> increment{};  // of the displacement gradient: row i is a component, column j a derivative
  increment(2, 2) = 1e-4;
  for (int i = 0; i < 100; ++i) aluminium.update(state, increment);
  std::printf("1%% of uniaxial strain: %.1f MPa along z, %.1f MPa across\n", 1e-6 * aluminium.stress(state)(2, 2),
              1e-6 * aluminium.stress(state)(0, 0));

  // A plate flies at 200 m/s and is stopped on its lower side.
  Solver solver{grid::Cartesian<2>{.spacing = 1e-6}, shape::QuadraticBSpline{}, transfer::Apic{}, timestep::Cfl{},
                Tasks{2}, boundary::RigidWall{.side = side::y_min}, aluminium};
  solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {60e-6, 20e-6}}, aluminium, {.velocity = {0, -200}});

  // Columns are spans, one per component; writing them asks for a refresh() before the next step.
  auto& particles = solver.particles();
  const auto x = particles.column<field::Position>(0), vy = particles.column<field::Velocity>(1);
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (x[p] > 30e-6) vy[p] *= 2;  // the right half is twice as fast
  solver.refresh();

  for (double report = 0; solver.time() < 4e-9;) {
    solver.step(4e-9 - solver.time());  // never beyond 4 ns
    if (solver.time() < report) continue;
    report += 1e-9;
    // between sorts particle p keeps its place; field::Id names it for good
    std::printf("%.2f ns, step %zu: v_y in [%.1f, %.1f] m/s\n", 1e9 * solver.time(), solver.steps(),
                std::ranges::min(vy), std::ranges::max(vy));
  }
}
