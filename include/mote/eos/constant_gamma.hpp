/// \file
/// The Grueneisen law gamma = const for an equation of state that is written for gamma/V = const.
#pragma once

#include <mote/eos/concept.hpp>

namespace mote::eos {

/// P = P_ref(x) + (gamma0/V) (E - E_ref) with gamma0 constant, where the equation of state that it is made of has
/// gamma/V = gamma0/V0:
///
///     eos::ConstantGamma{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96}}
///
/// Its reference curve is unchanged. Source: Wilkins, Computer Simulation of Dynamic Phenomena (1999), ch. 3.
template <class Reference>
struct ConstantGamma {
  static_assert(HasConstantGamma<Reference>,
                "mote: eos::ConstantGamma is made of an equation of state with a constant gamma_over_volume()");
  using role = mote::role::Eos;

  Reference reference;
  double rho0 = reference.rho0;  ///< kg/m^3; not to be set

  void validate() const {
    if constexpr (requires { reference.validate(); }) reference.validate();
  }

  template <class T>
  T pressure(const T& x, const T& excess) const {
    return reference.pressure(x, T(0)) + T(rho0) * gamma_over_volume(x) * excess;
  }
  /// -V^2 dP/dV at fixed excess energy, m^2/s^2.
  template <class T>
  T bulk_sound_speed2(const T& x, const T& excess) const {
    return reference.bulk_sound_speed2(x, T(0)) + T(reference.gamma_over_volume()) * excess;
  }
  template <class T>
  T reference_energy(const T& x) const {
    return reference.reference_energy(x);
  }
  template <class T>
  T reference_heating(const T& x) const {
    return reference.reference_heating(x);
  }
  template <class T>
  requires(HasInternalEnergy<Reference, T>) T internal_energy(const T& x)
  const { return reference.internal_energy(x); }
  /// V0 gamma/V = gamma0/x.
  template <class T>
  T gamma_over_volume(const T& x) const {
    return T(reference.gamma_over_volume()) / x;
  }
  template <class T>
  auto admissible(const T& x) const {
    return reference.admissible(x);
  }

  friend bool operator==(const ConstantGamma&, const ConstantGamma&) = default;
};

template <class Reference>
ConstantGamma(Reference) -> ConstantGamma<Reference>;

}  // namespace mote::eos
