/// \file
/// Grid to particles.
#pragma once

#include <cmath>
#include <limits>

#include <mote/passes/batch.hpp>
#include <mote/passes/scatter.hpp>

namespace mote::passes {

/// What a gather does: take the velocity, move, strain, or several of these from one field.
enum class Task { velocity_and_deform, velocity_and_remap, deform, strain, velocity_and_move };

constexpr bool takes_velocity(Task task) { return task != Task::deform && task != Task::strain; }
constexpr bool moves(Task task) { return task != Task::velocity_and_remap && task != Task::strain; }
constexpr bool strains(Task task) { return task != Task::velocity_and_remap && task != Task::velocity_and_move; }

/// The node fields that a task reads, copied to the tile's box; node_width<D> numbers per node.
template <class T, int D, class Shape>
struct NodeFields {
  static constexpr int half = grid::node_width<D>, capacity = NodeBox<D>::capacity(Shape::support) * half;
  alignas(64) T velocity[capacity];
  /// By task: the change of velocity by the forces or the sharpened velocity (if the transfer asks for it), or the
  /// velocity mapped back from the particles.
  alignas(64) T second[capacity];

  template <Task task, class Transfer>
  void copy(const Tile<D>& tile, const std::vector<Link<D>>& links, const grid::Blocks<T, D>& blocks,
            const NodeBox<D>& box) {
    for (std::uint32_t k = tile.links_begin; k < tile.links_end; ++k) {
      const std::size_t block = std::size_t(links[k].block) * grid::block_nodes<D>;
      for_each_row(
          links[k], box, [&](int in_box, int in_block, auto count) __attribute__((always_inline)) {
            const std::size_t from = (block + std::size_t(in_block)) * half;
            const std::ptrdiff_t to = std::ptrdiff_t(in_box) * half;
            unrolled<count>([&](auto n) __attribute__((always_inline)) {
              constexpr int i = n * half;
              using Half = Simd<T, half>;
              const Half v = read<Half>(blocks.velocity.data() + from + i);
              write(v, velocity + to + i);
              if constexpr (task == Task::deform)
                write(read<Half>(blocks.remapped.data() + from + i), second + to + i);
              else if constexpr (takes_velocity(task) && sharpens<Transfer> == Sharpens::incoming)
                write(read<Half>(blocks.sharp.data() + from + i), second + to + i);
              else if constexpr (takes_velocity(task) && Transfer::increment)
                write(Half(v - read<Half>(blocks.previous.data() + from + i)), second + to + i);
            });
          });
    }
  }
};

/// What a batch gathers for a task.
template <Task task, class Shape, class Transfer, class T, int D>
class BatchSums {
  static constexpr bool affine = Transfer::affine && takes_velocity(task);
  /// C is the gradient where the transfer says so, and where the kernel's inertia is singular.
  static constexpr bool gradient = Shape::inertia == 0 || detail::takes_gradient<Transfer>;
  static constexpr bool has_increment = Transfer::increment && takes_velocity(task),
                        has_sharp = sharpens<Transfer> == Sharpens::incoming && takes_velocity(task);
  static constexpr bool has_second = task == Task::deform || has_increment || has_sharp;
  static constexpr Wanted of_velocity{(strains(task) && task != Task::deform) || (affine && gradient),
                                      affine && !gradient};
  static constexpr Wanted of_second{task == Task::deform, false};
  SumColumns<of_velocity, T, D> velocity_;
  SumColumns<of_second, T, D> second_;

 public:
  /// \return the number of windows
  [[gnu::always_inline]] int gather(const NodeFields<T, D, Shape>& nodes, const NodeBox<D>& box,
                                    const BatchNodes<Shape, T, D>& at) {
    return at.for_each_window([&](int i, int node, const auto& stencil, unsigned bits,
                                  bool some) __attribute__((always_inline)) {
      const std::ptrdiff_t at_node = std::ptrdiff_t(node) * grid::node_width<D>;
      const auto put = [&](auto& to, int c, const Sums<T, D>& sums) __attribute__((always_inline)) {
        if (some)
          to.template put<true>(i, c, sums, bits);
        else
          to.template put<false>(i, c, sums, bits);
      };
      for (int c = 0; c < D; ++c)
        put(velocity_, c, passes::gather<of_velocity>(nodes.velocity + at_node, c, box, stencil));
      if constexpr (has_second)
        for (int c = 0; c < D; ++c) put(second_, c, passes::gather<of_second>(nodes.second + at_node, c, box, stencil));
    });
  }

