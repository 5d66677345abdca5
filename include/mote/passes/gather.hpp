/// \file
/// Grid to particles.
#pragma once

#include <cmath>
#include <limits>

#include <mote/passes/scatter.hpp>

namespace mote::passes {

/// What a gather does: take the velocity, move and strain, or both from one field.
enum class Task { velocity_and_deform, velocity_and_remap, deform };

/// Copies the grid's velocities to the tile's box; records by task:
///
///   velocity (both)    [v | v - v before the forces] for increments, [v | v] for affine transfers
///   deform             [v mapped back from the particles | v]
template <Task task, class Transfer, class T, int D>
void copy_nodes(const Tile<D>& tile, const std::vector<Link<D>>& links, const grid::Blocks<T, D>& blocks,
                const NodeBox<D>& box, T* nodes) {
  constexpr int half = grid::node_width<D>;
  using Half = Simd<T, half>;
  for (std::uint32_t k = tile.links_begin; k < tile.links_end; ++k) {
    const std::size_t block = std::size_t(links[k].block) * grid::block_nodes<D>;
    for_each_row(links[k], box, [&](int in_box, int in_block, int count) {
      for (int i = 0; i < count; ++i) {
        const std::size_t from = (block + std::size_t(in_block + i)) * half;
        T* to = nodes + std::ptrdiff_t(in_box + i) * 2 * half;
        const Half v = read<Half>(blocks.velocity.data() + from);
        if constexpr (task == Task::deform) {
          write(read<Half>(blocks.remapped.data() + from), to);
          write(v, to + half);
        } else {
          write(v, to);
          if constexpr (Transfer::increment)
            write(Half(v - read<Half>(blocks.previous.data() + from)), to + half);
          else
            write(v, to + half);
        }
      }
    });
  }
}

/// What the lanes of a pack gather, component by component.
template <Task task, class Shape, class Transfer, class T, int D>
struct PackSums {
  static constexpr int half = grid::node_width<D>, width = 2 * half;
  static constexpr bool axes = task != Task::velocity_and_remap || Transfer::affine;
  Pack<T> value[width];
  Pack<T> axis[D][width];

  PackSums(const T* nodes, const NodeBox<D>& box, const Stencil<T, D, Shape>& stencil, int n) {
    constexpr auto halves = Transfer::affine && task != Task::deform ? Halves::slope_moment : Halves::slope_slope;
    alignas(64) T values[lanes][width];
    alignas(64) T along[D][lanes][width];
    for (int l = 0; l < lanes; ++l) {
      const auto sum = gather<axes, halves>(nodes, box, stencil, std::min(l, n - 1));
      write(sum.value, values[l]);
      if constexpr (axes)
        for (int a = 0; a < D; ++a) write(sum.axis[a], along[a][l]);
    }
    from_records(values, value);
    if constexpr (axes)
      for (int a = 0; a < D; ++a) from_records(along[a], axis[a]);
  }

  GridVelocity<Pack<T>, D> velocity(double spacing) const {
    GridVelocity<Pack<T>, D> g;
    for (int i = 0; i < D; ++i) {
      g.pic[i] = value[task == Task::deform ? half + i : i];
      if constexpr (Transfer::increment && task != Task::deform) g.increment[i] = value[half + i];
    }
    if constexpr (Transfer::affine && task != Task::deform) {
      // the gradient stands in where the kernel's inertia is singular
      constexpr bool singular = Shape::inertia == 0;
      const T scale = T(1 / (singular ? spacing : Shape::inertia * spacing));
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < D; ++a) g.affine(i, a) = scale * axis[a][singular ? i : half + i];
    }
    return g;
  }

  /// dt times the velocity gradient.
  Mat<Pack<T>, D> increment(double dt_over_h) const {
    Mat<Pack<T>, D> l;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) l(i, a) = T(dt_over_h) * axis[a][i];
    return l;
  }
};

/// Lowest nodes that occur in a tile. Surplus lanes repeat a particle, so all count.
template <int D>
class Range {
  using Nodes = Simd<int, lanes>;
  Nodes lo_[D], hi_[D];

 public:
  Range() {
    std::fill_n(lo_, D, Nodes(127));
    std::fill_n(hi_, D, Nodes(-128));
  }
  template <class Stencil>
  void include(const Stencil& stencil) {
    for (int a = 0; a < D; ++a) {
      const Nodes nodes = read<Nodes>(stencil.relative[a]);
      lo_[a] = min(lo_[a], nodes);
      hi_[a] = max(hi_[a], nodes);
    }
  }
  void put(Tile<D>& tile) const {
    for (int a = 0; a < D; ++a) {
      int least = 127;
      for (std::size_t l = 0; l < lanes; ++l) least = std::min(least, lo_[a][l]);
      tile.lo[std::size_t(a)] = std::int8_t(std::max(least, -128));
      tile.hi[std::size_t(a)] = std::int8_t(std::min(largest(hi_[a]), 127));
    }
  }
};

/// Collects a tile's report, lane by lane; what is wrong is only looked for if something is.
template <class T>
class Reporter {
  Pack<T> speed_ = T(0), wrong_ = T(0);

