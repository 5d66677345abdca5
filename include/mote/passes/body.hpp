/// \file
/// What the passes work on: a body, its particles and tiles, and where they are on the grid.
#pragma once

#include <concepts>
#include <cstring>
#include <tuple>
#include <vector>

#include <mote/core/error.hpp>
#include <mote/core/rearrange.hpp>
#include <mote/core/role.hpp>
#include <mote/particles/particles.hpp>
#include <mote/passes/tiles.hpp>

namespace mote::passes {

/// Particles of one material. \tparam More fields that other parts of the solver declare
template <class MaterialType, class T, int D, class Transfer, class Shape, class More = fields<>>
struct Body {
  using Material = MaterialType;
  using number = T;
  static constexpr int dimension = D;
  /// Exactly what the parts declare; the Id names a particle in messages and frames.
  using list = union_of<fields<field::Position, field::Velocity, field::Mass, field::Id>, particle_fields_of<Transfer>,
                        particle_fields_of<Shape>, particle_fields_of<Material>, More>;

  Material material;
  Particles<T, D, list> particles;
  std::uint32_t tiles_begin = 0, tiles_end = 0;
};

/// Whether the bodies of these materials have names: their types, or the numbers in them.
template <class... Materials>
inline constexpr bool can_be_told_apart = ((count_of_type<Materials, Materials...> == 1 ||
                                            std::equality_comparable<Materials>)&&...);

/// Whether two materials are one and the same, type and numbers. What cannot be compared is told apart by its type.
template <class A, class B>
bool same_material(const A& a, const B& b) {
  if constexpr (!std::is_same_v<A, B>)
    return false;
  else if constexpr (std::equality_comparable<A>)
    return a == b;
  else
    return true;
}

/// Throws InputError if two of the materials are one and the same.
template <class... Materials>
void require_distinct(const std::tuple<Materials...>& materials) {
  int i = 0;
  const auto compare = [&](const auto& a) {
    int j = 0;
    const auto with = [&](const auto& b) {
      require(j <= i || !same_material(a, b), "materials ", i, " and ", j,
              " of the solver are equal; give a material once, and fill() with it as often as you like");
      ++j;
    };
    std::apply([&](const auto&... b) { (with(b), ...); }, materials);
    ++i;
  };
  std::apply([&](const auto&... a) { (compare(a), ...); }, materials);
}

/// The body of type B that is of this material. Throws InputError if there is none; the text begins with `caller`.
template <class B, class Bodies>
B& find_body(Bodies& bodies, const typename B::Material& material, const char* caller) {
  B* found = nullptr;
  const auto look_at = [&](auto& body) {
    if constexpr (std::is_same_v<decltype(body), B&>)
      if (same_material(body.material, material)) found = &body;
  };
  std::apply([&](auto&... body) { (look_at(body), ...); }, bodies);
  require(found, caller, " was given a material with other numbers than the solver's of its type");
  return *found;
}

/// What a tile reports of its particles after a pass.
struct TileReport {
  static constexpr std::uint32_t fine = ~std::uint32_t(0);
  double max_speed = 0;         ///< max (c + |v|), m/s
  std::uint32_t failed = fine;  ///< first particle that is no number or beyond its equation of state
  std::uint32_t windows = 0;    ///< that its gather took (passes/batch.hpp)
  std::uint32_t fresh = 0;      ///< the same when it was last sorted
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
  static_assert(N <= lanes);
  if constexpr (N == lanes) {
    transpose(components, records);
  } else {
    Pack<T> padded[lanes], rows[lanes];
    for (int c = 0; c < lanes; ++c) padded[c] = c < N ? components[c < N ? c : 0] : Pack<T>(T(0));
    transpose(padded, rows);
    for (int l = 0; l < lanes; ++l) std::memcpy(&records[l], &rows[l], sizeof(records[l]));
  }
}

}  // namespace mote::passes
