// expect: mote: the update order lacks a member
#include <mote/mote.hpp>

struct Odd {
  using role = mote::role::Update;
#ifndef MOTE_FAIL
  static constexpr bool remaps = false;
  template <class Phases>
  void operator()(Phases& step) const {
    step.scatter_momentum_and_force();
    step.update_grid();
    step.gather_velocity_and_deform();
  }
#endif
};

int main() {
  using namespace mote;
  Solver solver{grid::Cartesian<1>{.spacing = 1}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, Odd{},
                Material{eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1}}};
  return int(solver.size());
}
