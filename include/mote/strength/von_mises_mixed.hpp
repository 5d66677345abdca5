/// \file
/// Von Mises plasticity with isotropic and kinematic hardening, integrated by radial return.
#pragma once

#include <mote/strength/radial_return.hpp>

namespace mote::strength {

/// f = sqrt(3/2) |s - alpha| - (Y + H_iso eps_p) <= 0, associative flow, dalpha = (2/3) H_kin de_p, eps_p =
/// int sqrt(2/3) |de_p|; in uniaxial tension the stress rises by H_iso + H_kin per plastic strain.
///
/// Stress and back stress follow the Jaumann rate. Radial return ends exactly on the yield surface; it is first order
/// on curved strain paths. Needs field::DeviatoricStress, field::BackStress and field::PlasticStrain. Source: Simo and
/// Hughes, Computational Inelasticity (1998), box 3.2.
struct VonMisesMixed {
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
    s = elastic_predictor(values, k, shear_modulus);
    back = rotate(k.rotation, back);
    const SymTensor<T> trial = s - back;
    const auto flow = radial_return(trial, eps, shear_modulus, law());
    const SymTensor<T> shift = trial * flow.shift();
    s = s - T(3 * shear_modulus) * shift;
    back += T(kinematic_hardening) * shift;
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

  friend bool operator==(const VonMisesMixed&, const VonMisesMixed&) = default;
};

}  // namespace mote::strength
