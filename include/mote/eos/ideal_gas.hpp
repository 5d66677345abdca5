/// \file
/// Ideal gas with constant heat capacities.
#pragma once

#include <cmath>

#include <mote/eos/concept.hpp>

namespace mote::eos {

/// P = (gamma - 1) rho E, written on the isentrope through V0: P_ref = P0 x^-gamma, E_ref = P_ref V/(gamma - 1).
///
/// With energy::Plastic it stays on that isentrope; shocks need energy::Full. At x = 1 it presses with P0, so a free
/// surface is no vacuum-tight lid: the gas expands there.
struct IdealGas {
  using role = mote::role::Eos;

  double rho0;              ///< initial density, kg/m^3, > 0
  double gamma;             ///< ratio of the heat capacities, > 1
  double initial_pressure;  ///< P0, Pa, > 0

  void validate() const {
    require(rho0 > 0, "the density rho0 is ", rho0, " kg/m^3; it must be > 0");
    require(gamma > 1, "the ratio of the heat capacities gamma is ", gamma, "; it must be > 1");
    require(initial_pressure > 0, "the initial pressure is ", initial_pressure, " Pa; it must be > 0");
  }

  template <class T>
  T pressure(const T& x, const T& excess) const {
    return T(rho0) * gamma_over_volume(x) * (internal_energy(x) + excess);
  }
  /// -V^2 dP/dV at fixed excess energy, m^2/s^2.
  template <class T>
  T bulk_sound_speed2(const T& x, const T& excess) const {
    return T(gamma - 1) * (T(gamma) * internal_energy(x) + excess);
  }
  /// J/kg.
  template <class T>
  T reference_energy(const T& x) const {
    return internal_energy(x) - T(initial_energy());
  }
  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  /// On the isentrope, J/kg.
  template <class T>
  T internal_energy(const T& x) const {
    using std::pow;
    return T(initial_energy()) * pow(x, Scalar<T>(1 - gamma));
  }
  template <class T>
  T gamma_over_volume(const T& x) const {
    return T(gamma - 1) / x;
  }
  template <class T>
  auto admissible(const T& x) const {
    return x > T(0);
  }

  friend bool operator==(const IdealGas&, const IdealGas&) = default;

 private:
  double initial_energy() const { return initial_pressure / (rho0 * (gamma - 1)); }
};

}  // namespace mote::eos
