/// \file
/// Shock viscosity of von Neumann, Richtmyer and Landshoff.
#pragma once

#include <cmath>

#include <mote/core/error.hpp>
#include <mote/viscosity/concept.hpp>

namespace mote::viscosity {

/// q = rho (A1 c h |D| + A2 h^2 D^2) in compression, D = tr L < 0, else zero; h is the grid spacing.
///
/// It spreads a shock over a few cells and dissipates what the jump has to dissipate, so that nothing rings. The
/// quadratic term acts in shocks only; the linear one damps the ringing behind them, and sound waves too.
///
/// The time step: a wave of one cell is damped with the ratio z = A1 + A2 h |D|/c, and an explicit step that takes q
/// from the velocity of its beginning is stable up to that of the speed c (z + sqrt(1 + z^2)). timestep::Cfl uses this
/// speed, with the linear part always counted: 1.22 c for A1 = 0.2 before a shock comes.
/// Source: von Neumann and Richtmyer, J. Appl. Phys. 21 (1950) 232; Landshoff, LA-1930 (1955); the time step:
/// Belytschko, Liu, Moran, Nonlinear Finite Elements for Continua and Structures (2000), ch. 6.
struct VonNeumann {
  using role = mote::role::Viscosity;

  double linear = 0.2;   ///< A1, >= 0
  double quadratic = 2;  ///< A2, >= 0

  void validate() const {
    require(linear >= 0 && linear < 1e6, "the linear viscosity is ", linear, "; it must be >= 0 and < 1e6");
    require(quadratic >= 0 && quadratic < 1e12, "the quadratic viscosity is ", quadratic,
            "; it must be >= 0 and < 1e12");
  }

  /// q, Pa. \param u -h D, m/s
  template <class T>
  T pressure(const T& rho, const T& c, const T& u) const {
    using std::max;
    const T closing = max(u, T(0));
    return rho * closing * (T(linear) * c + T(quadratic) * closing);
  }

  /// (c (z + sqrt(1 + z^2)))^2, m^2/s^2, with z from q: z^2 - A1 z = A2 q/(rho c^2).
  template <class T>
  T signal_speed2(const T& rho, const T& c2, const T& q) const {
    using std::sqrt;
    // multiplied by c: no division by a sound speed of zero
    const T a = T(0.5 * linear), zc = a * sqrt(c2) + sqrt(a * a * c2 + T(quadratic) * q / rho);
    const T speed = zc + sqrt(c2 + zc * zc);
    return speed * speed;
  }

  friend bool operator==(const VonNeumann&, const VonNeumann&) = default;
};

}  // namespace mote::viscosity
