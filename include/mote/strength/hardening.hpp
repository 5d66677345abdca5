/// \file
/// Linear hardening of a von Mises metal, and what one increment of its flow amounts to.
#pragma once

#include <mote/strength/concept.hpp>

namespace mote::strength {

/// f = sqrt(3/2) |s - alpha| - (Y + H_iso eps_p) <= 0 with eps_p = int sqrt(2/3) |de_p| and
/// dalpha = (2/3) H_kin de_p (Prager's rule in Ziegler's direction: both are the same here). All in Pa.
struct LinearHardening {
  double yield;          ///< Y
  double isotropic;      ///< H_iso
  double kinematic = 0;  ///< H_kin

  /// Refuses what no metal has, each in a sentence.
  void validate(double shear_modulus) const {
    require(shear_modulus > 0, "the shear modulus is ", shear_modulus, " Pa; it must be > 0");
    require(yield > 0, "the yield stress is ", yield, " Pa; it must be > 0 (strength::Elastic has none)");
    require(isotropic >= 0, "the hardening modulus is ", isotropic, " Pa; it must be >= 0");
    require(kinematic >= 0, "the kinematic hardening modulus is ", kinematic, " Pa; it must be >= 0");
  }

  /// The yield stress in uniaxial tension, Pa, at an equivalent plastic strain.
  template <class T>
  T yield_stress(const T& plastic_strain) const {
    return T(yield) + T(isotropic) * plastic_strain;
  }

  /// What flows away as heat while eps_p grows, J/m^3: int (Y + H_iso eps_p) deps_p = int (s - alpha) : de_p.
  ///
  /// The rest of the plastic work, alpha : de_p, is stored in the back stress and comes back.
  template <class T>
  T dissipation(const T& yield_stress_before, const T& rise) const {
    return (yield_stress_before + T(0.5 * isotropic) * rise) * rise;
  }
};

/// Recoverable energy of a stress and a back stress, J/m^3 of current volume: |s|^2/(4 G) + 3 |alpha|^2/(4 H_kin).
///
/// The second part is int alpha : de_p. Without kinematic hardening there is no back stress and no second part.
template <class T>
T recoverable_energy(const SymTensor<T>& s, const SymTensor<T>& back, double shear_modulus, double kinematic) {
  const T shear = T(0.25 / shear_modulus) * ddot(s, s);
  return kinematic > 0 ? T(shear + T(0.75 / kinematic) * ddot(back, back)) : shear;
}

}  // namespace mote::strength
