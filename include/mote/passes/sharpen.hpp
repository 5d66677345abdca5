/// \file
/// Sharpening: what a lumped mass smooths away of a velocity field, recovered by repeated transfers.
///
/// S takes a node field to the particles, (S v)_p = sum_i w_ip v_i, and S+ brings their momentum back,
/// (S+ V)_i = sum_p w_ip m_p V_p / m_i. With the planes' projection P the operator B = P S+ S on the fields that the
/// planes allow is self-adjoint and non-negative in the inner product of the nodes' masses, and at most 1. The
/// consistent mass matrix is that of the lumped masses times B, so its inverse is the Neumann series sum (1 - B)^j,
/// which never grows. Each correction d_j = (1 - B) d_(j-1) carries no momentum but what planes give (sum m_i (S+ S
/// d)_i = sum m_i d_i), so an order cut off conserves momentum as exactly as none.
///
/// The last term may weigh more than one, since it stands for all that are cut off: (1 - B)^n/B.
#pragma once

#include <mote/passes/batch.hpp>
#include <mote/passes/grid_update.hpp>
#include <mote/passes/scatter.hpp>

namespace mote::passes {

/// A node field to the particles of a tile, and its momentum back to the accumulators: the tile's part of m_i (S+ S
/// v)_i.
template <class Shape, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] void transfer_and_return(const B& body, const Tile<D>& tile,
                                                         const std::vector<Link<D>>& links,
                                                         const AlignedVector<T>& field, const Frame<T, D>& frame,
                                                         T* accumulators) {
  constexpr int half = grid::node_width<D>, width = Momentum<T, D>::width;
  constexpr Wanted value{false, false};
  const NodeBox<D> box(tile, Shape::support);
  alignas(64) T nodes[NodeBox<D>::capacity(Shape::support) * half];
  for (std::uint32_t k = tile.links_begin; k < tile.links_end; ++k) {
    const T* block = field.data() + std::size_t(links[k].block) * grid::block_nodes<D> * half;
    for_each_row(
        links[k], box, [&](int in_box, int in_block, auto count) __attribute__((always_inline)) {
          std::copy_n(block + std::ptrdiff_t(in_block) * half, count * half, nodes + std::ptrdiff_t(in_box) * half);
        });
  }
  T* returned = accumulators + tile.buffer * width;
  std::fill_n(returned, box.size * width, T(0));
  SumColumns<value, T, D> sums;
  const auto gather_value = [&](BatchNodes<Shape, T, D>& at) {
    at.for_each_window([&](int i, int node, const auto& stencil, unsigned bits,
                           bool some) __attribute__((always_inline)) {
      for (int c = 0; c < D; ++c) {
        const Sums<T, D> of_node = gather<value>(nodes + std::ptrdiff_t(node) * half, c, box, stencil);
        if (some)
          sums.template put<true>(i, c, of_node, bits);
        else
          sums.template put<false>(i, c, of_node, bits);
      }
    });
  };
  for_each_gathered_pack<Shape>(
      body, tile, frame, box, gather_value,
      [&](std::size_t first, int n, int i, const auto& in_tile) __attribute__((always_inline)) {
        Values<Pack<T>, D, union_of<fields<field::Position, field::Mass>, particle_fields_of<Shape>>> p;
        body.particles.load(first, n, p);
        Momentum<T, D> brought;
        for (int c = 0; c < D; ++c) brought.value[c] = get<field::Mass>(p) * sums.value(i, c);
        scatter_pack<Shape, AxisWeights::none>(returned, box, in_tile.in_cells(get<field::Position>(p)), n,
                                               brought.value, brought.axis, half_sizes<Shape>(p, in_tile.per_spacing));
      });
}

