// expect: mote: the sleep policy lacks a member
#include <mote/mote.hpp>

struct Odd {
  using role = mote::role::Sleep;
#ifndef MOTE_FAIL
  static constexpr bool sleeps = false;
#endif
};

int main() {
  using namespace mote;
  Solver solver{grid::Cartesian<1>{.spacing = 1},
                shape::Linear{},
                transfer::Flip{},
                timestep::Cfl{},
                Odd{},
                Material{eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1}}};
  return int(solver.size());
}
