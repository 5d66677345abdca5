/// \file
/// What an equation of state offers. Everything is a function of x = V/V0 = J and of `excess`, the specific energy
/// above the reference curve, J/kg; T may be a number or a pack.
#pragma once

#include <concepts>

#include <mote/core/error.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>

namespace mote {

/// E::rho0                             reference density, kg/m^3
/// E::pressure(x, excess)              Pa, positive in compression
/// E::bulk_sound_speed2(x, excess)     m^2/s^2, -V^2 dP/dV at fixed excess
/// E::reference_energy(x)              J/kg, the work done along the reference curve from x = 1
/// E::admissible(x)                    whether the equation covers x
/// E::gamma_over_volume()              V0 gamma/V, dimensionless; zero where heat does not press
/// E::reference_heating(x)             J/kg per unit of x: heat that the reference curve itself produces
template <class E, class T = double>
concept Eos = HasRole<E, role::Eos> && requires(const E& e, T x) {
  { e.rho0 } -> std::convertible_to<double>;
  { e.pressure(x, x) } -> std::same_as<T>;
  { e.bulk_sound_speed2(x, x) } -> std::same_as<T>;
  { e.reference_energy(x) } -> std::same_as<T>;
  { e.reference_heating(x) } -> std::same_as<T>;
  { e.gamma_over_volume() } -> std::convertible_to<double>;
  e.admissible(x);
};

}  // namespace mote
