// expect: mote: a load does not fit the grid's dimension
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<3> cells{.spacing = 1e-3};

void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells,           shape::Linear{}, transfer::Flip{},
                timestep::Cfl{}, steel,           load::BodyForce<2>{.acceleration = {0, -10}}};
  solver.step();
#else
  Solver solver{cells,           shape::Linear{}, transfer::Flip{},
                timestep::Cfl{}, steel,           load::BodyForce<3>{.acceleration = {0, 0, -10}}};
  solver.step();
#endif
}
