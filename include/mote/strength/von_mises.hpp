/// \file
/// Von Mises plasticity with linear isotropic hardening, integrated by radial return.
#pragma once

#include <mote/strength/concept.hpp>

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

  void validate() const {
    require(shear_modulus > 0, "the shear modulus is ", shear_modulus, " Pa; it must be > 0");
    require(yield > 0, "the yield stress is ", yield, " Pa; it must be > 0 (strength::Elastic has none)");
    require(hardening >= 0, "the hardening modulus is ", hardening, " Pa; it must be >= 0");
  }

  /// Returns the plastic work of the increment, J/m^3 of current volume, never negative.
  template <class V, class T>
  T update(V& values, const Kinematics<T>& k) const {
    using std::max;
    using std::sqrt;
    auto& s = get<field::DeviatoricStress>(values);
    auto& eps = get<field::PlasticStrain>(values);
    s = elastic_predictor(values, k, shear_modulus);
    const T yield_stress = T(yield) + T(hardening) * eps;
    // the floor keeps 0/0 out of a stress-free particle
    const T equivalent = max(sqrt(T(1.5) * ddot(s, s)), T(1e-30));
    const T d_eps = max((equivalent - yield_stress) * T(1 / (3 * shear_modulus + hardening)), T(0));
    s = s * (T(1) - T(3 * shear_modulus) * d_eps / equivalent);
    eps += d_eps;
    return (yield_stress + T(0.5 * hardening) * d_eps) * d_eps;
  }

  friend bool operator==(const VonMises&, const VonMises&) = default;
};

}  // namespace mote::strength
