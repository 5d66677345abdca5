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

/// Sums the records of all tiles that reach a block, in the order of tiles.
/// \return whether any does
template <int width, class T, int D>
bool sum_tiles(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support, T* sums) {
  using Record = Simd<T, width>;
  std::fill_n(sums, grid::block_nodes<D> * width, T(0));
  bool touched = false;
  for (std::uint32_t k = tiling.block_links_begin[block]; k < tiling.block_links_begin[block + 1]; ++k) {
    const Link<D>& link = tiling.links[tiling.block_links[k]];
    const Tile<D>& tile = tiling.tiles[link.tile];
    const T* from = accumulators + tile.buffer * width;
    for_each_row(
        link, NodeBox<D>(tile, support), [&](int in_box, int in_block, auto count) __attribute__((always_inline)) {
          touched = true;
          unrolled<count>([&](auto i) __attribute__((always_inline)) {
            T* to = sums + (in_block + i) * width;
            write(Record(read<Record>(to) + read<Record>(from + std::ptrdiff_t(in_box + i) * width)), to);
          });
        });
  }
  return touched;
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
  constexpr int half = grid::node_width<D>, width = MomentumAndForce<T, D>::width, nodes = grid::block_nodes<D>;
  alignas(64) T sums[nodes * width];
  GridLedger<D> ledger;
  const std::size_t first = std::size_t(block) * nodes;
  if (!sum_tiles<width>(block, tiling, accumulators, support, sums)) {
    std::fill_n(blocks.mass.data() + first, nodes, T(0));
    std::fill_n(blocks.velocity.data() + first * half, nodes * half, T(0));
    std::fill_n(blocks.previous.data() + first * half, nodes * half, T(0));
    return ledger;
  }
  for (int i = 0; i < nodes; ++i) {
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
  }
  return ledger;
}

/// Holds the velocities of a block's nodes, and of their images, to the planes; books impulses and losses.
///
/// A virtual mirrored body shares its momentum with the real one, node by node: v = (p + S p')/(m + m'), which is the
/// Galerkin reduction to velocity fields that the mirror maps on themselves. The velocity before the forces is that of
/// the whole body at a symmetry plane, and as the particles brought it at a wall, so that FLIP feels the wall.
///
/// Where planes move, all of this is meant beside their velocity u: v, old and losses here are. The kinetic energy of
/// someone at rest differs from that by u p + m u^2/2, so that a change of momentum dp brings u dp more.
/// \param kept the part of its own velocity that a particle keeps (Transfer)
template <class T, int D>
[[gnu::noinline]] GridLedger<D> hold_to_planes(std::uint32_t block, grid::Blocks<T, D>& blocks,
                                               const grid::Domain<D>& domain, int support, double kept,
                                               const Vec<double, D>& frame_velocity) {
  GridLedger<D> ledger;
  Images<D> images;
  images.frame_velocity = frame_velocity;
  const Vec<T, D> u = cast<T>(frame_velocity);
  const auto energy = [](T mass, const Vec<T, D>& v) { return 0.5 * double(mass * dot(v, v)); };
  for (std::size_t i = 0; i < std::size_t(grid::block_nodes<D>); ++i) {
    const std::size_t node = std::size_t(block) * grid::block_nodes<D> + i;
    if (!images.find(node, domain, blocks, support)) continue;
    T mass;
    const Vec<T, D> v = images.mean(blocks, blocks.velocity, mass), old = images.mean(blocks, blocks.previous, mass);
    ledger.work += energy(mass, v) - energy(mass, old);
    ledger.wall_loss -= energy(mass, old);
    Vec<T, D> whole[64];
    for (int k = 0; k < images.count; ++k) whole[k] = u + images.symmetric_mean(blocks, blocks.previous, k);
    for (int k = 0; k < images.count; ++k) {
      const auto& image = images.image[std::size_t(k)];
      const T m = blocks.mass[image.node];
      const Vec<T, D> raw = node_vector<T, D>(blocks.velocity.data(), image.node), held = u + images.reflect(v, image),
                      before = node_vector<T, D>(blocks.previous.data(), image.node);
      const Vec<T, D> push = m * (held - raw - T(kept) * (whole[k] - before));
      for (std::size_t c = 0; c < std::size_t(D); ++c)
        if (images.held[c] >= 0) {
          ledger.impulse[std::size_t(images.held[c])][int(c)] += double(push[int(c)]);
          ledger.piston_work += double(push[int(c)]) * frame_velocity[int(c)];
        }
      ledger.wall_loss += energy(m, whole[k] - u);
      ledger.work -= energy(m, raw) - energy(m, before) - double(m * dot(u, held - whole[k]));
      set_node_vector(blocks.velocity.data(), image.node, held);
      set_node_vector(blocks.previous.data(), image.node, whole[k]);
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
  sum_tiles<width>(block, tiling, accumulators, support, sums);
  for (int i = 0; i < nodes; ++i) {
    const std::size_t node = std::size_t(block) * nodes + std::size_t(i);
    const T m = solid(sums[i * width + D]), over_m = m > T(0) ? T(1) / m : T(0);
    blocks.mass[node] = m;
    Vec<T, D> v{};
    for (int a = 0; a < D; ++a) v[a] = over_m * sums[i * width + a];
    set_node_vector(blocks.velocity.data(), node, v);
  }
}

/// The velocity field that the particles' new momenta make, before any plane.
template <class T, int D>
[[gnu::noinline]] void remap_block(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support,
                                   grid::Blocks<T, D>& blocks) {
  constexpr int width = Momentum<T, D>::width, nodes = grid::block_nodes<D>;
  alignas(64) T sums[nodes * width];
  sum_tiles<width>(block, tiling, accumulators, support, sums);
  for (int i = 0; i < nodes; ++i) {
    const std::size_t node = std::size_t(block) * nodes + std::size_t(i);
    const T m = blocks.mass[node];
    Vec<T, D> v{};
    for (int a = 0; a < D; ++a) v[a] = m > T(0) ? sums[i * width + a] / m : T(0);
    set_node_vector(blocks.remapped.data(), node, v);
  }
}

/// Holds a velocity field to the planes. \return the impulses that this takes, of velocities that the particles get
template <class T, int D>
[[gnu::noinline]] GridLedger<D> hold_field(std::uint32_t block, AlignedVector<T>& field,
                                           const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain, int support,
                                           const Vec<double, D>& frame_velocity) {
  GridLedger<D> ledger;
  Images<D> images;
  images.frame_velocity = frame_velocity;
  for (std::size_t i = 0; i < std::size_t(grid::block_nodes<D>); ++i) {
    const std::size_t node = std::size_t(block) * grid::block_nodes<D> + i;
    if (!images.find(node, domain, blocks, support)) continue;
    T mass;
    const Vec<T, D> v = images.mean(blocks, field, mass);
    for (int k = 0; k < images.count; ++k) {
      const auto& image = images.image[std::size_t(k)];
      const Vec<T, D> held = cast<T>(frame_velocity) + images.reflect(v, image),
                      push = blocks.mass[image.node] * (held - node_vector<T, D>(field.data(), image.node));
      for (std::size_t c = 0; c < std::size_t(D); ++c)
        if (images.held[c] >= 0) ledger.impulse[std::size_t(images.held[c])][int(c)] += double(push[int(c)]);
      set_node_vector(field.data(), image.node, held);
    }
  }
  return ledger;
}

}  // namespace mote::passes
