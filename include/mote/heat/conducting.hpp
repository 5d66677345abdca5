/// \file
/// Adiabatic heating, and conduction between particles on the grid.
#pragma once

#include <mote/heat/adiabatic.hpp>

namespace mote::heat {

/// heat::Adiabatic, and rho cv dT/dt = div(k grad T) besides. Needs field::Temperature.
///
/// Free surfaces, walls and symmetry planes are insulated; periodic ends are not. Bodies that conduct share one nodal
/// temperature where they touch; to a body without heat::Conducting no heat flows. passes/conduction.hpp says how.
///
/// The grid conducts once per `every` steps, for those gone by and the one that begins, so temperatures lag by up to
/// `every` - 1 steps' conduction, at the end of a run too. 0 takes as many as stay within the explicit limit
/// h^2/(2 d alpha), alpha = k/(rho0 cv), half of it with linear hats (aluminium, h = 1 um, three dimensions: 26 steps,
/// or 13); where the steps asked for are longer than that, the grid conducts in several rounds. Of several bodies the
/// most demanding one decides. With linear hats fill by Method::lattice: slivers can be unstable.
struct Conducting {
  using role = mote::role::Heat;
  using particle_fields = fields<field::Temperature>;

  double specific_heat;              ///< cv, J/(kg K), > 0
  double initial_temperature = 300;  ///< K, > 0
  double conductivity;               ///< k, W/(m K), >= 0
  int every = 0;                     ///< steps, >= 0; 0: as many as the explicit limit allows

  Adiabatic adiabatic() const { return {specific_heat, initial_temperature}; }

  void validate() const {
    adiabatic().validate();
    require(conductivity >= 0 && conductivity < 1e300, "the conductivity is ", conductivity,
            " W/(m K); it must be >= 0 and finite");
    require(every >= 0, "heat is to be conducted every ", every, " steps; it must be >= 0 (0: as the limit allows)");
  }

  template <class V>
  void initialise(V& values) const {
    adiabatic().initialise(values);
  }
  template <class V, class E, class... Changes>
  void update(V& values, const E& eos, const Changes&... changes) const {
    adiabatic().update(values, eos, changes...);
  }

  friend bool operator==(const Conducting&, const Conducting&) = default;
};

}  // namespace mote::heat
