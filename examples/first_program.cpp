// A spherical cavity in aluminium, torn open by the rarefaction wave that leaves a rigid wall when the body moves away
// from it. Writes history.csv, and frames*.vtp for ParaView (open frames.pvd).
#include <mote/mote.hpp>                        // SI units throughout

#include <string>

int main(int argc, char** argv) {
  using namespace mote;
  const double h = argc > 1 ? std::stod(argv[1]) : 1e-6;  // grid spacing, m: `first_program 2.5e-6` is done in a second

  const Material aluminium{                     // leave a part out and its cost goes too
      eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
      strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
      heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

  Solver solver{                                // any order; a missing role is a one-line error
      grid::Cartesian<3>{.spacing = h},         // sparse, so it has no size; boundaries own their place
      shape::QuadraticBSpline{}, transfer::Apic{}, timestep::Cfl{.courant = 0.4}, execution::Threads{},
      boundary::Periodic{.axis = axis::x, .from = -20e-6, .to = 20e-6},
      boundary::Periodic{.axis = axis::y, .from = -20e-6, .to = 20e-6},
      boundary::RigidWall{.side = side::z_min, .at = 0},
      aluminium};

  const geometry::Box<3>  block{.lower = {-20e-6, -20e-6, 0}, .upper = {20e-6, 20e-6, 50e-6}};
  const geometry::Ball<3> cavity{.centre = {0, 0, 10e-6}, .radius = 5e-6};
  solver.fill(block - cavity, aluminium, {.per_axis = 2, .velocity = {0, 0, 100}});
  solver.run({.until = 12e-9}, observe::History{.file = "history.csv"}, observe::Vtp{.stem = "frames", .every = 4e-9});
}
