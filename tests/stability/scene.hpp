/// \file
/// Stress tests in three dimensions: a quarter of the paper's scene, and smaller relatives of it.
#pragma once

#include "line.hpp"

namespace stability {

/// A quarter of a block on a wall, with one or two spherical cavities on its axis; lengths in um.
struct Block {
  double spacing = 1, half_width = 20, height = 50;
  double radius = 5, centre = 10;
  double second_centre = -1;  ///< of another cavity of the same radius; below 0: none
  double speed = 100;         ///< m/s
  int per_axis = 2;
  double courant = 0.4;
};

template <class S>
auto make_block(const Block& b) {
  const double um = 1e-6, w = b.half_width * um;
  const auto make = [&] {
    return Solver{grid::Cartesian<3>{.spacing = b.spacing * um},
                  typename S::Shape{},
                  typename S::Transfer{},
                  typename S::Update{},
                  timestep::Cfl{.courant = b.courant},
                  boundary::RigidWall{.side = side::z_min, .at = 0},
                  boundary::Symmetry{.side = side::x_min, .at = 0},
                  boundary::Symmetry{.side = side::x_max, .at = w},
                  boundary::Symmetry{.side = side::y_min, .at = 0},
                  boundary::Symmetry{.side = side::y_max, .at = w},
                  metal};
  };
  auto solver = std::unique_ptr<decltype(make())>(new auto(make()));
  const geometry::Box<3> box{.lower = {0, 0, 0}, .upper = {w, w, b.height * um}};
  const auto ball = [&](double z) { return geometry::Ball<3>{.centre = {0, 0, z * um}, .radius = b.radius * um}; };
  solver->fill(box - ball(b.centre) - ball(b.second_centre < 0 ? b.centre : b.second_centre), metal,
               {.per_axis = b.per_axis, .velocity = {0, 0, b.speed}, .method = geometry::Method::fraction});
  return solver;
}

/// An extreme pressure, and the particle that has it.
struct Place {
  double pressure = 0;  ///< Pa
  Vec<double, 3> at{};  ///< m
  double mass = 0;      ///< over that of a whole particle
  double volume_ratio = 1;
  double energy = 0;    ///< plastic work, J/kg
  double velocity = 0;  ///< along z, m/s
  std::uint32_t id = 0;
};

struct Extremes {
  Place low, high;
  int above = 0, below = 0;  ///< particles above +0.3 GPa and below -1.5 GPa
  int broken = 0;            ///< particles whose pressure is no finite number
};

template <class Solver>
Extremes extremes(const Solver& solver, int per_axis) {
  Extremes out;
  const auto& p = solver.particles();
  const double whole = 2700 * std::pow(solver.spacing() / per_axis, 3);
  bool first = true;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<double, 3, typename std::remove_cvref_t<decltype(p)>::list> v;
    p.load(i, v);
    const double x = metal.pressure(v);
    out.above += x > 0.3e9, out.below += x < -1.5e9, out.broken += !std::isfinite(x);
    const Place here{x,
                     get<field::Position>(v),
                     get<field::Mass>(v) / whole,
                     get<field::VolumeRatio>(v),
                     get<field::PlasticWork>(v),
                     get<field::Velocity>(v)[2],
                     p.template column<field::Id>()[i]};
    if (first || x < out.low.pressure) out.low = here;
    if (first || x > out.high.pressure) out.high = here;
    first = false;
  }
  return out;
}

/// Pressures of a layer of particles on the wall or above it, within `radius` of the axis.
struct Layer {
  Span pressure;  ///< Pa
  double mean = 0, scatter = 0;
};

/// Layer n: particles that were filled at heights from n to n + 1 particle distances, found by their numbers.
template <class Solver>
std::vector<Layer> layers(const Solver& solver, int per_axis, std::size_t count, double radius, double half_width) {
  std::vector<Layer> out(count);
  std::vector<double> n(count), squares(count);
  const auto& p = solver.particles();
  const auto per_layer = std::size_t(std::lround(std::pow(half_width / solver.spacing() * per_axis, 2)));
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t layer = p.template column<field::Id>()[i] / per_layer;
    const auto x = p.template get<field::Position>(i);
    if (layer >= count || std::hypot(x[0], x[1]) > radius) continue;
    Values<double, 3, typename std::remove_cvref_t<decltype(p)>::list> v;
    p.load(i, v);
    const double pressure = metal.pressure(v);
    out[layer].pressure.add(pressure);
    out[layer].mean += pressure, squares[layer] += pressure * pressure, n[layer] += 1;
  }
  for (std::size_t k = 0; k < count; ++k) {
    out[k].mean /= n[k];
    out[k].scatter = std::sqrt(std::max(0.0, squares[k] / n[k] - out[k].mean * out[k].mean));
  }
  return out;
}

/// The node whose velocity the forces of the last step changed most.
struct Kick {
  double velocity = 0;  ///< change, m/s
  double mass = 0;      ///< over that of a whole node, of h^3
  double height = 0;    ///< z, m
};

template <class Solver>
Kick largest_kick(const Solver& solver) {
  Kick out;
  const auto& nodes = solver.nodes();
  const double whole = 2700 * std::pow(solver.spacing(), 3);
  constexpr int width = grid::node_width<3>;
  for (std::size_t n = 0; n < nodes.mass.size(); ++n) {
    if (!(nodes.mass[n] > 0)) continue;
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a)
      square += std::pow(nodes.velocity[width * n + a] - nodes.previous[width * n + a], 2);
    if (std::sqrt(square) > out.velocity)
      out = {std::sqrt(square), nodes.mass[n] / whole, solver.frame().node_position(2, nodes.coordinates(n)[2])};
  }
  return out;
}

}  // namespace stability
