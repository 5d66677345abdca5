/// \file
/// What a load offers.
#pragma once

#include <concepts>

#include <mote/core/role.hpp>
#include <mote/core/vec.hpp>

namespace mote {

/// l.acceleration(x, time)    m/s^2 at a node, called from several threads at once
template <class L, int D>
concept LoadIn = HasRole<L, role::Load> && requires(const L& load, const Vec<double, D>& x) {
  { load.acceleration(x, 0.0) } -> std::convertible_to<Vec<double, D>>;
};

}  // namespace mote
