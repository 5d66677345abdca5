/// \file
/// Progress: one line about how far a run has come.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include <mote/core/error.hpp>

namespace mote::observe {

/// What a progress line says.
struct ProgressState {
  double begun, time, until;  ///< simulated time at the start, now and at the end, s
  std::size_t steps;          ///< done in this run
  double nanoseconds;         ///< per particle and step: wall time of the steps x threads / (particles x steps)
  double left;                ///< wall time still to go at the pace so far, s; negative if unknown
};

/// "42.0%  5.040 of 12.000 ns  step 81  61.3 ns per particle and step  1:05 left"; the last part only if known.
inline std::string progress_line(const ProgressState& p) {
  char line[160];
  const double part = p.until > p.begun ? (p.time - p.begun) / (p.until - p.begun) : 1;
  const int n = std::snprintf(line, sizeof line, "%5.1f%%  %.3f of %.3f ns  step %zu  %.1f ns per particle and step",
                              100 * part, 1e9 * p.time, 1e9 * p.until, p.steps, p.nanoseconds);
  std::string out(line, std::size_t(n));
  if (p.left >= 0 && p.left < 1e8) {
    const long s = long(p.left + 0.5);
    if (s >= 3600)
      std::snprintf(line, sizeof line, "  %ld:%02ld:%02ld left", s / 3600, s / 60 % 60, s % 60);
    else
      std::snprintf(line, sizeof line, "  %ld:%02ld left", s / 60, s % 60);
    out += line;
  }
  return out;
}

/// Hands a progress_line() to `sink` at most every `seconds` of wall time, and at the end. The library prints nothing
/// itself; `[](std::string line) { std::cerr << '\r' << line; }` shows it.
struct Progress {
  std::function<void(std::string)> sink = {};
  double seconds = 0.5;  ///< wall time between lines
  static constexpr bool only_when_due = true;

  template <class Solver, class Run>
  void begin(const Solver& solver, const Run& run) {
    require(bool(sink), "a progress observer has no sink to hand its lines to");
    state_ = {solver.time(), solver.time(), run.until, 0, 0, -1};
    first_step_ = solver.steps();
    first_seconds_ = solver.seconds();
    started_ = last_ = std::chrono::steady_clock::now();
  }
  double due() const { return std::numeric_limits<double>::infinity(); }
  template <class Solver>
  void observe(const Solver& solver) {
    const auto now = std::chrono::steady_clock::now();
    if (std::chrono::duration<double>(now - last_).count() < seconds) return;
    last_ = now;
    tell(solver);
  }
  template <class Solver>
  void end(const Solver& solver) {
    tell(solver);
  }

  template <class Solver>
  void tell(const Solver& solver) {
    state_.time = solver.time();
    state_.steps = solver.steps() - first_step_;
    const double work = double(solver.size()) * double(state_.steps);
    const double threads = solver.executor().concurrency();
    state_.nanoseconds = work > 0 ? 1e9 * (solver.seconds() - first_seconds_) * threads / work : 0;
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    const double done = state_.time - state_.begun;
    state_.left = done > 0 ? wall * (state_.until - state_.time) / done : -1;
    sink(progress_line(state_));
  }

  // What it remembers; not to be set.
  ProgressState state_ = {};
  std::size_t first_step_ = 0;
  double first_seconds_ = 0;
  std::chrono::steady_clock::time_point started_ = {}, last_ = {};
};

}  // namespace mote::observe
