/// \file
/// Pressure of an energy quadratic in the logarithm of the volume.
#pragma once

#include <mote/eos/concept.hpp>

namespace mote::eos {

/// P = -K ln(x)/x with x = V/V0, of the energy K/2 (ln x)^2 per initial volume; without heat.
///
/// Beside strength::NeoHookean K is Lame's lambda and may be zero; beside strength::VonMisesLogarithmic it completes
/// Hencky's solid, and K is the bulk modulus. The pressure is stable up to x = e; beyond it the bulk sound speed
/// squared is negative.
struct LogarithmicBulk {
  using role = mote::role::Eos;

  double rho0;              ///< reference density, kg/m^3, > 0
  double bulk_modulus = 0;  ///< K, Pa, >= 0

  void validate() const {
    require(rho0 > 0, "the density rho0 is ", rho0, " kg/m^3; it must be > 0");
    require(bulk_modulus >= 0, "the bulk modulus is ", bulk_modulus, " Pa; it must be >= 0");
  }

  template <class T>
  T pressure(const T& x, const T&) const {
    using std::log;
    if (bulk_modulus == 0) return T(0);
    return T(-bulk_modulus) * log(x) / x;
  }
  /// -V^2 dP/dV, m^2/s^2.
  template <class T>
  T bulk_sound_speed2(const T& x, const T&) const {
    using std::log;
    if (bulk_modulus == 0) return T(0);
    return T(bulk_modulus / rho0) * (T(1) - log(x));
  }
  /// J/kg.
  template <class T>
  T reference_energy(const T& x) const {
    using std::log;
    if (bulk_modulus == 0) return T(0);
    const T l = log(x);
    return T(0.5 * bulk_modulus / rho0) * l * l;
  }
  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  double gamma_over_volume() const { return 0; }
  template <class T>
  auto admissible(const T& x) const {
    return x > T(0);
  }

  friend bool operator==(const LogarithmicBulk&, const LogarithmicBulk&) = default;
};

}  // namespace mote::eos
