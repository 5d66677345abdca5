/// \file
/// Tiles: the particles of one block of cells, the nodes that they reach, and the links between those and the blocks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <mote/core/error.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/grid/domain.hpp>

namespace mote::passes {

/// Lowest nodes of a tile's particles, relative to its block, may drift by a cell before a sort is due.
inline constexpr int drift = 1;
inline constexpr int lowest = -drift, highest = grid::block_edge - 1 + drift;

/// A contiguous range of particles whose lowest node lay in one block at the last sort.
template <int D>
struct Tile {
  IVec<D> block;
  std::uint32_t first, count;              ///< particles
  std::array<std::int8_t, D> lo, hi;       ///< range of the particles' lowest nodes, relative to the block
  std::array<std::int8_t, D> least, most;  ///< where that range may lie until a sort is due
  std::uint32_t links_begin, links_end;
  std::uint64_t buffer;  ///< first node of its accumulators

  /// Whether a particle has drifted by more than a cell, or beyond a plane by more than half a cell.
  bool strayed() const { return beyond(least, most); }
  /// Whether a particle reaches nodes that the tile is not linked to.
  bool unlinked() const {
    std::array<std::int8_t, D> from, to;
    from.fill(lowest), to.fill(highest);
    return beyond(from, to);
  }

 private:
  bool beyond(const std::array<std::int8_t, D>& from, const std::array<std::int8_t, D>& to) const {
    for (std::size_t a = 0; a < std::size_t(D); ++a)
      if (lo[a] < from[a] || hi[a] > to[a]) return true;
    return false;
  }
};

/// Shape of the box of nodes that a tile's particles reach; nodes count from lo, the last axis runs fastest.
template <int D>
struct NodeBox {
  std::array<int, D> lo, extent, stride;
  int size;

  NodeBox(const Tile<D>& tile, int support) {
    size = 1;
    for (int a = D - 1; a >= 0; --a) {
      const auto u = std::size_t(a);
      lo[u] = tile.lo[u];
      extent[u] = tile.hi[u] - tile.lo[u] + support;
      stride[u] = size;
      size *= extent[u];
    }
  }
  /// The largest number of nodes of any tile.
  static constexpr int capacity(int support) {
    int n = 1;
    for (int a = 0; a < D; ++a) n *= highest - lowest + support;
    return n;
  }
};

/// A box of nodes that a tile and a block share (after periods are taken out).
template <int D>
struct Link {
  std::uint32_t tile, block;
  std::array<std::int8_t, D> from;   ///< first shared node, relative to the tile's block
  std::array<std::int8_t, D> at;     ///< the same node within the block
  std::array<std::int8_t, D> count;  ///< nodes per axis
};

/// Calls f(node in the tile's box, node in the block, length) for each row of the link that lies in the tile's box; the
/// length is a constant, 1 to block_edge, since rows are short and many.
template <int D, class F>
[[gnu::always_inline]] inline void for_each_row(const Link<D>& link, const NodeBox<D>& box, const F& f) {
  std::array<int, D> from, to;
  for (std::size_t a = 0; a < std::size_t(D); ++a) {
    from[a] = std::max(int(link.from[a]), box.lo[a]);
    to[a] = std::min(link.from[a] + link.count[a], box.lo[a] + box.extent[a]);
    if (from[a] >= to[a]) return;
  }
  constexpr std::size_t z = std::size_t(D - 1);
  const auto box_offset = [&](std::size_t a, int i) { return (i - box.lo[a]) * box.stride[a]; };
  const auto block_offset = [&](std::size_t a, int i) { return i - link.from[a] + link.at[a]; };
  const auto rows = [&](auto length) __attribute__((always_inline)) {
    const auto row = [&](int in_box, int in_block) __attribute__((always_inline)) {
      f(in_box + from[z] - box.lo[z], in_block * grid::block_edge + block_offset(z, from[z]), length);
    };
    if constexpr (D == 1) {
      row(0, 0);
    } else if constexpr (D == 2) {
      for (int i = from[0]; i < to[0]; ++i) row(box_offset(0, i), block_offset(0, i));
    } else {
      for (int i = from[0]; i < to[0]; ++i)
        for (int j = from[1]; j < to[1]; ++j)
          row(box_offset(0, i) + box_offset(1, j), block_offset(0, i) * grid::block_edge + block_offset(1, j));
    }
  };
  static_assert(grid::block_edge == 4);
  switch (to[z] - from[z]) {
    case 1:
      return rows(std::integral_constant<int, 1>{});
    case 2:
      return rows(std::integral_constant<int, 2>{});
    case 3:
      return rows(std::integral_constant<int, 3>{});
    default:
      return rows(std::integral_constant<int, 4>{});
  }
}

/// All tiles of all bodies, and their links, from both sides.
template <int D>
struct Tiling {
  std::vector<Tile<D>> tiles;
  std::vector<Link<D>> links;                    ///< by tile
  std::vector<std::uint32_t> block_links_begin;  ///< per block, into block_links; one more than blocks
  std::vector<std::uint32_t> block_links;        ///< numbers of links, by block, in the order of tiles

