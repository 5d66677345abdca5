/// \file
/// Gathering for a batch of particles, cell by cell.
///
/// Particles lie in the order of their cells, but for those that have moved on since the last sort. A window of eight
/// neighbours in the columns gathers at once what those of the first one's cell want; then the next that is left opens
/// a window.
#pragma once

#include <bit>
#include <cstdint>

#include <mote/passes/body.hpp>
#include <mote/passes/stencil.hpp>

namespace mote::passes {

/// Particles per batch: few enough that what they gather stays in the first cache.
inline constexpr int batch = 4 * lanes;
static_assert(batch <= 64, "a batch has a bit per particle");

/// Calls f(first, n) for the batches of a tile.
template <int D, class F>
void for_each_batch(const Tile<D>& tile, const F& f) {
  for (std::uint32_t i = 0; i < tile.count; i += batch)
    f(std::size_t(tile.first + i), int(std::min(std::uint32_t(batch), tile.count - i)));
}

/// What a batch gathers of the D components of a node field, in columns.
template <Wanted W, class T, int D>
class SumColumns {
  static constexpr int slopes = 1, moments = slopes + (W.slopes ? D : 0), each = moments + (W.moments ? D : 0);
  alignas(64) T data_[D][each][batch + lanes];

 public:
  /// Writes from particle i on where the bits of `lanes` say so; without Some to all lanes.
  template <bool Some>
  [[gnu::always_inline]] void put(int i, int c, const Sums<T, D>& sums, unsigned bits) {
    const auto put_one = [&](const Pack<T>& value, T* to) __attribute__((always_inline)) {
      if constexpr (Some)
        write(select(mask_of_bits<T, lanes>(bits), value, read<Pack<T>>(to + i)), to + i);
      else
        write(value, to + i);
    };
    put_one(sums.value, data_[c][0]);
    for (int a = 0; a < D; ++a) {
      if constexpr (W.slopes) put_one(sums.slope[a], data_[c][slopes + a]);
      if constexpr (W.moments) put_one(sums.moment[a], data_[c][moments + a]);
    }
  }
  Pack<T> value(int i, int c) const { return read<Pack<T>>(data_[c][0] + i); }
  Pack<T> slope(int i, int c, int a) const { return read<Pack<T>>(data_[c][slopes + a] + i); }
  Pack<T> moment(int i, int c, int a) const { return read<Pack<T>>(data_[c][moments + a] + i); }
};

/// Where the particles of a batch are.
template <class Shape, class T, int D>
class BatchNodes {
  using Nodes = Simd<int, lanes>;
  alignas(64) T xi_[D][batch + lanes];
  alignas(64) T base_[D][batch + lanes];
  alignas(64) int node_[batch + lanes];
  [[no_unique_address]] HalfSizeRows<Shape, T, D, batch + lanes> half_;
  int count_ = 0;

 public:
  void clear() { count_ = 0; }

  /// Appends a pack; surplus lanes repeat its last particle, and gather what that one does.
  /// \param xi positions in cells, relative to the first node of the tile's block
  [[gnu::always_inline]] void append(const Vec<Pack<T>, D>& xi, const NodeBox<D>& box,
                                     const HalfSizes<Shape, T, D>& half = no_half_sizes<Shape, T, D>()) {
    const LowestNodes<Shape, T, D> at(xi, box);
    for (int a = 0; a < D; ++a) {
      write(xi[a], xi_[a] + count_);
      write(at.base[a], base_[a] + count_);
    }
    half_.put(count_, half);
    for (int l = 0; l < lanes; ++l) node_[count_ + l] = at.node[l];
    count_ += lanes;
  }

  /// Calls f(particle, its lowest node's number, stencil, bits, some) for windows of eight particles that cover the
  /// batch. The stencil holds for the particles in `bits`; `some` is true if other lanes must be left alone.
  /// \return the number of windows
  template <class F>
  [[gnu::always_inline]] int for_each_window(const F& f) const {
    const std::uint64_t all = ~std::uint64_t(0) >> (64 - count_);
    int windows = 0;
    for (std::uint64_t left = all; left != 0; ++windows) {
      const int i = std::countr_zero(left);
      const std::uint64_t bits = equal_bits(read<Nodes>(node_ + i), Nodes(node_[i])) & (left >> i);
      Stencil<T, D, Shape> stencil;
      const HalfSizes<Shape, T, D> half = half_.get(i);
      for (int a = 0; a < D; ++a) stencil.set(a, read<Pack<T>>(xi_[a] + i) - base_[a][i], half);
      f(i, node_[i], stencil, unsigned(bits), ((all & ~left) >> i & 0xff) != 0);
      left &= ~(bits << i);
    }
    return windows;
  }
};

/// Calls f(first, n, number in the batch, frame of the tile) for the packs of a tile's particles, for those of a batch
/// after gather(at), which is to gather what they want where they are.
template <class Shape, class B, class T, int D, class Gather, class F>
[[gnu::always_inline]] inline void for_each_gathered_pack(const B& body, const Tile<D>& tile, const Frame<T, D>& frame,
                                                          const NodeBox<D>& box, const Gather& gather, const F& f) {
  const TileFrame<T, D> in_tile = frame.of_block(tile.block);
  BatchNodes<Shape, T, D> at;
  for_each_batch(tile, [&](std::size_t begin, int count) {
    at.clear();
    for (int i = 0; i < count; i += lanes) {
      Values<Pack<T>, D, union_of<fields<field::Position>, particle_fields_of<Shape>>> p;
      body.particles.load(begin + std::size_t(i), std::min(lanes, count - i), p);
      at.append(in_tile.in_cells(get<field::Position>(p)), box, half_sizes<Shape>(p, in_tile.per_spacing));
    }
    gather(at);
    for (int i = 0; i < count; i += lanes) f(begin + std::size_t(i), std::min(lanes, count - i), i, in_tile);
  });
}

}  // namespace mote::passes
