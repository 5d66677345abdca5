/// \file
/// What a strength policy offers: how the deviatoric stress and its history follow the motion.
#pragma once

#include <concepts>

#include <mote/core/error.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>
#include <mote/strength/kinematics.hpp>

namespace mote {

/// A strength policy declares its history in `particle_fields` and offers
///
///   update(values, kinematics)   moves the stored state over one increment; an inelastic policy returns the work
///                                dissipated, J per m^3 of current volume, an elastic one returns nothing
///   shear_modulus                Pa, for the time step and the elastic energy; leave it out if there is none
///
/// It may offer more, where field::DeviatoricStress and shear_modulus do not say it:
///
///   stress(values)               its part of the Cauchy stress, Pa; a trace adds to the pressure
///   elastic_energy(values)       recoverable, J per m^3 of initial volume; default |s|^2/(4 G) J
///   wave_modulus(values, bulk)   rho0 c^2 of the fastest wave, Pa, where the volume alone makes `bulk` of it; default
///                                bulk + 4/3 G J
///   initialise(values)           sets fields that begin neither at zero nor at their tag's `initial`
///
/// In `update`, field::VolumeRatio is already that at the end of the increment.
///
/// `values` is Values<T, D, ...> with at least the declared fields; T is double, float or a Pack of either. A policy
/// that cannot be written for packs says `static constexpr bool scalar_only = true;` and is called lane by lane.
template <class S, class V>
concept StrengthFor = HasRole<S, role::Strength> && requires(const S& s, V v, Kinematics<typename V::number> k) {
  s.update(v, k);
};

namespace strength {

/// Rotated stress plus 2 G dev(strain), the elastic predictor that the Jaumann rate implies.
template <class V, class T>
[[gnu::always_inline]] inline SymTensor<T> elastic_predictor(const V& values, const Kinematics<T>& k,
                                                             double shear_modulus) {
  return rotate(k.rotation, get<field::DeviatoricStress>(values)) + T(2 * shear_modulus) * deviator(k.strain);
}

}  // namespace strength
}  // namespace mote
