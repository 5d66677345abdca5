/// \file
/// Particles to grid.
#pragma once

#include <mote/passes/body.hpp>
#include <mote/passes/stencil.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::passes {

/// What the particles of a pack bring to their nodes: component i of the momentum at number i * n of a record, n fields
/// in turns.
template <class T, int D, int n>
struct Records {
  static constexpr int width = n * grid::node_width<D>;
  Pack<T> value[width], axis[D][width];

  Records() {
    for (auto& c : value) c = T(0);
    for (auto& a : axis)
      for (auto& c : a) c = T(0);
  }
  template <class Transfer, class V>
  void add_momentum(const V& p, double spacing) {
    const Pack<T> m = get<field::Mass>(p);
    for (int i = 0; i < D; ++i) value[n * i] = m * get<field::Velocity>(p)[i];
    if constexpr (Transfer::affine) {
      const Pack<T> mh = m * T(spacing);
      for (int a = 0; a < D; ++a)
        for (int i = 0; i < D; ++i) axis[a][n * i] = mh * get<field::Affine>(p)(i, a);
    }
  }
};

/// [p_x p_y p_z 0].
template <class T, int D>
using Momentum = Records<T, D, 1>;

/// [p_x f_x p_y f_y p_z f_z m 0].
template <class T, int D>
struct MomentumAndForce : Records<T, D, 2> {
  /// The mass, and -V sigma/h, which takes the slope weights.
  template <class M, class V>
  void add_mass_and_force(const M& material, const V& p, double spacing) {
    const Pack<T> m = get<field::Mass>(p);
    this->value[2 * D] = m;
    const SymTensor<Pack<T>> stress = material.stress(p);
    const Pack<T> volume_over_h = m * get<field::VolumeRatio>(p) * T(-1 / (material.rho0() * spacing));
    for (int a = 0; a < D; ++a)
      for (int i = 0; i < D; ++i) this->axis[a][2 * i + 1] = volume_over_h * stress(i, a);
  }
};

/// Adds the records of a pack's n particles to the nodes of the tile's box.
/// \param xi positions in cells, relative to the first node of the tile's block
template <class Shape, AxisWeights Kind, class T, int D, int width>
[[gnu::always_inline]] inline void scatter_pack(T* nodes, const NodeBox<D>& box, const Vec<Pack<T>, D>& xi, int n,
                                                const Pack<T> (&value)[width], const Pack<T> (&axis)[D][width],
                                                const HalfSizes<Shape, T, D>& half = no_half_sizes<Shape, T, D>()) {
  using Record = Simd<T, width>;
  const LowestNodes<Shape, T, D> at(xi, box);
  Stencil<T, D, Shape> stencil;
  for (int a = 0; a < D; ++a) stencil.set(a, xi[a] - at.base[a], half);
  const ScatterWeights<Kind, T, D, Shape> weights(stencil);
  Contribution<Record, D> of[lanes];
  {
    Record records[lanes];
    to_records(value, records);
    for (int l = 0; l < lanes; ++l) of[l].value = records[l];
    if constexpr (Kind != AxisWeights::none)
      for (int a = 0; a < D; ++a) {
        to_records(axis[a], records);
        for (int l = 0; l < lanes; ++l) of[l].axis[a] = records[l];
      }
  }
  for (int first = 0, last; first < n; first = last) {
    for (last = first + 1; last < n && at.node[last] == at.node[first];) ++last;
    Scatter<Kind, Record, T, D, Shape>(weights, of, first, last)(nodes + std::ptrdiff_t(at.node[first]) * width, box);
  }
}

/// m_i = sum w m and p_i = sum w m (v + C (x_i - x_p)) alone for one tile: [p_x p_y p_z m], in the room of a Momentum.
template <class Shape, class Transfer, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] void scatter_momentum_of_tile(const B& body, const Tile<D>& tile,
                                                              const Frame<T, D>& frame, T* accumulators) {
  constexpr int width = Momentum<T, D>::width;
  static_assert(width > D);
  const NodeBox<D> box(tile, Shape::support);
  T* nodes = accumulators + tile.buffer * width;
  std::fill_n(nodes, box.size * width, T(0));
  const TileFrame<T, D> in_tile = frame.of_block(tile.block);
  const double spacing = frame.spacing;
  for_each_pack(tile, [&](std::size_t first, int n) {
    Values<Pack<T>, D, union_of<fields<field::Position, field::Velocity, field::Mass>, particle_fields_of<Shape>,
                                particle_fields_of<Transfer>>>
        p;
    body.particles.load(first, n, p);
    Momentum<T, D> brought;
    brought.template add_momentum<Transfer>(p, spacing);
    brought.value[D] = get<field::Mass>(p);
    scatter_pack<Shape, Transfer::affine ? AxisWeights::moment : AxisWeights::none>(
        nodes, box, in_tile.in_cells(get<field::Position>(p)), n, brought.value, brought.axis,
        half_sizes<Shape>(p, in_tile.per_spacing));
  });
}

/// m_i = sum w m, p_i = sum w m (v + C (x_i - x_p)), f_i = -sum V sigma grad w for one tile.
///
/// Flattened, like the other passes over tiles: a pack that is handed over in memory costs more than what is done to
/// it. And one function for all executors: copies that are inlined into each may fuse other multiplications with
/// additions, and then differ in the last bit.
template <class Shape, class Transfer, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] void scatter_tile(const B& body, const Tile<D>& tile, const Frame<T, D>& frame,
                                                  T* accumulators) {
  constexpr int width = MomentumAndForce<T, D>::width;
  constexpr auto kind = Transfer::affine ? AxisWeights::moment_slope : AxisWeights::slope;
  const NodeBox<D> box(tile, Shape::support);
  T* nodes = accumulators + tile.buffer * width;
  std::fill_n(nodes, box.size * width, T(0));
  // copies, which stores to columns cannot change: what depends on them alone is computed once
  const auto material = body.material;
  const TileFrame<T, D> in_tile = frame.of_block(tile.block);
  const double spacing = frame.spacing;
  for_each_pack(tile, [&](std::size_t first, int n) {
    using List = union_of<fields<field::Position, field::Velocity, field::Mass>, particle_fields_of<Shape>,
                          particle_fields_of<Transfer>, particle_fields_of<typename B::Material>>;
    Values<Pack<T>, D, List> p;
    body.particles.load(first, n, p);
    MomentumAndForce<T, D> brought;
    brought.template add_momentum<Transfer>(p, spacing);
    brought.add_mass_and_force(material, p, spacing);
    scatter_pack<Shape, kind>(nodes, box, in_tile.in_cells(get<field::Position>(p)), n, brought.value, brought.axis,
                              half_sizes<Shape>(p, in_tile.per_spacing));
  });
}

}  // namespace mote::passes
