// expect: mote: heat flows in material at rest too
#include <mote/mote.hpp>

using namespace mote;
const eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};
const Material steel{bulk, heat::Adiabatic{.specific_heat = 460}};
const Material conductor{bulk, heat::Conducting{.specific_heat = 460, .conductivity = 50}};
const grid::Cartesian<2> cells{.spacing = 1e-3};

void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, conductor, sleep::Quiescent{}, timestep::Cfl{}};
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, steel, sleep::Quiescent{}, timestep::Cfl{}};
#endif
  solver.step();
}