  /// For the pack from particle p of the batch on.
  [[gnu::always_inline]] GridVelocity<Pack<T>, D> grid_velocity(int p, double spacing, double dt) const {
    GridVelocity<Pack<T>, D> g;
    g.dt = dt;
    for (int i = 0; i < D; ++i) {
      g.pic[i] = velocity_.value(p, i);
      if constexpr (has_increment) g.increment[i] = second_.value(p, i);
      if constexpr (has_sharp) g.sharp[i] = second_.value(p, i);
    }
    if constexpr (affine) {
      const T scale = T(1 / (gradient ? spacing : Shape::inertia * spacing));
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < D; ++a) {
          if constexpr (gradient)
            g.affine(i, a) = scale * velocity_.slope(p, i, a);
          else
            g.affine(i, a) = scale * velocity_.moment(p, i, a);
        }
    }
    return g;
  }

  /// dt times the velocity gradient.
  [[gnu::always_inline]] Mat<Pack<T>, D> increment(int p, double dt_over_h) const {
    Mat<Pack<T>, D> l;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        if constexpr (task == Task::deform)
          l(i, a) = T(dt_over_h) * second_.slope(p, i, a);
        else
          l(i, a) = T(dt_over_h) * velocity_.slope(p, i, a);
      }
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
  /// \param xi positions in cells, relative to the tile's block
  template <class Shape, class T>
  void include(const Vec<Pack<T>, D>& xi) {
    for (int a = 0; a < D; ++a) {
      int whole[lanes];
      to_integers(floor(Pack<T>(xi[a] - T(Shape::first))), whole);
      const Nodes nodes = read<Nodes>(whole);
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
  Pack<T> speed2_ = T(0), wrong_ = T(0);

 public:
  template <class M, class V>
  void include(const M& material, const V& p) {
    using std::sqrt;
    const Pack<T> c2 = material.signal_speed2(p), v2 = dot(get<field::Velocity>(p), get<field::Velocity>(p));
    const Pack<T> speed2 = c2 + v2 + T(2) * sqrt(c2 * v2), one = T(1);  // (c + |v|)^2, with one root
    speed2_ = max(speed2_, speed2);
    wrong_ = select(speed2 < Pack<T>(std::numeric_limits<T>::infinity()), wrong_, one);
    wrong_ = select(c2 >= Pack<T>(T(0)), wrong_, one);
    wrong_ = select(material.admissible(p), wrong_, one);
  }

  template <class B, int D>
  TileReport of(const B& body, const Tile<D>& tile) const {
    TileReport report{std::sqrt(double(largest(speed2_)))};
    for (std::uint32_t i = tile.first; largest(wrong_) > 0 && i < tile.first + tile.count; ++i) {
      Values<T, D, union_of<fields<field::Velocity>, particle_fields_of<typename B::Material>>> p;
      body.particles.load(i, p);
      if (std::isfinite(norm(get<field::Velocity>(p))) && std::isfinite(body.material.signal_speed2(p)) &&
          body.material.signal_speed2(p) >= 0 && body.material.admissible(p))
        continue;
      report.failed = i;
      break;
    }
    return report;
  }
};

/// Whether a kernel's size follows the motion; see shape/concept.hpp.
template <class Shape, class T, int D>
inline constexpr bool deforms = sized<Shape>&& requires(Values<Pack<T>, D, fields<field::HalfSize>> p,
                                                        Mat<Pack<T>, D> a) {
  Shape::deform(p, a);
};

/// Velocity, position and state of a tile's particles from the grid; leaves the range of their new lowest nodes in the
/// tile. With Task::velocity_and_remap the new momentum goes back to the accumulators.
template <Task task, class Shape, class Transfer, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] TileReport gather_tile(B& body, const Transfer& transfer_, Tile<D>& tile,
                                                       const std::vector<Link<D>>& links,
                                                       const grid::Blocks<T, D>& blocks, const Frame<T, D>& frame,
                                                       double dt, T* accumulators) {
  constexpr bool moves = passes::moves(task), takes_velocity = passes::takes_velocity(task),
                 strains = passes::strains(task);
  constexpr bool remaps = task == Task::velocity_and_remap;
  constexpr int remap_width = Momentum<T, D>::width;
  const NodeBox<D> box(tile, Shape::support);
  NodeFields<T, D, Shape> nodes;
  nodes.template copy<task, Transfer>(tile, links, blocks, box);
  T* remapped = accumulators + tile.buffer * remap_width;
  if constexpr (remaps) std::fill_n(remapped, box.size * remap_width, T(0));
  using History = particle_fields_of<typename B::Material>;
  using Size = std::conditional_t<deforms<Shape, T, D>, particle_fields_of<Shape>, fields<>>;
  using Deforms = union_of<std::conditional_t<moves, fields<field::Position>, fields<>>,
                           std::conditional_t<strains, union_of<Size, History>, fields<>>>;
  using Moves =
      std::conditional_t<takes_velocity, union_of<fields<field::Velocity>, particle_fields_of<Transfer>>, fields<>>;
  using Written = union_of<Deforms, Moves>;
  using Read = std::conditional_t<remaps, union_of<fields<field::Mass>, particle_fields_of<Shape>>, History>;
  // copies, which stores to columns cannot change: what depends on them alone is computed once
  const auto material = body.material;
  const auto transfer = transfer_;
  const TileFrame<T, D> in_tile = frame.of_block(tile.block);
  const double spacing = frame.spacing, dt_over_h = dt / frame.spacing;
  Reporter<T> reporter;
  Range<D> range;
  // A batch gathers, then the same particles move: the long chains of the material's divisions overlap.
  BatchNodes<Shape, T, D> at;
  BatchSums<task, Shape, Transfer, T, D> sums;
  int windows = 0;
  for_each_batch(tile, [&](std::size_t begin, int count) {
    at.clear();
    for (int i = 0; i < count; i += lanes) {
      Values<Pack<T>, D, union_of<fields<field::Position>, particle_fields_of<Shape>>> p;
      body.particles.load(begin + std::size_t(i), std::min(lanes, count - i), p);
      at.append(in_tile.in_cells(get<field::Position>(p)), box, half_sizes<Shape>(p, in_tile.per_spacing));
    }
    windows += sums.gather(nodes, box, at);
    for (int i = 0; i < count; i += lanes) {
      const std::size_t first = begin + std::size_t(i);
      const int n = std::min(lanes, count - i);
      Values<Pack<T>, D, union_of<fields<field::Position, field::Velocity>, Read, Written>> p;
      body.particles.load(first, n, p);
      const auto grid_velocity = sums.grid_velocity(i, spacing, dt);
      if constexpr (takes_velocity) transfer.update(p, grid_velocity);
      if constexpr (moves) get<field::Position>(p) += grid_velocity.pic * Pack<T>(T(dt));
      if constexpr (strains) {
        const Mat<Pack<T>, D> increment = sums.increment(i, dt_over_h);
        if constexpr (deforms<Shape, T, D>) Shape::deform(p, increment);
        material.update(p, embed(increment), {.dt = dt, .spacing = spacing});
      }
      if constexpr (moves) {
        reporter.include(material, p);
        range.template include<Shape>(in_tile.in_cells(get<field::Position>(p)));
      }
      if constexpr (remaps) {
        auto there = p;  // it is brought to the nodes around the old place, where the gradient is the one just taken
        if constexpr (detail::takes_gradient<Transfer>) get<field::Affine>(there) = grid_velocity.affine;
        Momentum<T, D> brought;
        brought.template add_momentum<Transfer>(there, spacing);
        scatter_pack<Shape, Transfer::affine ? AxisWeights::moment : AxisWeights::none>(
            remapped, box, in_tile.in_cells(get<field::Position>(p)), n, brought.value, brought.axis,
            half_sizes<Shape>(p, in_tile.per_spacing));
      }
      body.particles.store(first, n, p, Written{});
    }
  });
  if constexpr (moves) range.put(tile);
  TileReport report = reporter.of(body, tile);
  report.windows = std::uint32_t(windows);
  return report;
}

/// Range of lowest nodes and the report of a tile as it stands, after a sort, when columns were written from outside,
/// or when the grid has moved. \param frame_velocity that of the grid, m/s; speeds are reported beside it
template <class Shape, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] TileReport survey_tile(const B& body, Tile<D>& tile, const Frame<T, D>& frame,
                                                       const Vec<T, D>& frame_velocity) {
  const TileFrame<T, D> in_tile = frame.of_block(tile.block);
  Reporter<T> reporter;
  Range<D> range;
  for_each_pack(tile, [&](std::size_t first, int n) {
    Values<Pack<T>, D, union_of<fields<field::Position, field::Velocity>, particle_fields_of<typename B::Material>>> p;
    body.particles.load(first, n, p);
    for (int a = 0; a < D; ++a) get<field::Velocity>(p)[a] -= Pack<T>(frame_velocity[a]);
    reporter.include(body.material, p);
    range.template include<Shape>(in_tile.in_cells(get<field::Position>(p)));
  });
  range.put(tile);
  return reporter.of(body, tile);
}

}  // namespace mote::passes
