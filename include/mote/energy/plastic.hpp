/// \file
/// The energy closure of the paper: plastic work presses, nothing else.
#pragma once

#include <mote/energy/concept.hpp>

namespace mote::energy {

/// E - E_H = W_p, the specific plastic work; a material that does not flow stays on the reference curve.
///
/// On the shock Hugoniot that curve already holds the heat of the shock, so viscous work (viscosity::VonNeumann) goes
/// to the ledger and neither presses nor warms. Slow compression follows the Hugoniot too, which is a third order
/// effect in the compression. What the pressure of heat does, gamma/V W_p dV, is in no energy of the ledger.
/// Stores nothing. Source: Xu, Zhang, Ying, Yu, energy equation.
struct Plastic {
  using role = mote::role::Energy;
  static constexpr bool complete = false;

  template <class V, class E>
  static typename V::number excess(const V& values, const E&) {
    if constexpr (carries<V, field::PlasticWork>)
      return get<field::PlasticWork>(values);
    else
      return typename V::number(0);
  }
  /// -V^2 dP/dV at fixed W_p, m^2/s^2.
  template <class V, class E>
  static typename V::number bulk_sound_speed2(const V& values, const E& eos) {
    return eos.bulk_sound_speed2(get<field::VolumeRatio>(values), excess(values, eos));
  }
  /// Along the reference curve, J/kg.
  template <class V, class E>
  static typename V::number pressure_work(const V& values, const E& eos) {
    return eos.reference_energy(get<field::VolumeRatio>(values));
  }
  template <class V, class E, class T>
  static void update(V&, const E&, const T&, const T&, const T&) {}

  friend bool operator==(const Plastic&, const Plastic&) = default;
};

}  // namespace mote::energy
