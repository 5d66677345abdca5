#pragma once

#include <mote/mote.hpp>

/// Steps a small cube into a wall with two threads; the impulse that the wall took, N s.
inline double run_a_solver() {
  using namespace mote;
  const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                           strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                           heat::Adiabatic{.specific_heat = 880}};
  Solver solver{grid::Cartesian<3>{.spacing = 1e-6},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Cfl{},
                execution::Threads{2},
                boundary::RigidWall{.side = side::z_min},
                aluminium};
  const geometry::Box<3> cube{.lower = {0, 0, 0}, .upper = {3e-6, 3e-6, 3e-6}};
  solver.fill(cube, aluminium, {.per_axis = 2, .velocity = {0, 0, -100}});
  for (int i = 0; i < 5; ++i) solver.step();
  return solver.ledger().impulse[0][2];
}
