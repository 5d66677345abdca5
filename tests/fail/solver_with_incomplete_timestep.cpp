// expect: mote: the time step policy lacks a member
#include <mote/mote.hpp>

struct Lazy {
  using role = mote::role::Timestep;
#ifndef MOTE_FAIL
  double operator()(double spacing, double max_speed) const { return 0.1 * spacing / max_speed; }
#endif
};

int main() {
  using namespace mote;
  Solver solver{grid::Cartesian<1>{.spacing = 1}, shape::Linear{}, transfer::Flip{}, Lazy{},
                Material{eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1}}};
  return int(solver.size());
}
