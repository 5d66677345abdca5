/// \file
/// Conduction of heat on the grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <mote/passes/batch.hpp>
#include <mote/passes/grid_update.hpp>
#include <mote/passes/images.hpp>
#include <mote/passes/scatter.hpp>

namespace mote::passes {

/// Whether a material's heat policy has what conduction needs.
template <class M>
concept Conducts = requires(const M& m) {
  { m.heat.conductivity } -> std::convertible_to<double>;
  { m.heat.specific_heat } -> std::convertible_to<double>;
  { m.heat.every } -> std::convertible_to<int>;
};

/// A node field of one number, copied to the tile's box, and what a batch gathers of it.
template <class T, int D, class Shape>
struct NodeScalar {
  alignas(64) T value[NodeBox<D>::capacity(Shape::support)];

  NodeScalar(const AlignedVector<T>& field, const Tile<D>& tile, const std::vector<Link<D>>& links,
             const NodeBox<D>& box) {
    for (std::uint32_t k = tile.links_begin; k < tile.links_end; ++k) {
      const T* block = field.data() + std::size_t(links[k].block) * grid::block_nodes<D>;
      for_each_row(links[k], box, [&](int in_box, int in_block, auto count) {
        std::copy_n(block + in_block, int(count), value + in_box);
      });
    }
  }

  /// The sum w f and the slopes sum (dw/dxi) f are component 0 of `sums`.
  template <Wanted W>
  [[gnu::always_inline]] void gather(SumColumns<W, T, D>& sums, const NodeBox<D>& box,
                                     const BatchNodes<Shape, T, D>& at) const {
    IVec<D> stride;
    for (int a = 0; a < D; ++a) stride[a] = box.stride[std::size_t(a)];
    at.for_each_window([&](int i, int node, const auto& stencil, unsigned bits, bool) __attribute__((always_inline)) {
      sums.template put<true>(i, 0, contract<W, 0>(value + node, stride, stencil), bits);
    });
  }
};

/// Heat capacity C_i = sum w m cv and heat sum w m cv T of one tile; nothing of a body that does not conduct.
template <class Shape, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] void scatter_heat(const B& body, const Tile<D>& tile, const Frame<T, D>& frame,
                                                  T* accumulators) {
  constexpr int width = 2;
  const NodeBox<D> box(tile, Shape::support);
  T* nodes = accumulators + tile.buffer * width;
  std::fill_n(nodes, box.size * width, T(0));
  if constexpr (Conducts<typename B::Material>) {
    const TileFrame<T, D> in_tile = frame.of_block(tile.block);
    const T specific_heat = T(body.material.heat.specific_heat);
    for_each_pack(tile, [&](std::size_t first, int n) {
      Values<Pack<T>, D, union_of<fields<field::Position, field::Mass, field::Temperature>, particle_fields_of<Shape>>>
          p;
      body.particles.load(first, n, p);
      Pack<T> value[width], axis[D][width];
      value[0] = specific_heat * get<field::Mass>(p);
      value[1] = value[0] * get<field::Temperature>(p);
      scatter_pack<Shape, AxisWeights::none>(nodes, box, in_tile.in_cells(get<field::Position>(p)), n, value, axis,
                                             half_sizes<Shape>(p, in_tile.per_spacing));
    });
  }
}

/// Heat per second into the nodes, -sum V k grad T . grad w, and sum w m cv (T_p - sum w T_i) of one tile.
template <class Shape, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] void scatter_flux(const B& body, const Tile<D>& tile, const std::vector<Link<D>>& links,
                                                  const AlignedVector<T>& temperature, const Frame<T, D>& frame,
                                                  T* accumulators) {
  constexpr int width = 2;
  constexpr Wanted wanted{true, false};
  const NodeBox<D> box(tile, Shape::support);
  T* nodes = accumulators + tile.buffer * width;
  std::fill_n(nodes, box.size * width, T(0));
  if constexpr (Conducts<typename B::Material>) {
    const NodeScalar<T, D, Shape> from(temperature, tile, links, box);
    SumColumns<wanted, T, D> sums;
    const T scale = T(-body.material.heat.conductivity / (body.material.rho0() * frame.spacing * frame.spacing));
    const T specific_heat = T(body.material.heat.specific_heat);
    for_each_gathered_pack<Shape>(
        body, tile, frame, box, [&](const auto& at) { from.gather(sums, box, at); },
        [&](std::size_t first, int n, int i, const auto& in_tile) {
          Values<Pack<T>, D,
                 union_of<fields<field::Position, field::Mass, field::VolumeRatio, field::Temperature>,
                          particle_fields_of<Shape>>>
              p;
          body.particles.load(first, n, p);
          Pack<T> value[width], axis[D][width];
          value[0] = Pack<T>(T(0));
          value[1] = specific_heat * get<field::Mass>(p) * (get<field::Temperature>(p) - sums.value(i, 0));
          for (int a = 0; a < D; ++a) {
            axis[a][0] = scale * get<field::Mass>(p) * get<field::VolumeRatio>(p) * sums.slope(i, 0, a);
            axis[a][1] = Pack<T>(T(0));
          }
          scatter_pack<Shape, AxisWeights::slope>(nodes, box, in_tile.in_cells(get<field::Position>(p)), n, value, axis,
                                                  half_sizes<Shape>(p, in_tile.per_spacing));
        });
  }
}

