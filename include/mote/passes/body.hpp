/// \file
/// What the passes work on: a body, its particles and tiles, and where they are on the grid.
#pragma once

#include <vector>

#include <mote/particles/particles.hpp>
#include <mote/passes/tiles.hpp>

namespace mote::passes {

/// Particles of one material.
template <class MaterialType, class T, int D, class Transfer>
struct Body {
  using Material = MaterialType;
  using number = T;
  static constexpr int dimension = D;
  /// Exactly what the parts declare; the Id names a particle in messages and frames.
  using list = union_of<fields<field::Position, field::Velocity, field::Mass, field::Id>, particle_fields_of<Transfer>,
                        particle_fields_of<Material>>;

  Material material;
  Particles<T, D, list> particles;
  std::uint32_t tiles_begin = 0, tiles_end = 0;
};

/// What a tile reports of its particles after a pass.
struct TileReport {
  static constexpr std::uint32_t fine = ~std::uint32_t(0);
  double max_speed = 0;         ///< max (c + |v|), m/s
  std::uint32_t failed = fine;  ///< first particle that is no number or beyond its equation of state
};

/// Positions in cells from the first node of a tile's block: small numbers, with the error of x alone.
template <class T, int D>
struct TileFrame {
  Vec<T, D> origin;
  T per_spacing;

  Vec<Pack<T>, D> in_cells(const Vec<Pack<T>, D>& x) const {
    Vec<Pack<T>, D> xi;
    for (int a = 0; a < D; ++a) xi[a] = (x[a] - origin[a]) * per_spacing;
    return xi;
  }
};

/// Where the nodes are.
template <class T, int D>
struct Frame {
  double spacing;
  Vec<double, D> origin;

  double node_position(int axis, std::int32_t node) const { return origin[axis] + spacing * node; }

  TileFrame<T, D> of_block(const IVec<D>& block) const {
    TileFrame<T, D> f{{}, T(1 / spacing)};
    for (int a = 0; a < D; ++a) f.origin[a] = T(node_position(a, block[a] * grid::block_edge));
    return f;
  }
};

/// Calls f(first, n) for the packs of a tile's particles.
template <int D, class F>
void for_each_pack(const Tile<D>& tile, const F& f) {
  for (std::uint32_t i = 0; i < tile.count; i += lanes)
    f(std::size_t(tile.first + i), std::min(lanes, int(tile.count - i)));
}

/// Packs of components to one record per lane.
template <class T, int N>
[[gnu::always_inline]] inline void to_records(const Pack<T> (&components)[N], Simd<T, N> (&records)[lanes]) {
  if constexpr (N == lanes) {
    transpose(components, records);
  } else {
    for (int c = 0; c < N; ++c)
      for (int l = 0; l < lanes; ++l) records[l].set(c, components[c][std::size_t(l)]);
  }
}

}  // namespace mote::passes