 public:
  template <class B, class V>
  void include(const B& body, const V& p) {
    using std::sqrt;
    const Pack<T> speed = sqrt(body.material.sound_speed2(p)) + norm(get<field::Velocity>(p));
    speed_ = max(speed_, speed);
    const Pack<T> one = T(1);
    wrong_ = select(speed < Pack<T>(std::numeric_limits<T>::infinity()), wrong_, one);
    wrong_ = select(body.material.admissible(p), wrong_, one);
  }

  template <class B, int D>
  TileReport of(const B& body, const Tile<D>& tile) const {
    TileReport report{double(largest(speed_))};
    for (std::uint32_t i = tile.first; largest(wrong_) > 0 && i < tile.first + tile.count; ++i) {
      Values<T, D, union_of<fields<field::Velocity>, particle_fields_of<typename B::Material>>> p;
      body.particles.load(i, p);
      if (std::isfinite(norm(get<field::Velocity>(p))) && std::isfinite(body.material.sound_speed2(p)) &&
          body.material.sound_speed2(p) >= 0 && body.material.admissible(p))
        continue;
      report.failed = i;
      break;
    }
    return report;
  }
};

/// Velocity, position and state of a tile's particles from the grid; leaves the range of their new lowest nodes in the
/// tile. With Task::velocity_and_remap the new momentum goes back to the accumulators.
template <Task task, class Shape, class Transfer, class B, class T, int D>
[[gnu::flatten]] TileReport gather_tile(B& body, const Transfer& transfer, Tile<D>& tile,
                                        const std::vector<Link<D>>& links, const grid::Blocks<T, D>& blocks,
                                        const Frame<T, D>& frame, double dt, T* accumulators) {
  constexpr int width = 2 * grid::node_width<D>;
  constexpr bool moves = task != Task::velocity_and_remap, takes_velocity = task != Task::deform;
  const NodeBox<D> box(tile, Shape::support);
  alignas(64) T nodes[NodeBox<D>::capacity(Shape::support) * width];
  copy_nodes<task, Transfer>(tile, links, blocks, box, nodes);
  if constexpr (!moves) std::fill_n(accumulators + tile.buffer * width, box.size * width, T(0));
  Reporter<T> reporter;
  Range<D> range;
  using Deforms =
      std::conditional_t<moves, union_of<fields<field::Position>, particle_fields_of<typename B::Material>>, fields<>>;
  using Moves =
      std::conditional_t<takes_velocity, union_of<fields<field::Velocity>, particle_fields_of<Transfer>>, fields<>>;
  using Written = union_of<Deforms, Moves>;
  using Mass = std::conditional_t<moves, fields<>, fields<field::Mass>>;
  for_each_pack(tile, [&](std::size_t first, int n) {
    Values<Pack<T>, D, union_of<fields<field::Position, field::Velocity>, Mass, Written>> p;
    body.particles.load(first, n, p);
    Stencil<T, D, Shape> stencil;
    stencil.template set<true, Transfer::affine && takes_velocity>(frame.in_cells(get<field::Position>(p), tile.block),
                                                                   box);
    const PackSums<task, Shape, Transfer, T, D> sums(nodes, box, stencil, n);
    const auto grid_velocity = sums.velocity(frame.spacing);
    if constexpr (takes_velocity) transfer.update(p, grid_velocity);
    if constexpr (moves) {
      auto& x = get<field::Position>(p);
      x += grid_velocity.pic * Pack<T>(T(dt));
      body.material.update(p, embed(sums.increment(dt / frame.spacing)));
      reporter.include(body, p);
      stencil.locate(frame.in_cells(x, tile.block));
      range.include(stencil);
    } else {
      Pack<T> value[width], axis[D][width];
      momentum_records<Transfer, T, D>(p, frame.spacing, value, axis);
      scatter_pack<Transfer::affine, Transfer::affine ? Halves::moment_slope : Halves::slope_slope>(
          accumulators + tile.buffer * width, box, stencil, n, value, axis);
    }
    body.particles.store(first, n, p, Written{});
  });
  if constexpr (moves) range.put(tile);
  return reporter.of(body, tile);
}

/// Range of lowest nodes and the report of a tile as it stands, after a sort or when columns were written from outside.
template <class Shape, class B, class T, int D>
[[gnu::flatten]] TileReport survey_tile(const B& body, Tile<D>& tile, const Frame<T, D>& frame) {
  Reporter<T> reporter;
  Range<D> range;
  for_each_pack(tile, [&](std::size_t first, int n) {
    Values<Pack<T>, D, union_of<fields<field::Position, field::Velocity>, particle_fields_of<typename B::Material>>> p;
    body.particles.load(first, n, p);
    reporter.include(body, p);
    Stencil<T, D, Shape> stencil;
    stencil.locate(frame.in_cells(get<field::Position>(p), tile.block));
    range.include(stencil);
  });
  range.put(tile);
  return reporter.of(body, tile);
}

}  // namespace mote::passes