  /// Gives each tile its place in the accumulators, with room for the largest box; what is not used is never touched.
  /// \return nodes in all
  std::size_t place_buffers(int support) {
    const auto capacity = std::uint64_t(NodeBox<D>::capacity(support));
    for (std::size_t t = 0; t < tiles.size(); ++t) tiles[t].buffer = t * capacity;
    return tiles.size() * capacity;
  }
};

/// Ghost nodes per mirror plane that can matter: those beyond it that a particle may reach before the next sort.
/// A tile's lowest nodes go down to floor(plane - 1/2 - first) (Linker::limit), its highest as far beyond an upper
/// plane: support / 2 layers with first = (support - 2) / 2. Half of an odd support is rounded up, one layer to spare.
inline constexpr int ghosts(int support) { return (support + 1) / 2; }

/// Finds the blocks that the tiles can reach until the next sort, and links tiles and blocks.
template <class T, int D>
class Linker {
  struct Segment {
    std::int8_t from, at, count;
    std::int32_t block;
  };
  std::array<std::vector<Segment>, D> segments_;

 public:
  /// \param first offset of a particle's lowest node (Shape)
  void operator()(Tiling<D>& tiling, grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain, int support,
                  double first) {
    blocks.index.clear();
    tiling.links.clear();
    for (std::uint32_t t = 0; t < tiling.tiles.size(); ++t) {
      auto& tile = tiling.tiles[t];
      for (int a = 0; a < D; ++a) cut(segments_[std::size_t(a)], tile.block[a], a, domain, support);
      for (int a = 0; a < D; ++a) limit(tile, a, domain, first);
      tile.links_begin = std::uint32_t(tiling.links.size());
      link(tiling, blocks, t);
      tile.links_end = std::uint32_t(tiling.links.size());
    }
    sort_by_block(tiling, blocks.index.size());
  }

 private:
  /// How far the lowest nodes may go along an axis: a cell further than at the sort, half a cell beyond a plane.
  static void limit(Tile<D>& tile, int axis, const grid::Domain<D>& domain, double first) {
    const auto relative = [&](double node) {
      return std::int8_t(std::clamp(int(node) - tile.block[axis] * grid::block_edge, lowest, highest));
    };
    const auto &lower = domain.plane(axis, 0), &upper = domain.plane(axis, 1);
    tile.least[std::size_t(axis)] = lower ? relative(std::floor(lower->node - 0.5 - first)) : std::int8_t(lowest);
    tile.most[std::size_t(axis)] = upper ? relative(std::ceil(upper->node + 0.5 - first) - 1) : std::int8_t(highest);
  }

  /// Cuts a tile's reach along an axis where blocks change or a period ends.
  static void cut(std::vector<Segment>& segments, std::int32_t tile_block, int axis, const grid::Domain<D>& domain,
                  int support) {
    segments.clear();
    for (int r = lowest; r < highest + support; ++r) {
      const std::int32_t node = domain.wrapped(axis, tile_block * grid::block_edge + r);
      const std::int32_t block = grid::block_of(node);
      const int at = grid::within_block(node);
      if (!segments.empty() && segments.back().block == block && segments.back().at + segments.back().count == at)
        ++segments.back().count;
      else
        segments.push_back({std::int8_t(r), std::int8_t(at), 1, block});
    }
  }

  void link(Tiling<D>& tiling, grid::Blocks<T, D>& blocks, std::uint32_t tile) {
    std::array<std::size_t, D> i{};
    for (;;) {
      Link<D> l;
      IVec<D> block{};
      for (std::size_t a = 0; a < std::size_t(D); ++a) {
        const Segment& s = segments_[a][i[a]];
        l.from[a] = s.from, l.at[a] = s.at, l.count[a] = s.count;
        block[int(a)] = s.block;
      }
      l.tile = tile;
      l.block = blocks.index.insert(block);
      tiling.links.push_back(l);
      std::size_t a = 0;
      while (a < std::size_t(D) && ++i[a] == segments_[a].size()) i[a++] = 0;
      if (a == std::size_t(D)) return;
    }
  }

  static void sort_by_block(Tiling<D>& tiling, std::size_t block_count) {
    auto& begin = tiling.block_links_begin;
    begin.assign(block_count + 1, 0);
    for (const auto& l : tiling.links) ++begin[l.block + 1];
    for (std::size_t b = 0; b < block_count; ++b) begin[b + 1] += begin[b];
    tiling.block_links.resize(tiling.links.size());
    for (std::uint32_t i = 0; i < tiling.links.size(); ++i) tiling.block_links[begin[tiling.links[i].block]++] = i;
    for (std::size_t b = block_count; b > 0; --b) begin[b] = begin[b - 1];
    begin[0] = 0;
  }
};

}  // namespace mote::passes
