// expect: mote: fill() was given a material that the solver does not hold
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<3> cells{.spacing = 1e-3};
const Material elastic_steel{steel.eos, strength::Elastic{.shear_modulus = 80e9}};
void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel};
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {1, 1, 1}}, elastic_steel, {.per_axis = 2});
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel};
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {1, 1, 1}}, steel, {.per_axis = 2});
#endif
}
