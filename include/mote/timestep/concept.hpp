/// \file
/// What a time step policy offers.
#pragma once

#include <concepts>

#include <mote/core/role.hpp>

namespace mote {

/// t(spacing, max_speed)    s, from the grid spacing, m, and the largest c + |v| of all particles, m/s
template <class P>
concept Timestep = HasRole<P, role::Timestep> && requires(const P& p) {
  { p(1.0, 1.0) } -> std::convertible_to<double>;
};

}  // namespace mote
