// expect: mote: the grid goes with a piston, but not with what sleeps
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<2> cells{.spacing = 1e-3};

void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells,
                shape::Linear{},
                transfer::Flip{},
                steel,
                sleep::Quiescent{},
                timestep::Cfl{},
                boundary::Piston{.side = side::y_min, .velocity = 1}};
#else
  Solver solver{cells,
                shape::Linear{},
                transfer::Flip{},
                steel,
                sleep::Quiescent{},
                timestep::Cfl{},
                boundary::RigidWall{.side = side::y_min}};
#endif
  solver.step();
}
