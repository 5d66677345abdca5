/// \file
/// Von Mises plasticity with linear isotropic hardening, integrated by radial return.
#pragma once

#include <mote/strength/radial_return.hpp>

namespace mote::strength {

/// f = sqrt(3/2) |s| - (Y + H eps_p) <= 0, associative flow, eps_p = int sqrt(2/3) |de_p|.
///
/// Radial return on the Jaumann predictor ends exactly on the yield surface; it is first order on curved strain paths.
/// Needs field::DeviatoricStress and field::PlasticStrain.
/// Source: Simo and Hughes, Computational Inelasticity (1998), box 3.1; Wilkins (1964).
struct VonMises {
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
    s = elastic_predictor(values, k, shear_modulus);
    const auto flow = radial_return(s, eps, shear_modulus, law());
    s = s * (T(1) - T(3 * shear_modulus) * flow.rise / flow.equivalent);
    eps += flow.rise;
    return flow.dissipated;
  }

  friend bool operator==(const VonMises&, const VonMises&) = default;
};

}  // namespace mote::strength
