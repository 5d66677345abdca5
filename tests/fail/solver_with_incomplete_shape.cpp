// expect: mote: the shape function lacks a member
#include <mote/mote.hpp>

using namespace mote;
const Material steel{eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
const grid::Cartesian<3> cells{.spacing = 1e-3};

struct Incomplete : shape::Linear {
  template <class T>
  static void slopes(const T&, T*) = delete;
};
void assemble() {
#ifdef MOTE_FAIL
  Solver solver{cells, Incomplete{}, transfer::Flip{}, timestep::Cfl{}, steel};
#else
  Solver solver{cells, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, steel};
#endif
}
