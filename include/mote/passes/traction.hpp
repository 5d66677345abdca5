/// \file
/// Forces on particles that carry a part of the surface, added to the nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <mote/geometry/seeds.hpp>
#include <mote/load/concept.hpp>
#include <mote/passes/grid_update.hpp>

namespace mote {

namespace field {

/// Area of the particle's surface that the solver's load number I pulls at, m^2 (m in two dimensions, 1 in one).
template <int I>
struct LoadedArea {
  static_assert(I < 10, "mote: a traction must be among the first ten loads");
  using shape = shape_of::Scalar;
  static constexpr char text[] = {'l', 'o', 'a', 'd', 'e', 'd', '_', 'a', 'r', 'e', 'a', '_', char('0' + I), '\0'};
  static constexpr const char *name = text, *unit = "m^2";
};

}  // namespace field

namespace passes {

namespace detail {

template <class Loads, int D, class Numbers>
struct SurfaceFields;
template <class... L, int D, int... I>
struct SurfaceFields<std::tuple<L...>, D, std::integer_sequence<int, I...>> {
  using type = union_of<fields<>, std::conditional_t<SurfaceLoadIn<L, D>, fields<field::LoadedArea<I>>, fields<>>...>;
};

}  // namespace detail

/// A column for each of the loads that acts on surfaces.
template <class Loads, int D>
using surface_fields =
    typename detail::SurfaceFields<Loads, D, std::make_integer_sequence<int, std::tuple_size_v<Loads>>>::type;

/// Calls f(load, tag) for the loads that act on surfaces.
template <int D, class Loads, class F>
void for_each_surface_load(const Loads& loads, const F& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) {
    const auto call = [&](const auto& load, auto tag) {
      if constexpr (SurfaceLoadIn<std::remove_cvref_t<decltype(load)>, D>) f(load, tag);
    };
    (call(std::get<std::size_t(I)>(loads), field::LoadedArea<I>{}), ...);
  }
  (std::make_integer_sequence<int, std::tuple_size_v<Loads>>{});
}

/// The sites of a lattice that particles of one fill took.
template <class T, int D>
class Taken {
  const geometry::Lattice<D> lattice_;
  std::vector<std::array<std::int64_t, D>> sites_;

 public:
  template <class P>
  Taken(const geometry::Lattice<D>& lattice, const P& particles, std::size_t first) : lattice_(lattice) {
    for (std::size_t p = first; p < particles.size(); ++p)
      sites_.push_back(site(cast<double>(particles.template get<field::Position>(p))));
    std::sort(sites_.begin(), sites_.end());
  }

  /// Whether the particle at x has no neighbour on a side, and the domain goes on there.
  bool open(const Vec<double, D>& x, Side side, const grid::Domain<D>& domain) const {
    auto at = site(x);
    at[std::size_t(side.axis)] += side.upper ? 1 : -1;
    const double centre =
        lattice_.origin[side.axis] + (double(at[std::size_t(side.axis)]) + 0.5) * lattice_.site_size();
    return domain.contains(side.axis, centre) && !std::binary_search(sites_.begin(), sites_.end(), at);
  }
  double area() const { return std::pow(lattice_.site_size(), D - 1); }

 private:
  std::array<std::int64_t, D> site(const Vec<double, D>& x) const {
    std::array<std::int64_t, D> at{};
    for (int a = 0; a < D; ++a)
      at[std::size_t(a)] = std::int64_t(std::floor((x[a] - lattice_.origin[a]) / lattice_.site_size()));
    return at;
  }
};

/// Gives the particles from `first` on, which fill a lattice, the areas that the loads pull at.
template <class B, class Loads, int D>
void mark_surfaces(B& body, std::size_t first, const Loads& loads, const geometry::Lattice<D>& lattice,
                   const grid::Domain<D>& domain) {
  using T = typename B::number;
  const Taken<T, D> taken(lattice, body.particles, first);
  for_each_surface_load<D>(loads, [&]<class Tag>(const auto& load, Tag) {
    auto area = body.particles.template column<Tag>();
    for (std::size_t p = first; p < body.particles.size(); ++p) {
      const auto x = cast<double>(body.particles.template get<field::Position>(p));
      if (load.where(x) && taken.open(x, load.side, domain)) area[p] = T(taken.area());
    }
  });
}

/// No load acts on a surface, and nothing is stored.
template <class Loads, int D, bool = (surface_fields<Loads, D>::size > 0)>
class Surface {};

/// The particles that carry loaded faces, and the force that they bring to the nodes. One thread does it, in the order
/// of the particles: they are few.
template <class Loads, int D>
class Surface<Loads, D, true> {
  std::vector<std::vector<std::uint32_t>> loaded_;  // by body
  std::vector<Vec<double, D>> force_;               // by node, N; zero but in between
  std::vector<std::size_t> touched_;                // nodes

