/// \file
/// Linear pressure-volume law.
#pragma once

#include <mote/eos/concept.hpp>

namespace mote::eos {

/// P = K (1 - V/V0): the small-strain limit of any equation of state, without heat.
struct LinearBulk {
  using role = mote::role::Eos;

  double rho0;          ///< reference density, kg/m^3, > 0
  double bulk_modulus;  ///< K, Pa, > 0

  void validate() const {
    require(rho0 > 0, "the density rho0 is ", rho0, " kg/m^3; it must be > 0");
    require(bulk_modulus > 0, "the bulk modulus is ", bulk_modulus, " Pa; it must be > 0");
  }

  template <class T>
  T pressure(const T& x, const T&) const {
    return T(bulk_modulus) * (T(1) - x);
  }
  /// -V^2 dP/dV, m^2/s^2.
  template <class T>
  T bulk_sound_speed2(const T& x, const T&) const {
    return T(bulk_modulus / rho0) * x * x;
  }
  /// J/kg.
  template <class T>
  T reference_energy(const T& x) const {
    return T(0.5 * bulk_modulus / rho0) * (T(1) - x) * (T(1) - x);
  }
  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  template <class T>
  T internal_energy(const T& x) const {
    return reference_energy(x);
  }
  double gamma_over_volume() const { return 0; }
  template <class T>
  auto admissible(const T& x) const {
    return x > T(0);
  }

  friend bool operator==(const LinearBulk&, const LinearBulk&) = default;
};

}  // namespace mote::eos