/// T_p <- (1 - relaxed) T_p + sum w g_i.
template <class Shape, class B, class T, int D>
[[gnu::flatten, gnu::noinline]] void gather_heat(B& body, const Tile<D>& tile, const std::vector<Link<D>>& links,
                                                 const AlignedVector<T>& gain, const Frame<T, D>& frame,
                                                 double relaxed) {
  constexpr Wanted wanted{false, false};
  if constexpr (Conducts<typename B::Material>) {
    const NodeBox<D> box(tile, Shape::support);
    const NodeScalar<T, D, Shape> from(gain, tile, links, box);
    SumColumns<wanted, T, D> sums;
    for_each_gathered_pack<Shape>(
        body, tile, frame, box, [&](const auto& at) { from.gather(sums, box, at); },
        [&](std::size_t first, int n, int i, const auto&) {
          Values<Pack<T>, D, fields<field::Temperature>> p;
          body.particles.load(first, n, p);
          get<field::Temperature>(p) = T(1 - relaxed) * get<field::Temperature>(p) + sums.value(i, 0);
          body.particles.store(first, n, p, fields<field::Temperature>{});
        });
  }
}

/// Nothing is conducted, and nothing is stored.
template <class T, int D, bool any>
class Conduction {
 public:
  template <class... Materials>
  Conduction(double, int, const std::tuple<Materials...>&) {}
};

/// Explicit conduction of heat, in rounds of three sweeps over the particles:
///
///     C_i = sum_p w_ip m cv,   T_i = sum_p w_ip m cv T_p / C_i,
///     Q_i = -sum_p V_p k (grad T)_p . grad w_ip,   r_i = sum_p w_ip m cv (T_p - sum_j w_jp T_j) / C_i,
///     T_p <- (1 - b) T_p + sum_i w_ip (dt Q_i/C_i + b (T_i + r_i)),   b = dt/limit.
///
/// Without b this is the weak form of rho cv dT/dt = div(k grad T) with a lumped capacity, of which the particles
/// gather the change, as with FLIP. Where no particle is, nothing flows: a free surface is insulated. At a mirror plane
/// the temperature is even: a node and its images share capacity and heat, so nothing flows through. The heat sum m cv
/// T_p changes by dt sum Q_i, which vanishes since the kernels' gradients add up to nothing.
///
/// What nodes cannot see of the particles' temperatures, a contact of hot and cold or noise, would stay for ever. With
/// M T the means of a field seen from the particles, T_p - sum_i w_ip (T_i + r_i) is (1 - M)^2 T: all of what nodes do
/// not see, (k h/2)^4 of a smooth mode, and no heat. It decays at the rate 1/limit, slower than such short waves
/// should. M is the idea of XPIC(2) (Hammerquist, Nairn, CMAME 318 (2017) 724). Source of the rest: Nairn, Guilkey,
/// IJNME 101 (2015) 759.
///
/// The limit is h^2/(2 d alpha), and half of it for linear hats. With B-splines a round takes at most 1.00 times a
/// mode, and would be stable up to 2: for any place and size of the particles, since particles feel a node of hardly
/// any mass, whose own limit is nil, by as small weights. With linear hats it takes up to 1.2 if particles are equally
/// large, but far more where a sliver of a particle sits on a node at the surface: give those whole particles
/// (Method::lattice). Measured in tests/unit/passes/conduction.cpp.
template <class T, int D>
class Conduction<T, D, true> {
  double limit_ = std::numeric_limits<double>::infinity();  // s
  int every_ = 0;                                           // steps; 0: as the limit allows
  double pending_ = 0;                                      // time since it last conducted, s
  int steps_ = 0;                                           // the same
  AlignedVector<T> capacity_, temperature_, gain_;          // of nodes: J/K, K, K
  Orbits<D> orbits_;                                        // in mirrors, which walls are for heat, too

 public:
  template <class... Materials>
  Conduction(double spacing, int support, const std::tuple<Materials...>& materials) {
    const double safety = support == 2 ? 0.5 : 1;
    const auto ask = [&](const auto& m) {
      if constexpr (Conducts<std::remove_cvref_t<decltype(m)>>) {
        const double alpha = m.heat.conductivity / (m.rho0() * m.heat.specific_heat);
        limit_ = std::min(limit_, safety * spacing * spacing / (2 * D * alpha));
        if (m.heat.every > 0) every_ = every_ > 0 ? std::min(every_, int(m.heat.every)) : int(m.heat.every);
      }
    };
    std::apply([&](const auto&... m) { (ask(m), ...); }, materials);
  }

