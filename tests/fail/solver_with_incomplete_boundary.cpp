// expect: mote: a boundary lacks a member
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<3> cells{.spacing = 1e-3};

struct Incomplete {
  using role = mote::role::Boundary;
  int axis = 0;
  double from = 0;
};
void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel, Incomplete{}};
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel};
#endif
}
