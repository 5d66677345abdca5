// expect: mote: material at rest does not stay there under a load
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
                load::BodyForce<2>{.acceleration = {0, -10}}};
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, steel, sleep::Quiescent{}, timestep::Cfl{}};
#endif
  solver.step();
}
