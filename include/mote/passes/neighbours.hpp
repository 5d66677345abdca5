/// \file
/// Neighbours: which tiles may have nodes in common until the next sort.
#pragma once

#include <span>
#include <vector>

#include <mote/passes/tiles.hpp>

namespace mote::passes {

/// The neighbours of all tiles of all bodies. Links count from blocks with periods taken out, and so do these.
template <int D>
class Neighbours {
  std::vector<std::uint32_t> begin_, all_, seen_;

 public:
  std::span<const std::uint32_t> of(std::uint32_t tile) const {
    return {all_.data() + begin_[tile], all_.data() + begin_[tile + 1]};
  }

  void find(const Tiling<D>& tiling) {
    const auto count = std::uint32_t(tiling.tiles.size());
    all_.clear();
    begin_.clear();
    reserve_amply(begin_, count + 1);
    reserve_amply(seen_, count);
    seen_.assign(count, count);
    for (std::uint32_t t = 0; t < count; ++t) {
      begin_.push_back(std::uint32_t(all_.size()));
      seen_[t] = t;
      for (auto k = tiling.tiles[t].links_begin; k < tiling.tiles[t].links_end; ++k) add(tiling, tiling.links[k]);
    }
    begin_.push_back(std::uint32_t(all_.size()));
  }

 private:
  /// Adds the tiles that have a node in common with a link.
  void add(const Tiling<D>& tiling, const Link<D>& mine) {
    for (auto j = tiling.block_links_begin[mine.block]; j < tiling.block_links_begin[mine.block + 1]; ++j) {
      const Link<D>& other = tiling.links[tiling.block_links[j]];
      if (seen_[other.tile] == mine.tile || !overlap(mine, other)) continue;
      seen_[other.tile] = mine.tile;
      all_.push_back(other.tile);
    }
  }

  /// Whether two links of one block have a node in common.
  static bool overlap(const Link<D>& a, const Link<D>& b) {
    bool common = true;
    for (std::size_t i = 0; i < std::size_t(D); ++i)
      common &= a.at[i] < b.at[i] + b.count[i] && b.at[i] < a.at[i] + a.count[i];
    return common;
  }
};

}  // namespace mote::passes
