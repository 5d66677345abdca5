/// \file
/// The domain's edges on the grid: periodic axes and mirror planes in node coordinates.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <mote/boundary/concept.hpp>
#include <mote/core/time_function.hpp>

namespace mote::grid {

namespace detail {
inline char axis_name(int a) { return "xyz"[a]; }
inline std::string side_name(Side s) { return std::string(1, axis_name(s.axis)) + (s.upper ? "_max" : "_min"); }
}  // namespace detail

/// Where a mirror plane lies and how it maps components.
template <int D>
struct Plane {
  std::int32_t node;
  std::array<bool, D> odd;  ///< per component: changes sign in the mirror
  bool body_beyond;         ///< the mirrored body exists
  int part;                 ///< number among the solver's boundaries, for the ledger of impulses
};

/// The edges of the domain, built once from the boundary parts; refuses what does not fit the grid.
template <int D>
class Domain {
 public:
  struct Periodic {
    std::int32_t from, count;  ///< first node, nodes per period
  };
  /// A plane that moves, and the grid with it.
  struct Mover {
    Side side;
    TimeFunction velocity;  ///< m/s
  };

  template <class Boundaries>
  Domain(double spacing, const Vec<double, D>& origin, const Boundaries& boundaries)
      : spacing_(spacing), origin_(origin) {
    int part = 0;
    std::apply([&](const auto&... b) { (add(b, part), ...); }, boundaries);
    for (int a = 0; a < D; ++a) {
      require(!(periodic_[a] && (planes_[a][0] || planes_[a][1])), "axis ", detail::axis_name(a),
              " is periodic and has a plane too; it takes one or the other");
      if (planes_[a][0] && planes_[a][1])
        require(planes_[a][0]->node < planes_[a][1]->node, "the planes of axis ", detail::axis_name(a),
                " leave no room between them");
    }
    if (mover_) check_mover();
  }

  const std::optional<Periodic>& periodic(int axis) const { return periodic_[axis]; }
  /// The plane at the lower (0) or upper (1) end of an axis.
  const std::optional<Plane<D>>& plane(int axis, int end) const { return planes_[axis][end]; }

  const std::optional<Mover>& mover() const { return mover_; }
  /// The grid has moved along an axis, and the planes with it. \param origin new place of node 0, m
  void move(int axis, double origin) { origin_[axis] = origin; }

  /// The node on which a node falls when periods are taken out.
  std::int32_t wrapped(int axis, std::int32_t node) const {
    if (!periodic_[axis]) return node;
    const auto [from, count] = *periodic_[axis];
    const std::int32_t r = (node - from) % count;
    return from + (r < 0 ? r + count : r);
  }
  /// x, moved by whole periods into [from, to).
  double wrapped_position(int axis, double x) const {
    if (!periodic_[axis]) return x;
    const double period = periodic_[axis]->count * spacing_, from = lower(axis);
    const double moved = x - period * std::floor((x - from) / period);
    return moved < from + period ? moved : from;
  }
  /// Whether x lies between the planes of an axis, or in the period.
  bool contains(int axis, double x) const {
    const double xi = (x - origin_[axis]) / spacing_, slack = 1e-9;
    if (periodic_[axis] &&
        (xi < periodic_[axis]->from - slack || xi > periodic_[axis]->from + periodic_[axis]->count + slack))
      return false;
    return !(planes_[axis][0] && xi < planes_[axis][0]->node - slack) &&
           !(planes_[axis][1] && xi > planes_[axis][1]->node + slack);
  }
  double lower(int axis) const { return origin_[axis] + spacing_ * periodic_[axis]->from; }
  double period(int axis) const { return periodic_[axis] ? periodic_[axis]->count * spacing_ : 0; }

 private:
  /// \param part the boundary's number; counts those that are there
  template <class B>
  void add(const B& b, int& part) {
    if constexpr (PeriodicPair<B>)
      add_periodic(b);
    else
      add_plane(b, part);
    ++part;
  }
  template <class B>
  void add(const std::optional<B>& b, int& part) {
    if (b) add(*b, part);
  }

  template <class B>
  void add_periodic(const B& b) {
    check_axis(b.axis);
    require(!periodic_[b.axis], "axis ", detail::axis_name(b.axis), " has two periodic boundaries; it takes one");
    const auto from = node(b.axis, b.from, "the periodic boundary"), to = node(b.axis, b.to, "the periodic boundary");
    require(to > from, "a periodic boundary goes from ", b.from, " to ", b.to, " m; `to` must lie above `from`");
    periodic_[b.axis] = Periodic{from, to - from};
  }

  template <class B>
  void add_plane(const B& b, int part) {
    check_axis(b.side.axis);
    auto& plane = planes_[b.side.axis][b.side.upper];
    require(!plane, "side ", detail::side_name(b.side), " has two boundaries; it takes one");
    plane = Plane<D>{node(b.side.axis, b.at, "the plane " + detail::side_name(b.side)), {}, B::body_beyond, part};
    for (int c = 0; c < D; ++c) plane->odd[std::size_t(c)] = B::odd(c, b.side.axis);
    if constexpr (MovingPlane<B>) {
      require(!mover_, "the boundaries have two pistons; the grid follows one");
      mover_ = Mover{b.side, b.velocity};
    }
  }

  /// The grid follows one plane, so that others must not mind.
  void check_mover() const {
    const auto [axis, upper] = mover_->side;
    require(!planes_[axis][upper ? 0 : 1], "axis ", detail::axis_name(axis),
            " has a piston and another plane; the grid goes with the piston, so the other end must be free");
    for (int a = 0; a < D; ++a)
      for (const auto& plane : planes_[a])
        require(a == axis || !plane || !plane->odd[std::size_t(axis)], "a plane of axis ", detail::axis_name(a),
                " holds the body that the piston of axis ", detail::axis_name(axis),
                " moves along it; take boundary::Symmetry beside a piston");
  }

  static void check_axis(int a) {
    require(a >= 0 && a < D, "a boundary names axis ", a, "; the grid has axes 0 to ", D - 1);
  }

  /// Edges lie on nodes: a mirror elsewhere would need another kernel.
  std::int32_t node(int axis, double x, const std::string& what) const {
    const double xi = (x - origin_[axis]) / spacing_;
    const double nearest = std::round(xi);
    require(std::abs(xi - nearest) < 1e-6 && std::abs(nearest) < 2e9, what, " lies at ", x,
            " m; it must lie on a grid node, e.g. at ", origin_[axis] + nearest * spacing_, " m (grid spacing ",
            spacing_, " m)");
    return std::int32_t(nearest);
  }

  double spacing_;
  Vec<double, D> origin_;
  std::array<std::optional<Periodic>, std::size_t(D)> periodic_;
  std::array<std::array<std::optional<Plane<D>>, 2>, D> planes_;
  std::optional<Mover> mover_;
};

}  // namespace mote::grid
