// expect: mote: a solver takes one sleep policy
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<3> cells{.spacing = 1e-3};

void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, sleep::Never{}, sleep::Quiescent{}, timestep::Cfl{}, steel};
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, sleep::Quiescent{}, timestep::Cfl{}, steel};
#endif
}
