/// \file
/// Von Mises plasticity with linear isotropic hardening, integrated by the exponential map.
#pragma once

#include <mote/strength/exponential_map.hpp>

namespace mote::strength {

/// The metal of strength::VonMises; the exponential map is second order on curved strain paths and, without hardening,
/// exact on straight increments, for some exponentials and a logarithm per particle that flows.
///
/// Jaumann rate. Needs field::DeviatoricStress and field::PlasticStrain.
/// Source: Auricchio and Beirao da Veiga, IJNME 56 (2003) 1375.
struct VonMisesExponential {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::PlasticStrain>;

  double shear_modulus;  ///< G, Pa, > 0
  double yield;          ///< Y, initial yield stress in uniaxial tension, Pa, > 0
  double hardening = 0;  ///< H, d(yield stress)/d(eps_p), Pa, >= 0

  LinearHardening law() const { return {yield, hardening}; }
  void validate() const { law().validate(shear_modulus); }

  /// Returns the plastic work of the increment, J/m^3 of current volume, never negative.
  template <class V, class T>
  T update(V& values, const Kinematics<T>& k) const {
    auto& s = get<field::DeviatoricStress>(values);
    auto& eps = get<field::PlasticStrain>(values);
    const auto flow = exponential_map(rotate(k.rotation, s), deviator(k.strain), eps, shear_modulus, law());
    s = flow.relative;
    eps += flow.rise;
    return flow.dissipated;
  }

  friend bool operator==(const VonMisesExponential&, const VonMisesExponential&) = default;
};

}  // namespace mote::strength
