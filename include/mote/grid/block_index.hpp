/// \file
/// From a block's coordinates to its number.
#pragma once

#include <cstdint>
#include <vector>

#include <mote/core/vec.hpp>

namespace mote::grid {

/// Hash table with open addressing; clearing keeps its memory, so that a warm solver does not allocate.
template <int D>
class BlockIndex {
  static constexpr std::uint64_t empty = ~std::uint64_t(0);
  std::vector<std::uint64_t> keys_ = std::vector<std::uint64_t>(64, empty);
  std::vector<std::uint32_t> values_ = std::vector<std::uint32_t>(64);
  std::vector<IVec<D>> blocks_;

 public:
  static constexpr std::uint32_t none = ~std::uint32_t(0);
  /// Coordinates must lie in [-limit, limit).
  static constexpr std::int32_t limit = 1 << 20;

  std::size_t size() const { return blocks_.size(); }
  const IVec<D>& operator[](std::size_t i) const { return blocks_[i]; }

  void clear() {
    keys_.assign(keys_.size(), empty);
    blocks_.clear();
  }

  /// The number of the block, or `none`.
  std::uint32_t find(const IVec<D>& block) const {
    const std::size_t s = slot(key(block));
    return keys_[s] == empty ? none : values_[s];
  }

  /// The number of the block; a new one is counted up from 0.
  std::uint32_t insert(const IVec<D>& block) {
    const std::uint64_t k = key(block);
    std::size_t s = slot(k);
    if (keys_[s] != empty) return values_[s];
    if (2 * (blocks_.size() + 1) > keys_.size()) {
      grow();
      s = slot(k);
    }
    keys_[s] = k;
    values_[s] = std::uint32_t(blocks_.size());
    blocks_.push_back(block);
    return values_[s];
  }

 private:
  static std::uint64_t key(const IVec<D>& block) {
    std::uint64_t k = 0;
    for (int a = 0; a < D; ++a) k = k << 21 | std::uint64_t(block[a] + limit);
    return k;
  }
  std::size_t slot(std::uint64_t k) const {
    std::uint64_t h = k * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
    std::size_t s = std::size_t(h) & (keys_.size() - 1);
    while (keys_[s] != empty && keys_[s] != k) s = (s + 1) & (keys_.size() - 1);
    return s;
  }
  void grow() {
    keys_.assign(2 * keys_.size(), empty);
    values_.resize(keys_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const std::size_t s = slot(key(blocks_[i]));
      keys_[s] = key(blocks_[i]);
      values_[s] = std::uint32_t(i);
    }
  }
};

}  // namespace mote::grid
