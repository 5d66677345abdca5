/// \file
/// What an energy closure offers: which energy the equation of state sees above its reference curve.
#pragma once

#include <concepts>

#include <mote/core/error.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>
#include <mote/eos/concept.hpp>

namespace mote {

/// C::complete                                 whether the closure integrates the complete energy equation. Then
/// viscous
///                                             work heats, and the heat of a shock comes from work; if not, it comes
///                                             from the reference curve, and viscous work warms nothing
/// c.excess(values, eos)                       J/kg above the reference curve
/// c.bulk_sound_speed2(values, eos)            m^2/s^2, -V^2 dP/dV as the closure follows P
/// c.pressure_work(values, eos)                J/kg, what the pressure has taken up since x = 1
/// c.update(values, eos, x_old, x_new, heat)   the step's x = V/V0 before and after, and its dissipated work, J/kg
/// c.initialise(values, eos)                   optional
template <class C, class V, class E>
concept EnergyFor = HasRole<C, role::Energy> && requires(const C& c, V v, const E& e, typename V::number x) {
  { C::complete } -> std::convertible_to<bool>;
  { c.excess(v, e) } -> std::same_as<typename V::number>;
  { c.bulk_sound_speed2(v, e) } -> std::same_as<typename V::number>;
  { c.pressure_work(v, e) } -> std::same_as<typename V::number>;
  c.update(v, e, x, x, x);
};

}  // namespace mote
