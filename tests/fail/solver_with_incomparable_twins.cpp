// expect: mote: two materials of one solver have the same C++ type and no operator==
#include <mote/mote.hpp>

using namespace mote;
struct Stiff {  // without operator==
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress>;
  double shear_modulus;
  template <class V, class T>
  void update(V& values, const Kinematics<T>& k) const {
    get<field::DeviatoricStress>(values) = strength::elastic_predictor(values, k, shear_modulus);
  }
};
const eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};
const Material hard{bulk, Stiff{80e9}};
const Material soft{bulk, Stiff{40e9}};
const Material other{bulk, strength::Elastic{.shear_modulus = 40e9}};
void assemble() {
#ifdef MOTE_FAIL
  Solver solver{grid::Cartesian<3>{.spacing = 1e-3}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, hard, soft};
#else
  Solver solver{grid::Cartesian<3>{.spacing = 1e-3}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, hard, other};
#endif
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {1, 1, 1}}, hard, {.per_axis = 2});
}
