/// \file
/// Sorting: particles by the cell of their lowest node, blocks in lexicographic order.
#pragma once

#include <numeric>

#include <mote/core/error.hpp>
#include <mote/passes/body.hpp>

namespace mote::passes {

/// Buffers of a sort; kept between sorts, so that a warm solver does not allocate.
template <int D>
class Sorter {
  grid::BlockIndex<D> index_;
  std::vector<std::uint32_t> slot_;   // per particle: block number and cell within it
  std::vector<std::uint32_t> begin_;  // per slot, in the final order
  std::vector<std::uint32_t> order_;  // final place -> particle
  std::vector<std::uint32_t> rank_, by_rank_;
  std::vector<std::vector<std::byte>> scratch_;
  std::vector<void (*)(void*, const Sorter&, std::vector<std::byte>&)> movers_;
  std::vector<void*> columns_;

  static constexpr std::uint32_t cells = std::uint32_t(grid::block_nodes<D>);

 public:
  /// Moves a body's particles into cell order and appends its tiles. Particles beyond a period come back into the
  /// domain.
  ///
  /// `lost(p, why)` is called for a particle that is nowhere: not a number, or beyond a plane by more than half a cell.
  template <class Shape, class B, class T, class Executor, class Lost>
  void operator()(B& body, std::vector<Tile<D>>& tiles, const Frame<T, D>& frame, const grid::Domain<D>& domain,
                  const Executor& executor, const Lost& lost) {
    const std::size_t n = body.particles.size();
    index_.clear();
    slot_.resize(n);
    for (int a = 0; a < D; ++a) wrap(body.particles.template column<field::Position>(a), domain, a);
    for (std::size_t p = 0; p < n; ++p) slot_[p] = slot<Shape>(body.particles, p, frame, domain, lost);
    rank_blocks();
    count(n);
    body.tiles_begin = std::uint32_t(tiles.size());
    append_tiles(tiles);
    body.tiles_end = std::uint32_t(tiles.size());
    permute(body.particles, executor);
  }

 private:
  template <class Column>
  static void wrap(Column x, const grid::Domain<D>& domain, int axis) {
    if (!domain.periodic(axis)) return;
    using T = typename Column::value_type;
    for (T& v : x) {
      const double wrapped = domain.wrapped_position(axis, double(v));
      if (wrapped != double(v)) v = T(wrapped);
    }
  }

  template <class Shape, class P, class T, class Lost>
  std::uint32_t slot(const P& particles, std::size_t p, const Frame<T, D>& frame, const grid::Domain<D>& domain,
                     const Lost& lost) {
    IVec<D> block{}, node{};
    for (int a = 0; a < D; ++a) {
      const double xi = (double(particles.template column<field::Position>(a)[p]) - frame.origin[a]) / frame.spacing;
      constexpr double far = double(grid::BlockIndex<D>::limit - 4) * grid::block_edge;
      if (!(xi > -far && xi < far)) lost(p, "is not on the grid");
      for (int end = 0; end < 2; ++end)
        if (const auto& plane = domain.plane(a, end))
          if ((end ? xi - plane->node : plane->node - xi) > 0.5)
            lost(p, "has left the domain through a wall or symmetry plane");
      node[a] = std::int32_t(std::floor(xi - Shape::first));
      block[a] = grid::block_of(node[a]);
    }
    return index_.insert(block) * cells + std::uint32_t(grid::local_index<D>(node));
  }

  /// Blocks in lexicographic order, whatever the order of the particles.
  void rank_blocks() {
    by_rank_.resize(index_.size());
    std::iota(by_rank_.begin(), by_rank_.end(), 0u);
    std::sort(by_rank_.begin(), by_rank_.end(), [&](auto i, auto j) {
      return std::lexicographical_compare(index_[i].c, index_[i].c + D, index_[j].c, index_[j].c + D);
    });
    rank_.resize(index_.size());
    for (std::uint32_t r = 0; r < by_rank_.size(); ++r) rank_[by_rank_[r]] = r;
  }

  /// Counting sort, stable.
  void count(std::size_t n) {
    reserve_amply(begin_, index_.size() * cells + 1);
    begin_.assign(index_.size() * cells + 1, 0);
    for (auto& s : slot_) {
      s = rank_[s / cells] * cells + s % cells;
      ++begin_[s + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    order_.resize(n);
    for (std::uint32_t p = 0; p < n; ++p) order_[begin_[slot_[p]]++] = p;
  }

  void append_tiles(std::vector<Tile<D>>& tiles) const {
    std::uint32_t first = 0;
    for (std::uint32_t r = 0; r < by_rank_.size(); ++r) {
      const std::uint32_t last = begin_[r * cells + cells - 1];  // count() moved every begin to its end
      tiles.push_back(Tile<D>{index_[by_rank_[r]], first, last - first, {}, {}, {}, {}, 0, 0, 0});
      first = last;
    }
  }

  template <class N>
  static void move_column(void* data, const Sorter& s, std::vector<std::byte>& scratch) {
    static_assert(sizeof(N) <= sizeof(double));
    auto& column = *static_cast<StaggeredVector<N>*>(data);
    N* to = reinterpret_cast<N*>(scratch.data());
    for (std::size_t i = 0; i < column.size(); ++i) to[i] = column[s.order_[i]];
    std::copy_n(to, column.size(), column.data());
  }

  /// Permutes the columns, as many at a time as there are threads.
  template <class P, class Executor>
  void permute(P& particles, const Executor& executor) {
    if (std::is_sorted(order_.begin(), order_.end())) return;
    columns_.clear();
    movers_.clear();
    particles.for_each_column([&]<class N>(StaggeredVector<N>& column) {
      columns_.push_back(&column);
      movers_.push_back(&move_column<N>);
    });
    const auto strands = std::size_t(std::max(1, executor.concurrency()));
    scratch_.resize(std::max(scratch_.size(), strands));
    for (auto& s : scratch_) s.resize(particles.size() * sizeof(double));  // here, where a failure does no harm
    executor.for_each(strands, [&](std::size_t s) {
      for (std::size_t c = s; c < columns_.size(); c += strands) movers_[c](columns_[c], *this, scratch_[s]);
    });
  }
};

}  // namespace mote::passes
