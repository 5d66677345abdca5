/// \file
/// The grid's own part of a step: sum what the tiles brought, solve for velocities, hold them to the boundaries.
#pragma once

#include <limits>
#include <tuple>

#include <mote/load/concept.hpp>
#include <mote/passes/images.hpp>
#include <mote/passes/scatter.hpp>

namespace mote::passes {

/// Energies and impulses of one step that only the grid knows; sums over nodes.
template <int D>
struct GridLedger {
  double work = 0;         ///< by internal forces and loads, J: what the kinetic energy of the constrained grid gains
  double load_work = 0;    ///< by loads alone, J
  double wall_loss = 0;    ///< kinetic energy taken at once by planes that the incoming momentum does not obey, J
  double piston_work = 0;  ///< by planes that move, J
  std::array<Vec<double, D>, 2 * D> impulse{};  ///< that boundary parts gave the body, N s, by number of the part

  GridLedger& operator+=(const GridLedger& b) {
    work += b.work, load_work += b.load_work, wall_loss += b.wall_loss;
    piston_work += b.piston_work;
    for (std::size_t i = 0; i < impulse.size(); ++i) impulse[i] += b.impulse[i];
    return *this;
  }
};

/// Rows of a block's nodes along the last axis, a bit each.
using Rows = std::uint32_t;
template <int D>
inline constexpr int rows_of_block = grid::block_nodes<D> / grid::block_edge;

/// Sums the records of all tiles that reach a block, in the order of tiles.
/// \return the rows that any reaches; the sums of the others are not set. A block beyond a plane has few.
template <int width, class T, int D>
Rows sum_tiles(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support, T* sums) {
  using Record = Simd<T, width>;
  Rows touched = 0;
  for (std::uint32_t k = tiling.block_links_begin[block]; k < tiling.block_links_begin[block + 1]; ++k) {
    const Link<D>& link = tiling.links[tiling.block_links[k]];
    const Tile<D>& tile = tiling.tiles[link.tile];
    const T* from = accumulators + tile.buffer * width;
    for_each_row(
        link, NodeBox<D>(tile, support), [&](int in_box, int in_block, auto count) __attribute__((always_inline)) {
          const int row = in_block / grid::block_edge;
          if (!(touched >> row & 1)) {
            std::fill_n(sums + row * grid::block_edge * width, grid::block_edge * width, T(0));
            touched |= Rows(1) << row;
          }
          unrolled<count>([&](auto i) __attribute__((always_inline)) {
            T* to = sums + (in_block + i) * width;
            write(Record(read<Record>(to) + read<Record>(from + std::ptrdiff_t(in_box + i) * width)), to);
          });
        });
  }
  return touched;
}

/// Calls f(i) for the nodes of a block in the rows that are touched, in order, and g(first) for each row that is not.
template <int D, class F, class G>
void for_each_node(Rows touched, const F& f, const G& g) {
  for (int row = 0; row < rows_of_block<D>; ++row) {
    const int first = row * grid::block_edge;
    if (touched >> row & 1)
      for (int i = first; i < first + grid::block_edge; ++i) f(i);
    else
      g(first);
  }
}

/// Zero on a row of nodes.
template <int D, class T>
void clear_row(AlignedVector<T>& field, std::size_t first) {
  constexpr std::size_t half = grid::node_width<D>;
  std::fill_n(field.data() + first * half, grid::block_edge * half, T(0));
}

/// A node's mass, or none if it is so small that its inverse would overflow.
template <class T>
T solid(T mass) {
  return mass >= std::numeric_limits<T>::min() ? mass : T(0);
}

/// dt times the acceleration by all loads on the volume at a node.
template <class T, int D, class Loads>
Vec<T, D> load_gain(const IVec<D>& node, const Frame<T, D>& frame, const Loads& loads, double time, double dt) {
  Vec<double, D> x{}, b{};
  for (int a = 0; a < D; ++a) x[a] = frame.node_position(a, node[a]);
  const auto add = [&](const auto& load) {
    if constexpr (LoadIn<std::remove_cvref_t<decltype(load)>, D>) b += load.acceleration(x, time);
  };
  std::apply([&](const auto&... load) { (add(load), ...); }, loads);
  return cast<T>(b * dt);
}

/// v_old = p/m and v = v_old + dt (f/m + b) on a block's nodes, before any plane.
template <class T, int D, class Loads>
[[gnu::noinline]] GridLedger<D> accelerate_block(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators,
                                                 int support, grid::Blocks<T, D>& blocks, const Frame<T, D>& frame,
                                                 const Loads& loads, double time, double dt) {
  constexpr int width = MomentumAndForce<T, D>::width, nodes = grid::block_nodes<D>;
  alignas(64) T sums[nodes * width];
  GridLedger<D> ledger;
  const std::size_t first = std::size_t(block) * nodes;
  const auto update = [&](int i) {
    const T* record = sums + i * width;
    const std::size_t node = first + std::size_t(i);
    const T m = solid(record[2 * D]), over_m = m > T(0) ? T(1) / m : T(0);
    blocks.mass[node] = m;
    Vec<T, D> old{}, gain{};
    for (int a = 0; a < D; ++a) {
      old[a] = over_m * record[2 * a];
      gain[a] = T(dt) * (over_m * record[2 * a + 1]);
    }
    if constexpr (any_body_load<Loads, D>) {
      if (m > T(0)) {
        const Vec<T, D> pushed = load_gain<T, D>(blocks.coordinates(node), frame, loads, time, dt);
        ledger.load_work += double(m * dot(pushed, old + T(0.5) * (gain + pushed)));
        gain += pushed;
      }
    }
    ledger.work += double(m * dot(gain, old + T(0.5) * gain));
    set_node_vector(blocks.previous.data(), node, old);
    set_node_vector(blocks.velocity.data(), node, old + gain);
  };
  for_each_node<D>(sum_tiles<width>(block, tiling, accumulators, support, sums), update, [&](int row) {
    std::fill_n(blocks.mass.data() + first + std::size_t(row), grid::block_edge, T(0));
    clear_row<D>(blocks.velocity, first + std::size_t(row));
    clear_row<D>(blocks.previous, first + std::size_t(row));
  });
  return ledger;
}

/// Holds the velocities of the nodes of a block near planes, and of those that they bind, to the planes; books impulses
/// and losses.
///
/// The field becomes the nearest that the planes allow (Images::project), the Galerkin reduction to such fields with
/// lumped masses: at a mirror a virtual body shares its momentum with the real one, node by node, v = (p + S p')/(m +
/// m'). The velocity before the forces is that of the whole body at a symmetry plane, and as the particles brought it
/// at a wall, so that FLIP feels the wall.
///
/// Where planes move, all of this is meant beside their velocity u: held, old and losses here are. The kinetic energy
/// of someone at rest differs from that by u p + m u^2/2, so that a change of momentum dp brings u dp more.
/// \param kept the part of its own velocity that a particle keeps (Transfer)
template <class T, int D>
[[gnu::noinline]] GridLedger<D> hold_to_planes(std::size_t plane_block, const Orbits<D>& orbits,
                                               grid::Blocks<T, D>& blocks, double kept,
                                               const Vec<double, D>& frame_velocity) {
  GridLedger<D> ledger;
  Images<D> images;
  images.frame_velocity = frame_velocity;
  const Vec<T, D> u = cast<T>(frame_velocity);
  const auto energy = [](T mass, const Vec<T, D>& v) { return 0.5 * double(mass * dot(v, v)); };
  Vec<T, D> held[Images<D>::most], old[Images<D>::most], whole[Images<D>::most];
  for (const Orbit<D>& orbit : orbits.of_block(plane_block)) {
    images.take(orbits, orbit, blocks.mass);
    if (!images.bound()) continue;
    images.project(blocks, blocks.velocity, held);
    images.project(blocks, blocks.previous, old);
    for (int k = 0; k < images.count; ++k) whole[k] = images.symmetric_mean(blocks, blocks.previous, k);
    for (int k = 0; k < images.count; ++k) {
      const std::size_t node = images.image[std::size_t(k)].node;
      const T m = blocks.mass[node];
      const Vec<T, D> raw = node_vector<T, D>(blocks.velocity.data(), node),
                      before = node_vector<T, D>(blocks.previous.data(), node);
      const Vec<T, D> push = m * (u + held[k] - raw - T(kept) * (u + whole[k] - before));
      for (int c = 0; c < D; ++c)
        if (images.holds(c)) {
          ledger.impulse[images.holder(c)][c] += double(push[c]);
          ledger.piston_work += double(push[c]) * frame_velocity[c];
        }
      ledger.wall_loss += energy(m, whole[k]) - energy(m, old[k]);
      ledger.work += energy(m, held[k]) - energy(m, old[k]) - energy(m, raw) + energy(m, before) +
                     double(m * dot(u, held[k] - whole[k]));
      set_node_vector(blocks.velocity.data(), node, u + held[k]);
      set_node_vector(blocks.previous.data(), node, u + whole[k]);
    }
  }
  return ledger;
}

/// The mass and the velocity field of the incoming momentum, before any plane.
template <class T, int D>
[[gnu::noinline]] void divide_block(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support,
                                    grid::Blocks<T, D>& blocks) {
  constexpr int width = Momentum<T, D>::width, nodes = grid::block_nodes<D>;
  alignas(64) T sums[nodes * width];
  const std::size_t first = std::size_t(block) * nodes;
  const auto divide = [&](int i) {
    const std::size_t node = first + std::size_t(i);
    const T m = solid(sums[i * width + D]), over_m = m > T(0) ? T(1) / m : T(0);
    blocks.mass[node] = m;
    Vec<T, D> v{};
    for (int a = 0; a < D; ++a) v[a] = over_m * sums[i * width + a];
    set_node_vector(blocks.velocity.data(), node, v);
  };
  for_each_node<D>(sum_tiles<width>(block, tiling, accumulators, support, sums), divide, [&](int row) {
    std::fill_n(blocks.mass.data() + first + std::size_t(row), grid::block_edge, T(0));
    clear_row<D>(blocks.velocity, first + std::size_t(row));
  });
}

/// The velocity field that the particles' new momenta make, before any plane.
template <class T, int D>
[[gnu::noinline]] void remap_block(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support,
                                   grid::Blocks<T, D>& blocks) {
  constexpr int width = Momentum<T, D>::width, nodes = grid::block_nodes<D>;
  alignas(64) T sums[nodes * width];
  const std::size_t first = std::size_t(block) * nodes;
  const auto divide = [&](int i) {
    const std::size_t node = first + std::size_t(i);
    const T m = blocks.mass[node], over_m = m > T(0) ? T(1) / m : T(0);
    Vec<T, D> v{};
    for (int a = 0; a < D; ++a) v[a] = over_m * sums[i * width + a];
    set_node_vector(blocks.remapped.data(), node, v);
  };
  for_each_node<D>(sum_tiles<width>(block, tiling, accumulators, support, sums), divide,
                   [&](int row) { clear_row<D>(blocks.remapped, first + std::size_t(row)); });
}

/// Holds a velocity field to the planes. \return the impulses that this takes, of velocities that the particles get
template <class T, int D>
[[gnu::noinline]] GridLedger<D> hold_field(std::size_t plane_block, const Orbits<D>& orbits, AlignedVector<T>& field,
                                           const grid::Blocks<T, D>& blocks, const Vec<double, D>& frame_velocity) {
  GridLedger<D> ledger;
  Images<D> images;
  images.frame_velocity = frame_velocity;
  Vec<T, D> allowed[Images<D>::most];
  for (const Orbit<D>& orbit : orbits.of_block(plane_block)) {
    images.take(orbits, orbit, blocks.mass);
    if (!images.bound()) continue;
    images.project(blocks, field, allowed);
    for (int k = 0; k < images.count; ++k) {
      const std::size_t node = images.image[std::size_t(k)].node;
      const Vec<T, D> held = cast<T>(frame_velocity) + allowed[k],
                      push = blocks.mass[node] * (held - node_vector<T, D>(field.data(), node));
      for (int c = 0; c < D; ++c)
        if (images.holds(c)) ledger.impulse[images.holder(c)][c] += double(push[c]);
      set_node_vector(field.data(), node, held);
    }
  }
  return ledger;
}

}  // namespace mote::passes
