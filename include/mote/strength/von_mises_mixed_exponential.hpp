/// \file
/// Von Mises plasticity with isotropic and kinematic hardening, integrated by the exponential map.
#pragma once

#include <mote/strength/exponential_map.hpp>

namespace mote::strength {

/// The metal of strength::VonMisesMixed; the exponential map is second order on curved strain paths.
///
/// Jaumann rate for stress and back stress. Needs field::DeviatoricStress, field::BackStress and field::PlasticStrain.
/// Source: Auricchio and Beirao da Veiga, IJNME 56 (2003) 1375.
struct VonMisesMixedExponential {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::BackStress, field::PlasticStrain, field::VolumeRatio>;

  double shear_modulus;            ///< G, Pa, > 0
  double yield;                    ///< Y, initial yield stress in uniaxial tension, Pa, > 0
  double hardening = 0;            ///< H_iso, Pa, >= 0
  double kinematic_hardening = 0;  ///< H_kin, Pa, >= 0

  LinearHardening law() const { return {yield, hardening, kinematic_hardening}; }
  void validate() const { law().validate(shear_modulus); }

  /// Returns the dissipated work (s - alpha) : de_p, J/m^3 of current volume, never negative.
  template <class V, class T>
  T update(V& values, const Kinematics<T>& k) const {
    auto& s = get<field::DeviatoricStress>(values);
    auto& back = get<field::BackStress>(values);
    auto& eps = get<field::PlasticStrain>(values);
    back = rotate(k.rotation, back);
    const auto flow = exponential_map(rotate(k.rotation, s) - back, deviator(k.strain), eps, shear_modulus, law());
    back += T(2.0 / 3 * kinematic_hardening) * flow.plastic_strain;
    s = flow.relative + back;
    eps += flow.rise;
    return flow.dissipated;
  }

  /// Of shear and back stress, J/m^3 of initial volume.
  template <class V>
  auto elastic_energy(const V& values) const {
    return recoverable_energy(get<field::DeviatoricStress>(values), get<field::BackStress>(values), shear_modulus,
                              kinematic_hardening) *
           get<field::VolumeRatio>(values);
  }

  friend bool operator==(const VonMisesMixedExponential&, const VonMisesMixedExponential&) = default;
};

}  // namespace mote::strength