/// residual -= S+ S residual on a block's nodes, before any plane. \return sum m (residual before) (residual after)
template <class T, int D>
[[gnu::noinline]] double subtract_returned(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators,
                                           int support, grid::Blocks<T, D>& blocks) {
  constexpr int width = Momentum<T, D>::width, nodes = grid::block_nodes<D>;
  alignas(64) T sums[nodes * width];
  const std::size_t first = std::size_t(block) * nodes;
  double product = 0;
  const auto subtract = [&](int i) {
    const std::size_t node = first + std::size_t(i);
    const T m = blocks.mass[node], over_m = m > T(0) ? T(1) / m : T(0);
    const Vec<T, D> before = node_vector<T, D>(blocks.residual.data(), node);
    Vec<T, D> d{};
    for (int a = 0; a < D; ++a) d[a] = m > T(0) ? before[a] - over_m * sums[i * width + a] : T(0);
    product += double(m * dot(before, d));
    set_node_vector(blocks.residual.data(), node, d);
  };
  for_each_node<D>(sum_tiles<width>(block, tiling, accumulators, support, sums), subtract,
                   [&](int row) { clear_row<D>(blocks.residual, first + std::size_t(row)); });
  return product;
}

template <int D>
inline constexpr std::size_t block_numbers = std::size_t(grid::block_nodes<D>) * grid::node_width<D>;

template <int D, class T>
void copy_block(std::size_t block, const AlignedVector<T>& from, AlignedVector<T>& to) {
  std::copy_n(from.data() + block * block_numbers<D>, block_numbers<D>, to.data() + block * block_numbers<D>);
}
/// to += weight residual. \return sum m residual^2
template <class T, int D>
double add_residual(std::size_t block, const grid::Blocks<T, D>& blocks, T weight, AlignedVector<T>& to) {
  double square = 0;
  for (std::size_t node = block * grid::block_nodes<D>; node < (block + 1) * grid::block_nodes<D>; ++node) {
    const Vec<T, D> d = node_vector<T, D>(blocks.residual.data(), node);
    square += double(blocks.mass[node] * dot(d, d));
    set_node_vector(to.data(), node, node_vector<T, D>(to.data(), node) + weight * d);
  }
  return square;
}
/// to = a - b
template <int D, class T>
void subtract_blocks(std::size_t block, const AlignedVector<T>& a, const AlignedVector<T>& b, AlignedVector<T>& to) {
  for (std::size_t i = block * block_numbers<D>; i < (block + 1) * block_numbers<D>; ++i) to[i] = a[i] - b[i];
}

/// sharp += (1 - B) v + ... + tail (1 - B)^(order - 1) v for the node field v that blocks.residual holds, and loses.
///
/// If v is the change of velocity by forces, these do the work sum m v c/2 on its correction c. (1 - B) is
/// self-adjoint: sum m v (1 - B)^n v is, after the j-th term, the product of the last two terms (n = 2j - 1) and the
/// square of the last (n = 2j).
///
/// \param for_each_tile, sum_over_blocks  sweep over what is awake: f(body, tile), the sum of f(block)
/// \param hold  holds a field to the planes and returns the impulses that they give
/// \return the impulses that the planes give to the corrections, and that work
template <class Shape, class ForEachTile, class SumOverBlocks, class Hold, class T, int D>
GridLedger<D> sharpen(const ForEachTile& for_each_tile, const SumOverBlocks& sum_over_blocks, const Hold& hold,
                      int order, double tail, AlignedVector<T>& sharp, const Tiling<D>& tiling,
                      grid::Blocks<T, D>& blocks, const Frame<T, D>& frame, T* accumulators) {
  GridLedger<D> given;
  const auto weight = [&](int n) { return n == order - 1 ? tail : n < order ? 1.0 : 0.0; };  // of (1 - B)^n v
  AlignedVector<T>& residual = blocks.residual;
  hold(residual);  // incoming velocities are not held to walls yet
  for (int j = 1; j < order; ++j) {
    for_each_tile([&](const auto& body, std::uint32_t t) {
      transfer_and_return<Shape>(body, tiling.tiles[t], tiling.links, residual, frame, accumulators);
    });
    const double product = sum_over_blocks(
        [&](std::uint32_t b) { return subtract_returned(b, tiling, accumulators, Shape::support, blocks); });
    const GridLedger<D> by_planes = hold(residual);
    for (std::size_t i = 0; i < given.impulse.size(); ++i) given.impulse[i] += weight(j) * by_planes.impulse[i];
    const double square =
        sum_over_blocks([&](std::uint32_t b) { return add_residual(b, blocks, T(weight(j)), sharp); });
    given.work += 0.5 * (weight(2 * j - 1) * product + weight(2 * j) * square);
  }
  return given;
}

}  // namespace mote::passes
