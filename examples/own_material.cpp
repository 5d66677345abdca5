// A strength of your own: von Mises metal that softens as it is strained in tension, with a history field of its own.
#include <algorithm>
#include <iostream>
#include <mote/mote.hpp>
#include <mote/verify/material.hpp>
using namespace mote;

struct Damage {  // 0: whole, 1: no strength left; declared below, so it is stored, and observe::Vtp writes it
  using shape = shape_of::Scalar;
  static constexpr const char *name = "damage", *unit = "1";
};
struct DuctileMetal {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::PlasticStrain, field::VolumeRatio, Damage>;
  double shear_modulus, yield, failure_strain;  // Pa, Pa, plastic strain in tension that leaves no strength
  void validate() const {
    require(std::min({shear_modulus, yield, failure_strain}) > 0, "all three must be > 0");
    require(3 * shear_modulus * failure_strain > yield, "it must not soften faster than it can unload");
  }
  template <class V>  // Pa; verify::material asks for it, too
  auto yield_stress(const V& v) const { return yield * (1 - get<Damage>(v)); }
  template <class V, class T>  // T: a number, or a pack of eight: select(condition, yes, no) instead of branches
  T update(V& v, const Kinematics<T>& k) const {
    using std::max, std::min, std::sqrt;
    auto& s = get<field::DeviatoricStress>(v);
    s = strength::elastic_predictor(v, k, shear_modulus);
    const T limit = T(yield_stress(v)), equivalent = max(sqrt(T(1.5) * ddot(s, s)), T(1e-30));
    const T opens = select(get<field::VolumeRatio>(v) > T(1), T(1 / failure_strain), T(0));  // in tension only
    // back to the yield surface, which comes to meet the stress as damage grows, at most to nothing
    const T strain = min(max(equivalent - limit, T(0)) / (T(3 * shear_modulus) - T(yield) * opens),
                         equivalent * T(1 / (3 * shear_modulus)));
    s = s * (T(1) - T(3 * shear_modulus) * strain / equivalent);
    get<field::PlasticStrain>(v) += strain;
    get<Damage>(v) = min(get<Damage>(v) + strain * opens, T(1));
    return T(0.5) * (limit + T(yield_stress(v))) * strain;  // plastic work, J/m^3
  }
};
int main() {
  const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                       DuctileMetal{.shear_modulus = 25.94e9, .yield = 120e6, .failure_strain = 0.3}};
  if (const auto report = verify::material(metal); std::cout << report, !report.passed()) return 1;  // is it sound?

  Solver solver{grid::Cartesian<3>{.spacing = 2e-6}, shape::QuadraticBSpline{}, transfer::Apic{}, timestep::Cfl{},
                boundary::RigidWall{.side = side::z_min}, metal};
  solver.fill(geometry::Box<3>{.lower = {-20e-6, -20e-6, 0}, .upper = {20e-6, 20e-6, 30e-6}} -
                  geometry::Ball<3>{.centre = {0, 0, 10e-6}, .radius = 5e-6}, metal, {.velocity = {0, 0, 400}});
  solver.run({.until = 5e-9}, observe::Vtp{.stem = "damage", .every = 1e-9});
  std::cout << "largest damage: " << std::ranges::max(solver.particles().column<Damage>()) << '\n';
}
