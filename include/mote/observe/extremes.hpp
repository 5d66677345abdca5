/// \file
/// Extremes of velocity, pressure and temperature over the particles, and of velocity over the grid.
#pragma once

#include <mote/grid/blocks.hpp>
#include <mote/observe/schedule.hpp>

#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

namespace mote::observe {

/// The smallest and the largest of some numbers; nan if there are none.
struct Range {
  double min = detail::nan, max = detail::nan;

  Range& operator+=(const Range& b) {
    min = b.min < min || !(min == min) ? b.min : min;
    max = b.max > max || !(max == max) ? b.max : max;
    return *this;
  }
};

/// Extremes of one velocity component over the particles, m/s.
struct VelocityExtremes {
  double min = detail::nan, max = detail::nan;   ///< of single particles
  double low = detail::nan, high = detail::nan;  ///< mean over the slowest and the fastest part of the material
};

namespace detail {

/// What the speeds of a body are taken from, and the extremes of each 64 neighbouring particles.
template <class T>
struct SpeedColumns {
  static constexpr std::size_t group = 64;
  std::span<const T> v, mass, ratio;
  double rho0;
  std::vector<std::pair<T, T>> extremes;

  double volume(std::size_t p) const { return double(mass[p]) * double(ratio[p]) / rho0; }

  template <class Executor>
  void survey(const Executor& executor) {
    extremes.resize((v.size() + group - 1) / group);
    for_chunks(executor, v.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; i += group)
        extremes[i / group] = survey_group(i, std::min(last, i + group));
    });
  }

 private:
  std::pair<T, T> survey_group(std::size_t first, std::size_t last) const {
    Pack<T> lo(v[first]), hi = lo;
    for (; first + lanes <= last; first += lanes) {
      const auto here = read<Pack<T>>(v.data() + first);
      lo = min(lo, here);
      hi = max(hi, here);
    }
    T least = -largest(Pack<T>(-lo)), most = largest(hi);
    for (; first < last; ++first) {
      least = std::min(least, v[first]);
      most = std::max(most, v[first]);
    }
    return {least, most};
  }
};

/// Mean of sign * v over the `volume` of material where it is smallest; the last particle counts in part.
///
/// Groups of particles are taken in the order of their smallest value, until those smallest alone fill the volume. What
/// is smaller than the last of them lies in the groups taken; at most that last value fills what is left.
template <class T>
double mean_of_smallest(const std::vector<SpeedColumns<T>>& bodies, double sign, double volume) {
  struct Group {
    double least;
    std::uint32_t body, number;
  };
  const auto later = [](const Group& a, const Group& b) {
    return std::tie(a.least, a.body, a.number) > std::tie(b.least, b.body, b.number);
  };
  std::vector<Group> heap;
  for (std::uint32_t b = 0; b < bodies.size(); ++b)
    for (std::uint32_t g = 0; g < bodies[b].extremes.size(); ++g) {
      const auto& [lo, hi] = bodies[b].extremes[g];
      heap.push_back({sign > 0 ? double(lo) : -double(hi), b, g});
    }
  std::make_heap(heap.begin(), heap.end(), later);

  std::vector<std::pair<double, double>> taken;  // value, volume
  double certain = 0, bound = std::numeric_limits<double>::infinity();
  for (auto end = heap.end(); end != heap.begin() && certain < volume;) {
    std::pop_heap(heap.begin(), end, later);
    const Group group = *--end;
    const auto& body = bodies[group.body];
    const std::size_t first = group.number * body.group, last = std::min(body.v.size(), first + body.group);
    bool counted = false;
    for (std::size_t p = first; p < last; ++p) {
      taken.emplace_back(sign * double(body.v[p]), body.volume(p));
      if (!counted && taken.back().first == group.least) certain += taken.back().second, counted = true;
    }
    if (certain >= volume) bound = group.least;
  }
  std::erase_if(taken, [&](const auto& p) { return p.first > bound; });
  std::sort(taken.begin(), taken.end());
  double sum = 0, filled = 0;
  for (const auto& [value, size] : taken) {
    const double part = std::min(size, volume - filled);
    sum += part * value;
    filled += part;
    if (filled >= volume) break;
  }
  return filled > 0 ? sum / filled : nan;
}

}  // namespace detail

/// Extremes of velocity component `axis` over all particles.
///
/// `low` is the mean velocity of the slowest `volume` (m^D) of material, `high` of the fastest: particles in the order
/// of their velocity, weighted with their current volume J m/rho0, until the volume is full; the last counts in part.
template <class Solver>
VelocityExtremes velocity_extremes(const Solver& solver, int axis, double volume) {
  using T = typename Solver::number;
  require(volume > 0, "low and high average over a volume of ", volume, "; it must be > 0");
  std::vector<detail::SpeedColumns<T>> bodies;
  solver.for_each_body([&](const auto& material, const auto& particles) {
    bodies.push_back({particles.template column<field::Velocity>(axis),
                      particles.template column<field::Mass>(),
                      particles.template column<field::VolumeRatio>(),
                      material.rho0(),
                      {}});
    bodies.back().survey(solver.executor());
  });
  Range all;
  for (const auto& body : bodies)
    for (const auto& [lo, hi] : body.extremes) all += Range{double(lo), double(hi)};
  return {all.min, all.max, detail::mean_of_smallest(bodies, 1, volume), -detail::mean_of_smallest(bodies, -1, volume)};
}