 public:
  void clear(std::size_t nodes) {
    loaded_.clear();
    force_.assign(nodes, {});
  }
  /// Looks for the loaded particles of the next body.
  template <class B>
  void find(const B& body, const Loads& loads) {
    auto& list = loaded_.emplace_back();
    for (std::size_t p = 0; p < body.particles.size(); ++p) {
      bool any = false;
      for_each_surface_load<D>(
          loads, [&]<class Tag>(const auto&, Tag) { any |= body.particles.template column<Tag>()[p] != 0; });
      if (any) list.push_back(std::uint32_t(p));
    }
  }

  /// Adds the forces of a body's particles, f_i += w_ip sum A t(x_p, time).
  template <class Shape, class B, class T>
  void add(std::size_t number, const B& body, const Loads& loads, const grid::Domain<D>& domain,
           const grid::Blocks<T, D>& blocks, const Frame<T, D>& frame, double time) {
    for (const std::uint32_t p : loaded_[number]) {
      const auto x = cast<double>(body.particles.template get<field::Position>(p));
      Vec<double, D> force{};
      for_each_surface_load<D>(loads, [&]<class Tag>(const auto& load, Tag) {
        if (const double area = double(body.particles.template column<Tag>()[p]); area != 0)
          force += area * Vec<double, D>(load.traction(x, time));
      });
      spread<Shape>(x, force, domain, blocks, frame);
    }
  }

  /// Velocities of the nodes after these forces; their work, with that of loads on the volume at the same time.
  template <class T>
  GridLedger<D> push(grid::Blocks<T, D>& blocks, const Frame<T, D>& frame, const Loads& loads, double time, double dt) {
    GridLedger<D> ledger;
    for (const std::size_t node : touched_) {
      const double m = double(blocks.mass[node]);
      const Vec<double, D> gain = (dt / m) * force_[node];
      const auto old = cast<double>(node_vector<T, D>(blocks.previous.data(), node)),
                 v = cast<double>(node_vector<T, D>(blocks.velocity.data(), node));
      Vec<double, D> of_volume{};
      if constexpr (any_body_load<Loads, D>)
        of_volume = cast<double>(load_gain<T, D>(blocks.coordinates(node), frame, loads, time, dt));
      ledger.load_work += 0.5 * m * (dot(gain, old + v + gain) + dot(gain, of_volume));
      ledger.work += m * dot(gain, v + 0.5 * gain);
      set_node_vector(blocks.velocity.data(), node, cast<T>(v + gain));
      force_[node] = {};
    }
    touched_.clear();
    return ledger;
  }

 private:
  template <class Shape, class T>
  void spread(const Vec<double, D>& x, const Vec<double, D>& force, const grid::Domain<D>& domain,
              const grid::Blocks<T, D>& blocks, const Frame<T, D>& frame) {
    static_assert(!sized<Shape>, "mote: a traction acts through a kernel of one size; take another than GIMP with it");
    constexpr int n = Shape::support, nodes = D == 1 ? n : D == 2 ? n * n : n * n * n;
    std::int32_t base[D];
    double w[D][n];
    for (int a = 0; a < D; ++a) {
      const double xi = (x[a] - frame.origin[a]) / frame.spacing;
      base[a] = std::int32_t(std::floor(xi - Shape::first));
      Shape::values(xi - base[a], w[a]);
    }
    double left = 1;  // what a node of no mass cannot take goes to the others
    std::size_t at[nodes];
    double weight[nodes];
    for (int i = 0; i < nodes; ++i) {
      IVec<D> node{};
      weight[i] = 1;
      for (int a = 0, rest = i; a < D; ++a, rest /= n) {
        node[a] = domain.wrapped(a, base[a] + rest % n);
        weight[i] *= w[a][rest % n];
      }
      at[i] = blocks.find(node);
      if (at[i] == blocks.none || !(blocks.mass[at[i]] > T(0))) left -= std::exchange(weight[i], 0);
    }
    for (int i = 0; i < nodes; ++i) {
      if (weight[i] == 0) continue;
      if (force_[at[i]] == Vec<double, D>{}) touched_.push_back(at[i]);
      force_[at[i]] += (weight[i] / left) * force;
    }
  }
};

}  // namespace passes

}  // namespace mote
