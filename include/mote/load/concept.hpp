/// \file
/// What a load offers.
#pragma once

#include <concepts>
#include <tuple>

#include <mote/core/role.hpp>
#include <mote/core/vec.hpp>

namespace mote {

/// A load on the volume, or one on the surface.
///
/// l.acceleration(x, time)    m/s^2 at a node, called from several threads at once
template <class L, int D>
concept LoadIn = HasRole<L, role::Load> && requires(const L& load, const Vec<double, D>& x) {
  { load.acceleration(x, 0.0) } -> std::convertible_to<Vec<double, D>>;
};

/// l.side, l.where(x)         which faces carry it: those of a side, of particles filled at x
/// l.traction(x, time)        Pa at a particle, called from one thread
template <class L, int D>
concept SurfaceLoadIn = HasRole<L, role::Load> && requires(const L& load, const Vec<double, D>& x) {
  { load.traction(x, 0.0) } -> std::convertible_to<Vec<double, D>>;
  { load.where(x) } -> std::convertible_to<bool>;
  { load.side } -> std::convertible_to<Side>;
};

/// Whether any of a tuple of loads acts on the volume.
template <class Loads, int D>
inline constexpr bool any_body_load = false;
template <class... L, int D>
inline constexpr bool any_body_load<std::tuple<L...>, D> = (LoadIn<L, D> || ...);

}  // namespace mote
