/// \file
/// The complete energy equation.
#pragma once

#include <mote/energy/concept.hpp>

namespace mote::energy {

/// dE = -P dV + dW_p + dW_q: E is the specific internal energy without the elastic shear energy, stored in
/// field::InternalEnergy; W_p and W_q are plastic and viscous work. Needs an equation of state with internal_energy(x).
///
/// The step takes the mean of the pressures before and after, which is second order, and which balances a step of the
/// solver: with the stress of its beginning and the velocity of its end it does, summed over steps, the work of that
/// mean. The new pressure depends on the new energy; one Newton step from P(x, E without it) is exact for a P that is
/// linear in E, as Mie-Grueneisen's is.
///
/// Energy that the transfers lose (observe::transfer_loss) does not come back as heat: to land on the Hugoniot, a shock
/// must be stopped by viscosity::VonNeumann, and the transfer must not damp it (transfer::Flip).
struct Full {
  using role = mote::role::Energy;
  using particle_fields = fields<field::InternalEnergy>;
  static constexpr bool complete = true;

  template <class V, class E>
  static void initialise(V& values, const E& eos) {
    using T = typename V::number;
    get<field::InternalEnergy>(values) = eos.internal_energy(T(1));
  }
  template <class V, class E>
  static typename V::number excess(const V& values, const E& eos) {
    return get<field::InternalEnergy>(values) - eos.internal_energy(get<field::VolumeRatio>(values));
  }
  /// -V^2 dP/dV at fixed entropy, m^2/s^2.
  template <class V, class E>
  static typename V::number bulk_sound_speed2(const V& values, const E& eos) {
    return isentropic_sound_speed2(eos, get<field::VolumeRatio>(values), excess(values, eos));
  }
  /// E less its initial value and what was dissipated, J/kg.
  template <class V, class E>
  static typename V::number pressure_work(const V& values, const E& eos) {
    using T = typename V::number;
    T e = get<field::InternalEnergy>(values) - eos.internal_energy(T(1));
    if constexpr (carries<V, field::PlasticWork>) e -= get<field::PlasticWork>(values);
    if constexpr (carries<V, field::ViscousWork>) e -= get<field::ViscousWork>(values);
    return e;
  }
  template <class V, class E, class T>
  static void update(V& values, const E& eos, const T& x_old, const T& x_new, const T& heat) {
    T& e = get<field::InternalEnergy>(values);
    const T dx = x_new - x_old, half_dv = T(0.5 / eos.rho0) * dx;
    const T known = e + heat - half_dv * eos.pressure(x_old, T(e - eos.internal_energy(x_old)));
    const T above = known - eos.internal_energy(x_new);
    const T guess = eos.pressure(x_new, above) / (T(1) + T(0.5) * gamma_over_volume(eos, x_new) * dx);
    e = known - half_dv * eos.pressure(x_new, T(above - half_dv * guess));
  }

  friend bool operator==(const Full&, const Full&) = default;
};

}  // namespace mote::energy
