/// \file
/// Sparse storage of node fields in blocks of 4^D nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <mote/core/aligned.hpp>
#include <mote/core/pack.hpp>
#include <mote/grid/block_index.hpp>

namespace mote::grid {

/// Nodes per axis of a block; a power of two.
inline constexpr int block_edge = 4;

/// Nodes of a block.
template <int D>
inline constexpr int block_nodes = D == 1 ? block_edge
                                          : (D == 2 ? block_edge * block_edge : block_edge * block_edge * block_edge);

/// Numbers by which a vector of D components is stored on a node: a power of two, to load it at once. The first half of
/// an accumulator also holds the mass.
template <int D>
inline constexpr int node_width = D == 1 ? 2 : 4;

/// Coordinates of the block and of the node within it.
inline std::int32_t block_of(std::int32_t node) { return node >> 2; }
inline std::int32_t within_block(std::int32_t node) { return node & (block_edge - 1); }

/// Row-major number of a node in its block; the last axis runs fastest.
template <int D>
int local_index(const IVec<D>& node) {
  int i = 0;
  for (int a = 0; a < D; ++a) i = i * block_edge + within_block(node[a]);
  return i;
}

/// The node fields of the blocks that particles can reach. Each vector field has node_width<D> numbers per node.
template <class T, int D>
struct Blocks {
  BlockIndex<D> index;
  AlignedVector<T> mass;      ///< kg
  AlignedVector<T> velocity;  ///< m/s, after forces and boundaries
  AlignedVector<T> previous;  ///< m/s, as the particles brought it, before the forces
  AlignedVector<T> remapped;  ///< m/s, from the particles' new velocities; empty unless the update asks for it
  AlignedVector<T> sharp;     ///< m/s, what the particles take; empty unless the transfer asks for it (XPIC)
  AlignedVector<T> residual;  ///< m/s, what sharpening has not recovered yet; empty unless the transfer sharpens

  std::size_t nodes() const { return index.size() * std::size_t(block_nodes<D>); }

  void allocate(bool with_remapped, bool with_sharp, bool with_residual) {
    const auto resize = [](auto& field, std::size_t n) {
      reserve_amply(field, n);
      field.resize(n);
    };
    resize(mass, nodes());
    resize(velocity, nodes() * node_width<D>);
    resize(previous, velocity.size());
    if (with_remapped) resize(remapped, velocity.size());
    if (with_sharp) resize(sharp, velocity.size());
    if (with_residual) resize(residual, velocity.size());
  }

  /// Takes the mass of a block's nodes.
  void clear_mass(std::size_t block) {
    std::fill_n(mass.data() + block * std::size_t(block_nodes<D>), block_nodes<D>, T(0));
  }

  /// Number of the node with these coordinates, or `none` where no block is.
  static constexpr std::size_t none = ~std::size_t(0);
  std::size_t find(const IVec<D>& node) const {
    IVec<D> block{};
    for (int a = 0; a < D; ++a) block[a] = block_of(node[a]);
    const auto b = index.find(block);
    return b == BlockIndex<D>::none ? none : std::size_t(b) * block_nodes<D> + std::size_t(local_index<D>(node));
  }

  /// Coordinates of a node by its number.
  IVec<D> coordinates(std::size_t node) const {
    IVec<D> c = index[node / std::size_t(block_nodes<D>)];
    int local = int(node % std::size_t(block_nodes<D>));
    for (int a = D - 1; a >= 0; --a) {
      c[a] = c[a] * block_edge + local % block_edge;
      local /= block_edge;
    }
    return c;
  }
};

}  // namespace mote::grid
