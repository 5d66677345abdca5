/// \file
/// The clock of the benchmarks, their medians, and threads that stay on their cores.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <vector>

#include <mote/execution/threads.hpp>
#if defined(__linux__)
#include <sched.h>
#endif

namespace bench {

/// Seconds on the wall, for what more than one thread does.
inline double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds that the calling thread has run: the turns of other programs on its core do not count. Where the system does
/// not tell, those on the wall.
inline double own_time() {
#if defined(CLOCK_THREAD_CPUTIME_ID)
  timespec t{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t) == 0) return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
#endif
  return wall_time();
}

/// How long f takes.
template <class F>
double seconds(F&& f, double (*now)() = own_time) {
  const double start = now();
  f();
  return now() - start;
}

inline double median(std::vector<double> v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + std::ptrdiff_t(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

/// Seconds of each of two things, done in turns so that a drift of the machine's speed hits both.
class Turns {
  std::vector<double> a_, b_, shares_;
  double (*now_)();

 public:
  explicit Turns(double (*now)() = own_time) : now_(now) {}

  template <class A, class B>
  void operator()(A&& a, B&& b) {
    const double wall = wall_time(), own = own_time();
    a_.push_back(seconds(a, now_));
    b_.push_back(seconds(b, now_));
    shares_.push_back((own_time() - own) / (wall_time() - wall));
  }
  double first() const { return median(a_); }
  double second() const { return median(b_); }
  double last_second() const { return b_.back(); }
  /// The median over rounds of second / first: rounds that a neighbour has disturbed drop out.
  double ratio() const {
    std::vector<double> r;
    for (std::size_t i = 0; i < a_.size(); ++i) r.push_back(b_[i] / a_[i]);
    return median(r);
  }
  /// The part of the time on the wall in which this thread ran: well below one, others were at work on this core, and
  /// times on the wall are worth nothing.
  double share() const { return median(shares_); }
};

/// Keeps the calling thread, and the threads that it will start, on cores first, ..., last; does nothing where the
/// system does not offer that or has no such core.
inline void keep_on_cores([[maybe_unused]] int first, [[maybe_unused]] int last) {
#if defined(__linux__)
  cpu_set_t cores;
  CPU_ZERO(&cores);
  for (int c = first; c <= last; ++c) CPU_SET(c, &cores);
  sched_setaffinity(0, sizeof cores, &cores);  // a refusal changes nothing but the noise
#endif
}

/// n threads: the caller's on core 0, the others, which inherit where they may run, on the rest.
inline mote::execution::Threads pinned_threads(int n) {
  if (n > 1) keep_on_cores(1, n - 1);
  mote::execution::Threads threads(n);
  keep_on_cores(0, 0);
  return threads;
}

}  // namespace bench
