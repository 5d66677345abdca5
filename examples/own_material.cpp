// A strength of your own: von Mises metal that softens as it is strained in tension, with a history field of its own.
#include <algorithm>
#include <cstdio>
#include <mote/mote.hpp>
using namespace mote;

struct Damage {  // 0: whole, 1: no strength left; declared below, so it is stored, and observe::Vtp writes it
  using shape = shape_of::Scalar;
  static constexpr const char *name = "damage", *unit = "1";
};
struct DuctileMetal {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::PlasticStrain, field::VolumeRatio, Damage>;
  double shear_modulus, yield, failure_strain;  // Pa, Pa, plastic strain in tension that leaves no strength
  void validate() const { require(std::min({shear_modulus, yield, failure_strain}) > 0, "all three must be > 0"); }
  template <class V, class T>  // T: a number, or a pack of eight: select(condition, yes, no) instead of branches
  T update(V& v, const Kinematics<T>& k) const {
    using std::max, std::min, std::sqrt;
    auto& s = get<field::DeviatoricStress>(v);
    s = strength::elastic_predictor(v, k, shear_modulus);
    const T limit = T(yield) * (T(1) - get<Damage>(v)), equivalent = max(sqrt(T(1.5) * ddot(s, s)), T(1e-30));
    const T strain = max(equivalent - limit, T(0)) * T(1 / (3 * shear_modulus));
    s = s * (T(1) - T(3 * shear_modulus) * strain / equivalent);  // back to the yield surface
    get<field::PlasticStrain>(v) += strain;
    const T opening = select(get<field::VolumeRatio>(v) > T(1), strain, T(0));  // in tension only
    get<Damage>(v) = min(get<Damage>(v) + opening * T(1 / failure_strain), T(1));
    return limit * strain;  // plastic work, J/m^3
  }
};
int main() {
  const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                       DuctileMetal{.shear_modulus = 25.94e9, .yield = 120e6, .failure_strain = 0.3}};
  Solver solver{grid::Cartesian<3>{.spacing = 2e-6}, shape::QuadraticBSpline{}, transfer::Apic{}, timestep::Cfl{},
                boundary::RigidWall{.side = side::z_min}, metal};
  solver.fill(geometry::Box<3>{.lower = {-20e-6, -20e-6, 0}, .upper = {20e-6, 20e-6, 30e-6}} -
                  geometry::Ball<3>{.centre = {0, 0, 10e-6}, .radius = 5e-6}, metal, {.velocity = {0, 0, 400}});
  solver.run({.until = 5e-9}, observe::Vtp{.stem = "damage", .every = 1e-9});
  std::printf("largest damage: %.3f\n", std::ranges::max(solver.particles().column<Damage>()));
}
