/// \file
/// What a shock viscosity offers.
#pragma once

#include <concepts>

#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>

namespace mote {

/// v.pressure(rho, c, u)            q, Pa, >= 0, added to the pressure. u = -h D, m/s: the speed at which a cell's ends
///                                  approach each other, negative in expansion; rho: kg/m^3; c: longitudinal sound
///                                  speed, m/s
/// v.signal_speed2(rho, c2, q)      m^2/s^2, the square of the speed that the time step has to allow for
///
/// The material stores q for the next step's forces and the work it does. viscosity::None offers nothing.
template <class P, class T = double>
concept Viscosity = HasRole<P, role::Viscosity> && requires(const P& p, T x) {
  { p.pressure(x, x, x) } -> std::same_as<T>;
  { p.signal_speed2(x, x, x) } -> std::same_as<T>;
};

}  // namespace mote
