/// \file
/// Adiabatic heating along the reference curve and by plastic work.
#pragma once

#include <mote/heat/concept.hpp>

namespace mote::heat {

/// dT = [h(x)/cv - (V0 gamma/V) T] dx + dW_p/cv, where h is the equation of state's reference heating (the shock's own
/// heat; zero in tension, so that the metal cools as it stretches). Needs field::Temperature. With energy::Full there
/// is no h, and viscous work heats like plastic work.
///
/// The step is the mid-point rule for h and the trapezoidal rule for T: second order, and T stays positive.
/// Source: Xu et al., temperature equation; with its sign of dV.
struct Adiabatic {
  using role = mote::role::Heat;
  using particle_fields = fields<field::Temperature>;

  double specific_heat;              ///< cv, J/(kg K), > 0
  double initial_temperature = 300;  ///< K, > 0

  void validate() const {
    require(specific_heat > 0, "the specific heat is ", specific_heat, " J/(kg K); it must be > 0");
    require(initial_temperature > 0, "the initial temperature is ", initial_temperature, " K; it must be > 0");
  }

  template <class V>
  void initialise(V& values) const {
    get<field::Temperature>(values) = typename V::number(initial_temperature);
  }

  template <class V, class E, class T>
  void update(V& values, const E& eos, const T& x_old, const T& x_new, const T& work) const {
    T& t = get<field::Temperature>(values);
    const T dx = x_new - x_old, middle = T(0.5) * (x_old + x_new);
    const T half = T(0.5) * gamma_over_volume(eos, middle) * dx;
    const T heat = eos.reference_heating(middle) * dx + work;
    t = (t * (T(1) - half) + heat * T(1 / specific_heat)) / (T(1) + half);
  }

  friend bool operator==(const Adiabatic&, const Adiabatic&) = default;
};

}  // namespace mote::heat
