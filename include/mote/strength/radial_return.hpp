/// \file
/// Radial return: the plastic update of a von Mises metal by the backward Euler rule.
#pragma once

#include <mote/strength/hardening.hpp>

namespace mote::strength {

/// What a return to the yield surface takes from the trial state.
template <class T>
struct RadialReturn {
  T equivalent;  ///< sqrt(3/2) |trial|, Pa, above zero
  T rise;        ///< of the equivalent plastic strain
  T dissipated;  ///< J/m^3 of current volume

  /// The back stress moves by this times the trial's s - alpha, the stress by -3 G times it.
  T shift() const { return rise / equivalent; }
};

/// The return of the trial s - alpha: consistency is linear in the rise, so that it ends exactly on the yield surface.
///
/// First order on strain paths that are curved in the deviatoric plane. \param shear_modulus G, Pa, a number or of type
/// T. Source: Simo and Hughes, Computational Inelasticity (1998), boxes 3.1 and 3.2; Wilkins (1964).
template <class T, class G>
[[gnu::always_inline]] inline RadialReturn<T> radial_return(const SymTensor<T>& trial, const T& plastic_strain,
                                                            const G& shear_modulus, const LinearHardening& law) {
  using std::max;
  using std::sqrt;
  const T limit = law.yield_stress(plastic_strain);
  // the floor keeps 0/0 out of a stress-free particle
  const T equivalent = max(sqrt(T(1.5) * ddot(trial, trial)), T(1e-30));
  const T compliance = T(1 / (3 * shear_modulus + law.isotropic + law.kinematic));
  const T rise = max((equivalent - limit) * compliance, T(0));
  return {equivalent, rise, law.dissipation(limit, rise)};
}

}  // namespace mote::strength