  /// The blocks have changed.
  void allocate(const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain, int support) {
    for (auto* field : {&capacity_, &temperature_, &gain_}) {
      reserve_amply(*field, blocks.nodes());
      field->resize(blocks.nodes());
    }
    orbits_.find(blocks, domain, support, 0);
  }

  /// A step of length dt begins. \return the time to conduct for, s, or 0
  double due(double dt) {
    pending_ += dt;
    ++steps_;
    if (!(limit_ < std::numeric_limits<double>::infinity())) return 0;
    if (every_ > 0 ? steps_ < every_ : pending_ + dt <= limit_) return 0;
    steps_ = 0;
    return std::exchange(pending_, 0);
  }

  /// Conducts for the time dt. `for_each_tile(f)` calls f(body, tile) for the tiles of all bodies.
  template <class Shape, class ForEachTile, class Executor>
  void conduct(double dt, const ForEachTile& for_each_tile, const Executor& executor, const Tiling<D>& tiling,
               const grid::Blocks<T, D>& blocks, const Frame<T, D>& frame, T* accumulators) {
    const double rounds = std::max(1.0, std::ceil(dt / limit_ - 1e-9)), relaxed = std::min(1.0, dt / (rounds * limit_));
    const auto on_grid = [&](auto&& block, auto&& orbit) {
      executor.for_each(blocks.index.size(), [&](std::size_t b) { block(std::uint32_t(b)); });
      executor.for_each(orbits_.blocks(), [&](std::size_t i) { for_each_orbit(i, orbit); });
    };
    for (double round = 0; round < rounds; ++round) {
      for_each_tile([&](auto& body, const Tile<D>& tile) { scatter_heat<Shape>(body, tile, frame, accumulators); });
      on_grid([&](std::uint32_t b) { set_temperature(b, tiling, accumulators, Shape::support); },
              [&](const Images<D>& images) { share_temperature(images); });
      for_each_tile([&](auto& body, const Tile<D>& tile) {
        scatter_flux<Shape>(body, tile, tiling.links, temperature_, frame, accumulators);
      });
      on_grid([&](std::uint32_t b) { set_gain(b, tiling, accumulators, Shape::support, dt / rounds, relaxed); },
              [&](const Images<D>& images) { share_gain(images, relaxed); });
      for_each_tile([&](auto& body, const Tile<D>& tile) {
        gather_heat<Shape>(body, tile, tiling.links, gain_, frame, relaxed);
      });
    }
  }

 private:
  void set_temperature(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support) {
    for_each_sum(block, tiling, accumulators, support, [&](std::size_t node, const T* record) {
      capacity_[node] = solid(record[0]);
      temperature_[node] = capacity_[node] > T(0) ? record[1] / capacity_[node] : T(0);
    });
  }
  void set_gain(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support, double dt,
                double relaxed) {
    for_each_sum(block, tiling, accumulators, support, [&](std::size_t node, const T* record) {
      const T change = T(dt) * record[0] + T(relaxed) * record[1];
      gain_[node] = capacity_[node] > T(0) ? change / capacity_[node] + T(relaxed) * temperature_[node] : T(0);
    });
  }
  template <class F>
  static void for_each_sum(std::uint32_t block, const Tiling<D>& tiling, const T* accumulators, int support,
                           const F& f) {
    constexpr int width = 2, nodes = grid::block_nodes<D>;
    alignas(64) T sums[nodes * width] = {};
    sum_tiles<width>(block, tiling, accumulators, support, sums);
    for (int i = 0; i < nodes; ++i) f(std::size_t(block) * nodes + std::size_t(i), sums + i * width);
  }

  /// Calls f(images) for the nodes of a block near planes that have images beyond them.
  template <class F>
  void for_each_orbit(std::size_t plane_block, const F& f) const {
    Images<D> images;
    for (const Orbit<D>& orbit : orbits_.of_block(plane_block)) {
      images.take(orbits_, orbit, capacity_);
      if (images.count > 1) f(images);
    }
  }
  /// From here on each image has the capacity of all.
  void share_temperature(const Images<D>& images) {
    T capacity = 0, heat = 0;
    for (int k = 0; k < images.count; ++k) {
      const std::size_t node = images.image[std::size_t(k)].node;
      capacity += capacity_[node];
      heat += capacity_[node] * temperature_[node];
    }
    for (int k = 0; k < images.count; ++k) {
      const std::size_t node = images.image[std::size_t(k)].node;
      capacity_[node] = capacity;
      temperature_[node] = capacity > T(0) ? heat / capacity : T(0);
    }
  }
  void share_gain(const Images<D>& images, double relaxed) {
    const T kept = T(relaxed) * temperature_[images.image[0].node];  // the same for all
    T gain = kept;
    for (int k = 0; k < images.count; ++k) gain += gain_[images.image[std::size_t(k)].node] - kept;
    for (int k = 0; k < images.count; ++k) gain_[images.image[std::size_t(k)].node] = gain;
  }
};

}  // namespace mote::passes
