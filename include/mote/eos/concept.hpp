/// \file
/// What an equation of state offers. Everything is a function of x = V/V0 = J and of `excess`, the specific energy
/// above the reference curve, J/kg; T may be a number or a pack.
#pragma once

#include <concepts>

#include <mote/core/error.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>

namespace mote {

template <class E>
concept HasConstantGamma = requires(const E& e) {
  { e.gamma_over_volume() } -> std::convertible_to<double>;
};
template <class E, class T>
concept HasGamma = requires(const E& e, T x) {
  { e.gamma_over_volume(x) } -> std::same_as<T>;
};

template <class E, class T = double>
concept HasInternalEnergy = requires(const E& e, T x) {
  { e.internal_energy(x) } -> std::same_as<T>;
};

/// E::rho0                             reference density, kg/m^3
/// E::pressure(x, excess)              Pa, positive in compression
/// E::bulk_sound_speed2(x, excess)     m^2/s^2, -V^2 dP/dV at fixed excess
/// E::reference_energy(x)              J/kg, the work done along the reference curve from x = 1
/// E::admissible(x)                    whether the equation covers x
/// E::gamma_over_volume()              V0 gamma/V, dimensionless; zero where heat does not press
///   or E::gamma_over_volume(x)        where that is not constant
/// E::reference_heating(x)             J/kg per unit of x: heat that the reference curve itself produces
/// E::internal_energy(x)               J/kg, on the reference curve; asked for by energy::Full only. Its derivative is
///                                     reference_heating(x) - P/rho0
template <class E, class T = double>
concept Eos = HasRole<E, role::Eos> &&(HasConstantGamma<E> || HasGamma<E, T>)&&requires(const E& e, T x) {
  { e.rho0 } -> std::convertible_to<double>;
  { e.pressure(x, x) } -> std::same_as<T>;
  { e.bulk_sound_speed2(x, x) } -> std::same_as<T>;
  { e.reference_energy(x) } -> std::same_as<T>;
  { e.reference_heating(x) } -> std::same_as<T>;
  e.admissible(x);
};

/// V0 gamma/V, whichever way the equation of state states it.
template <class E, class T>
T gamma_over_volume(const E& eos, const T& x) {
  if constexpr (HasGamma<E, T>)
    return eos.gamma_over_volume(x);
  else
    return T(eos.gamma_over_volume());
}

/// -V^2 dP/dV at fixed entropy, m^2/s^2: V^2 [-P'(V) at fixed excess + (gamma/V) (P + E_ref')], where P + E_ref' comes
/// from the excess energy and from the heat of the reference curve. An equation of state of which P is not linear in
/// the energy states its own isentropic_sound_speed2(x, excess).
template <class E, class T>
T isentropic_sound_speed2(const E& eos, const T& x, const T& excess) {
  if constexpr (requires { eos.isentropic_sound_speed2(x, excess); }) {
    return eos.isentropic_sound_speed2(x, excess);
  } else {
    const T gamma = gamma_over_volume(eos, x);
    return eos.bulk_sound_speed2(x, excess) + x * x * gamma * (gamma * excess + eos.reference_heating(x));
  }
}

}  // namespace mote
