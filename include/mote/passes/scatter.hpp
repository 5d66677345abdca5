/// \file
/// Particles to grid.
#pragma once

#include <mote/passes/body.hpp>
#include <mote/passes/stencil.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::passes {

/// Coefficients of a pack of particles, transposed to one record per particle.
template <class T, int D>
struct Coefficients {
  static constexpr int width = 2 * grid::node_width<D>;
  alignas(64) T value[lanes][width];
  alignas(64) T axis[D][lanes][width];
};

/// Mass and momentum of a pack: value = [m, m v | 0], axis a = [0, m h C_a | 0] with the columns of an affine matrix.
template <class Transfer, class T, int D, class V>
void momentum_records(const V& p, double spacing, Pack<T> (&value)[2 * grid::node_width<D>],
                      Pack<T> (&axis)[D][2 * grid::node_width<D>]) {
  for (auto& c : value) c = T(0);
  for (auto& a : axis)
    for (auto& c : a) c = T(0);
  const Pack<T> m = get<field::Mass>(p);
  value[0] = m;
  for (int i = 0; i < D; ++i) value[1 + i] = m * get<field::Velocity>(p)[i];
  if constexpr (Transfer::affine) {
    const Pack<T> mh = m * T(spacing);
    for (int a = 0; a < D; ++a)
      for (int i = 0; i < D; ++i) axis[a][1 + i] = mh * get<field::Affine>(p)(i, a);
  }
}

/// Adds the records of a pack's n particles to the nodes of the tile's box; without Axes, their values only.
template <bool Axes, Halves H, class T, int D, class Shape>
void scatter_pack(T* nodes, const NodeBox<D>& box, const Stencil<T, D, Shape>& stencil, int n,
                  const Pack<T> (&value)[2 * grid::node_width<D>], const Pack<T> (&axis)[D][2 * grid::node_width<D>]) {
  using Record = typename Stencil<T, D, Shape>::Record;
  Coefficients<T, D> c;
  to_records(value, c.value);
  if constexpr (Axes)
    for (int a = 0; a < D; ++a) to_records(axis[a], c.axis[a]);
  for (int l = 0; l < n; ++l) {
    Record along[D];
    if constexpr (Axes)
      for (int a = 0; a < D; ++a) along[a] = read<Record>(c.axis[a][l]);
    else
      for (auto& none : along) none = Record(0);
    scatter<Axes, H>(nodes, box, stencil, l, read<Record>(c.value[l]), along);
  }
}

/// m_i = sum w m, p_i = sum w m (v + C (x_i - x_p)), f_i = -sum V sigma grad w for one tile.
///
/// Records of the tile's nodes: [m, p | f].
///
/// Flattened, like the other passes over tiles: a pack that is handed over in memory costs more than what is done to
/// it.
template <class Shape, class Transfer, class B, class T, int D>
[[gnu::flatten]] void scatter_tile(const B& body, const Tile<D>& tile, const Frame<T, D>& frame, T* accumulators) {
  constexpr int width = 2 * grid::node_width<D>;
  constexpr auto halves = Transfer::affine ? Halves::moment_slope : Halves::slope_slope;
  const NodeBox<D> box(tile, Shape::support);
  T* nodes = accumulators + tile.buffer * width;
  std::fill_n(nodes, box.size * width, T(0));
  for_each_pack(tile, [&](std::size_t first, int n) {
    using List = union_of<fields<field::Position, field::Velocity, field::Mass>, particle_fields_of<Transfer>,
                          particle_fields_of<typename B::Material>>;
    Values<Pack<T>, D, List> p;
    body.particles.load(first, n, p);
    Stencil<T, D, Shape> stencil;
    stencil.template set<true, Transfer::affine>(frame.in_cells(get<field::Position>(p), tile.block), box);
    Pack<T> value[width], axis[D][width];
    momentum_records<Transfer, T, D>(p, frame.spacing, value, axis);
    const SymTensor<Pack<T>> stress = body.material.stress(p);
    const Pack<T> volume_over_h =
        get<field::Mass>(p) * get<field::VolumeRatio>(p) * T(-1 / (body.material.rho0() * frame.spacing));
    for (int a = 0; a < D; ++a)
      for (int i = 0; i < D; ++i) axis[a][grid::node_width<D> + i] = volume_over_h * stress(i, a);
    scatter_pack<true, halves>(nodes, box, stencil, n, value, axis);
  });
}

}  // namespace mote::passes
