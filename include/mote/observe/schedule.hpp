/// \file
/// What observers share: when they look (Schedule), and how they scan particles (sum_by_chunk).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <mote/core/error.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>

namespace mote::observe {

/// The times start + i * interval, exact multiples without drift, from the start of a run to its end, both included.
class Schedule {
 public:
  /// No times at all.
  Schedule() = default;

  /// Times `every` s apart; infinity gives the first and the last. Throws InputError.
  static Schedule periodic(double every, double start, double until) {
    require(every > 0, "an observer looks every ", every, " s; it must be > 0");
    return {every, start, until};
  }
  /// `count` times evenly apart; 1 gives the start alone, 0 none. Throws InputError.
  static Schedule counted(int count, double start, double until) {
    require(count >= 0, "an observer is to write ", count, " frames; it must be >= 0");
    if (count == 0) return {};
    if (count == 1) return {0, start, start};
    return {(until - start) / (count - 1), start, until};
  }
  /// `frames` of them if given, or else `every`.
  static Schedule of(double every, const std::optional<int>& frames, double start, double until) {
    return frames ? counted(*frames, start, until) : periodic(every, start, until);
  }

  /// The next time, s; infinity after the last.
  double due() const { return due_; }
  bool wants(double time) const { return time >= due_; }
  /// Whether a run that ends here, perhaps early, still has to be looked at.
  bool wants_end(double time) const { return due_ < none && time > last_; }
  /// Moves on to the first time after `time`, which was looked at.
  void done(double time) {
    last_ = time;
    while (due_ <= time) {
      const double next = start_ + double(++i_) * interval_;
      const bool beyond = !(next < until_ - 1e-9 * interval_);  // also where interval_ is infinite
      due_ = !beyond ? next : (due_ < until_ && time < until_ ? until_ : none);
    }
  }

 private:
  Schedule(double interval, double start, double until)
      : start_(start), interval_(interval), until_(until), due_(start) {}

  static constexpr double none = std::numeric_limits<double>::infinity();
  double start_ = 0, interval_ = 0, until_ = 0, due_ = none, last_ = -none;
  std::size_t i_ = 0;
};

namespace detail {

/// Particles per chunk of a scan: fixed, so that sums do not depend on the number of threads.
inline constexpr std::size_t chunk = 4096;

inline std::size_t chunks(std::size_t particles) { return (particles + chunk - 1) / chunk; }

/// Calls f(first, last) for each chunk of n particles.
template <class Executor, class F>
void for_chunks(const Executor& executor, std::size_t n, const F& f) {
  executor.for_each(chunks(n), [&](std::size_t c) { f(c * chunk, std::min(n, (c + 1) * chunk)); });
}

/// Sum (+=) over all particles of all bodies, in fixed order: f(part, material, particles, first, n) adds a pack of the
/// n <= lanes particles from `first` on.
template <class Part, class Solver, class F>
Part sum_by_chunk(const Solver& solver, const F& f) {
  Part sum{};
  std::vector<Part> parts;
  solver.for_each_body([&](const auto& material, const auto& particles) {
    parts.assign(chunks(particles.size()), Part{});
    for_chunks(solver.executor(), particles.size(), [&](std::size_t first, std::size_t last) {
      Part part{};
      for (std::size_t i = first; i < last; i += lanes) f(part, material, particles, i, std::min(lanes, int(last - i)));
      parts[first / chunk] = part;
    });
    for (const Part& part : parts) sum += part;
  });
  return sum;
}

/// The list of fields of a set of particles.
template <class Particles>
using list_of = typename std::remove_cvref_t<Particles>::list;

template <class Particles, class Tag>
inline constexpr bool has_field = contains<list_of<Particles>, Tag>;

/// The fields that a material reads, and More, of n <= lanes particles from `first` on, in packs.
template <class T, class... More, class Material, class Particles>
auto load_state(const Material&, const Particles& particles, std::size_t first, int n) {
  Values<Pack<T>, Particles::dimension, union_of<fields<More...>, particle_fields_of<Material>>> values;
  particles.load(first, n, values);
  return values;
}

/// The number of axis `axis`, counted from the last one if negative. Throws InputError.
inline int resolved_axis(int axis, int dimension) {
  const int a = axis < 0 ? dimension + axis : axis;
  require(a >= 0 && a < dimension, "an observer names axis ", axis, "; the grid has axes 0 to ", dimension - 1);
  return a;
}

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace detail
}  // namespace mote::observe