namespace detail {

/// A range that packs are added to.
template <class T>
struct PackRange {
  Pack<T> min{std::numeric_limits<T>::infinity()}, max{-std::numeric_limits<T>::infinity()};

  void add(const Pack<T>& x) { *this += PackRange{x, x}; }
  PackRange& operator+=(const PackRange& b) {
    min = mote::min(min, b.min), max = mote::max(max, b.max);
    return *this;
  }
  Range range() const {
    const Range r{double(-largest(Pack<T>(-min))), double(largest(max))};
    return r.min <= r.max ? r : Range{};
  }
};

/// Adds the temperatures of a pack, if it has any.
template <class T, class V>
void add_temperature(PackRange<T>& range, const V& values) {
  if constexpr (carries<V, field::Temperature>) range.add(get<field::Temperature>(values));
}

/// The smallest density at rest of a body that has particles, kg/m^3.
template <class Solver>
double lightest(const Solver& solver) {
  double rho0 = std::numeric_limits<double>::infinity();
  solver.for_each_body([&](const auto& material, const auto& particles) {
    if (particles.size() > 0) rho0 = std::min(rho0, material.rho0());
  });
  return rho0;
}

/// f(range, material, values) adds what it wants of the particles' states, in packs.
template <class Solver, class F>
Range range_over_particles(const Solver& solver, const F& f) {
  using T = typename Solver::number;
  const auto add = [&](PackRange<T>& range, const auto& material, const auto& particles, std::size_t i, int n) {
    f(range, material, load_state<T>(material, particles, i, n));
  };
  return sum_by_chunk<PackRange<T>>(solver, add).range();
}

}  // namespace detail

/// Extremes of the pressure over all particles, Pa.
template <class Solver>
Range pressure_range(const Solver& solver) {
  return detail::range_over_particles(
      solver, [](auto& range, const auto& m, const auto& values) { range.add(m.pressure(values)); });
}

/// Extremes of the temperature over the particles of the bodies that have one, K; nan if none has.
template <class Solver>
Range temperature_range(const Solver& solver) {
  return detail::range_over_particles(
      solver, [](auto& range, const auto&, const auto& values) { detail::add_temperature(range, values); });
}

/// Extremes of velocity component `axis` over the nodes that carry at least a tenth of a full node's mass (rho0 h^D of
/// the lightest material that has particles; half as much on a plane, a quarter where two meet), m/s. Nodes beyond
/// planes, which mirror those inside, do not count. Nodes of what sleeps carry its velocity.
///
/// The node fields are those of the last step: nan before the first one.
template <class Solver>
Range grid_velocity_range(const Solver& solver, int axis) {
  constexpr int D = Solver::dimension;
  constexpr std::size_t blocks_at_once = 32;
  const auto& nodes = solver.nodes();
  const double full = detail::lightest(solver) * std::pow(solver.spacing(), D);
  const auto least_mass = [&](const IVec<D>& node) {
    double least = 0.1 * full;
    for (int a = 0; a < D; ++a)
      for (int end = 0; end < 2; ++end)
        if (const auto& plane = solver.domain().plane(a, end)) {
          const std::int32_t depth = end ? plane->node - node[a] : node[a] - plane->node;
          if (depth < 0) return std::numeric_limits<double>::infinity();
          if (depth == 0) least /= 2;
        }
    return least;
  };
  std::vector<Range> parts((nodes.index.size() + blocks_at_once - 1) / blocks_at_once);
  if (solver.steps() == 0 || nodes.mass.size() < nodes.nodes()) return {};
  solver.executor().for_each(parts.size(), [&](std::size_t c) {
    const std::size_t first = c * blocks_at_once * grid::block_nodes<D>;
    const std::size_t last = std::min(nodes.nodes(), first + blocks_at_once * grid::block_nodes<D>);
    Range part;
    for (std::size_t i = first; i < last; ++i) {
      if (!(nodes.mass[i] >= 0.1 * full / (1 << D)) || nodes.mass[i] < least_mass(nodes.coordinates(i))) continue;
      const double v = double(nodes.velocity[i * grid::node_width<D> + std::size_t(axis)]);
      part += Range{v, v};
    }
    parts[c] = part;
  });
  Range all;
  for (const Range& part : parts) all += part;
  solver.for_each_sleeping_tile([&](const auto& v) { all += Range{double(v[axis]), double(v[axis])}; });
  return all;
}

}  // namespace mote::observe
