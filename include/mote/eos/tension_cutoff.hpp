/// \file
/// A limit on the tension that an equation of state can bear.
#pragma once

#include <mote/eos/concept.hpp>

namespace mote::eos {

/// What eos::TensionCutoff needs to know.
struct Tension {
  double limit;  ///< Pa, > 0: the pressure never falls below its negative
};

/// P = max(P_eos, -limit), the spall strength of a metal in its simplest form:
///
///     eos::TensionCutoff{eos::MieGruneisen{...}, {.limit = 1.2e9}}
///
/// Only the pressure is limited, the deviatoric stress is not. Nothing is dissipated and nothing remembered: the work
/// done in pulling at the limit counts as elastic, comes back at the same pressure when the material closes, and what
/// has closed is whole again. Real spall dissipates; that needs a strength with a damage of its own.
///
/// While it pulls at the limit, dP/dV is zero. The speed of sound is that of the state in which the limit was reached,
/// since the next step may find the material closed; what is added to the volume is void, which neither stiffens nor
/// cools it. reference_energy() takes the limit to be reached on the reference curve, without the pressure of heat.
template <class Reference>
class TensionCutoff {
 public:
  using role = mote::role::Eos;

  Reference reference;
  double limit;     ///< Pa
  double rho0;      ///< kg/m^3
  double opens_at;  ///< x at which the reference curve reaches the limit

  /// Throws InputError if the equation of state does not pull with the limit up to x = 10.
  TensionCutoff(const Reference& eos, const Tension& tension)
      : reference(eos), limit(tension.limit), rho0(eos.rho0), opens_at(1) {
    require(limit > 0, "the limit of tension is ", limit, " Pa; it must be > 0");
    if constexpr (requires { eos.validate(); }) eos.validate();
    const auto holds = [&](double x) { return reference.pressure(x, 0.0) > -limit; };
    double whole = 1, open = 10;
    require(holds(whole) && !holds(open), "the limit of tension is ", limit,
            " Pa; the equation of state must reach it between V/V0 = 1 and 10, and has the pressure ",
            reference.pressure(open, 0.0), " Pa at 10");
    for (double middle; middle = 0.5 * (whole + open), middle != whole && middle != open;)
      (holds(middle) ? whole : open) = middle;
    opens_at = open;
  }

  template <class T>
  T pressure(const T& x, const T& excess) const {
    using std::max;
    return max(T(reference.pressure(x, excess)), T(-limit));
  }
  template <class T>
  T bulk_sound_speed2(const T& x, const T& excess) const {
    return of_whole(x, excess, [&](const T& y, const T& e) { return reference.bulk_sound_speed2(y, e); });
  }
  template <class T>
  T isentropic_sound_speed2(const T& x, const T& excess) const {
    return of_whole(x, excess, [&](const T& y, const T& e) { return mote::isentropic_sound_speed2(reference, y, e); });
  }
  /// Work of the pressure from x = 1, J/kg.
  template <class T>
  T reference_energy(const T& x) const {
    using std::max, std::min;
    return reference.reference_energy(T(min(x, T(opens_at)))) + T(limit / rho0) * max(T(x - T(opens_at)), T(0));
  }
  template <class T>
  T reference_heating(const T& x) const {
    return reference.reference_heating(x);
  }
  template <class T>
  requires(HasInternalEnergy<Reference, T>) T internal_energy(const T& x)
  const { return reference.internal_energy(x); }
  /// Zero where the reference curve is cut.
  template <class T>
  T gamma_over_volume(const T& x) const {
    return select(x > T(opens_at), T(0), mote::gamma_over_volume(reference, x));
  }
  template <class T>
  auto admissible(const T& x) const {
    return reference.admissible(x);
  }

  friend bool operator==(const TensionCutoff&, const TensionCutoff&) = default;

 private:
  /// f of the state, or of that in which it opened.
  template <class T, class F>
  T of_whole(const T& x, const T& excess, const F& f) const {
    const auto open = reference.pressure(x, excess) < T(-limit);
    return f(select(open, T(opens_at), x), select(open, T(0), excess));
  }
};

}  // namespace mote::eos
