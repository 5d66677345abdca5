/// \file
/// What a sleep policy offers.
#pragma once

#include <concepts>

#include <mote/core/role.hpp>

namespace mote {

/// S::sleeps                                       whether any particle ever sleeps; if not, nothing else is asked for
/// s.enabled                                       the same, at run time
/// s.tolerance                                     the largest disturbance of material at rest
/// s.disturbance(material, values, v_ref, h)       of a particle (or of each of a pack) beside material that moves
///                                                 with v_ref, dimensionless: velocities over the speed of sound,
///                                                 stresses over its square and the density; h: grid spacing, m
///
/// passes/sleep.hpp says what the solver makes of it.
template <class S>
concept Sleep = HasRole<S, role::Sleep> &&(!S::sleeps || requires(const S& s) {
  { s.enabled } -> std::convertible_to<bool>;
  { s.tolerance } -> std::convertible_to<double>;
});

}  // namespace mote
