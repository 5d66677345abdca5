/// \file
/// What is asked of the accuracy benchmark, the clock of its runs, and its rows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mote/core/error.hpp>
#include <string>
#include <vector>

#include "timing.hpp"

namespace accuracy {

/// What to run: of each kind of words (problems, shape functions, transfers, updates) those that were named, or all.
struct Wanted {
  std::vector<std::string> words = {};
  double finest = 0;  ///< no meshes of the cavity finer than this, um

  bool operator()(const std::string& problem, const std::string& shape, const std::string& transfer,
                  const std::string& update) const {
    const std::string scheme[] = {problem, shape, transfer, update};
    for (std::size_t k = 0; k < 4; ++k)
      if (std::any_of(kinds()[k].begin(), kinds()[k].end(), [&](const auto& w) { return has(w); }) && !has(scheme[k]))
        return false;
    return true;
  }
  static bool known(const std::string& word) {
    return std::any_of(kinds().begin(), kinds().end(),
                       [&](const auto& kind) { return std::find(kind.begin(), kind.end(), word) != kind.end(); });
  }

 private:
  bool has(const std::string& word) const { return std::find(words.begin(), words.end(), word) != words.end(); }
  static const std::vector<std::vector<std::string>>& kinds() {
    static const std::vector<std::vector<std::string>> all{
        {"bar", "vortex", "wave_100", "wave_400", "wave_-500", "cavity_100", "cavity_400"},
        {"linear", "quadratic", "cubic", "cpgimp"},
        {"flip", "flip0.99", "apic", "aflip", "xpic", "fmpm"},
        {"usl", "musl", "usf"}};
    return all;
  }
};

/// Counts the calling thread's own time in steps, less what it takes to ask for it.
class StepClock {
  double seconds_ = 0;

  static double cost_of_asking() {
    static const double cost = [] {
      constexpr int times = 2000;
      const double start = bench::own_time();
      for (int i = 0; i < times; ++i) bench::own_time();
      return (bench::own_time() - start) / times;
    }();
    return cost;
  }

 public:
  template <class F>
  void operator()(F&& f) {
    seconds_ += std::max(0.0, bench::seconds(f) - cost_of_asking());
  }
  double seconds() const { return seconds_; }
};

/// One run. An error that is not a number: the run ended with mote::NumericalError.
struct Row {
  std::string problem = {}, scheme = {};
  double h = 0;  ///< in the unit of the problem
  int per_axis = 0;
  std::size_t particles = 0, steps = 0;
  double seconds = 0, error = std::numeric_limits<double>::quiet_NaN();

  static void header() { std::puts("problem,scheme,h,per_axis,particles,steps,seconds,ns_per_particle_step,error"); }
  void print() const {
    const double updates = double(particles) * double(std::max<std::size_t>(1, steps));
    std::printf("%s,%s,%g,%d,%zu,%zu,%.4g,%.4g,%.5g\n", problem.c_str(), scheme.c_str(), h, per_axis, particles, steps,
                seconds, 1e9 * seconds / updates, error);
    std::fflush(stdout);
  }
};

/// Steps a solver until `end`, and has it looked at after `looks` parts of the way. \return false if it failed
template <class Solver, class Before, class Look>
bool march(Solver& solver, double end, int looks, StepClock& clock, const Before& before, const Look& look) {
  try {
    int seen = 0;
    while (solver.time() < end * (1 - 1e-9)) {
      before(solver.time());
      clock([&] { solver.step(); });
      if (solver.time() * looks < end * (seen + 1) * (1 - 1e-9)) continue;
      look(solver.time());
      seen = int(solver.time() * looks / end * (1 + 1e-9));
    }
    return true;
  } catch (const mote::NumericalError&) {
    return false;
  }
}

}  // namespace accuracy
