// expect: mote: no grid given; add e.g. grid::Cartesian<3>{.spacing = h}
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<3> cells{.spacing = 1e-3};

void assemble() {
#ifdef MOTE_FAIL
  Solver solver{shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel};
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel};
#endif
}
