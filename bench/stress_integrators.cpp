/// \file
/// How far are the stress integrators off, per increment and along a path? Writes CSV to standard output; draw it with
///
///     build/gcc-release/bench/mote_bench_stress_integrators > stress_integrators.csv
///     bench/plot_stress_integrators.py stress_integrators.csv
///
/// Rows `path,HARDENING,INTEGRATOR,steps,error` are those of tests/convergence/stress_integrators.cpp; rows
/// `map,HARDENING,INTEGRATOR,radial,tangential,error` are iso-error maps: one increment from a point of the yield
/// surface, its parts along and across the stress in units of the yield strain sqrt(2/3) Y/2G; the error is that of the
/// stress, relative, against the rate equations.
#include <cstdio>
#include <mote/strength/von_mises_mixed.hpp>
#include <mote/strength/von_mises_mixed_exponential.hpp>

#include "../tests/convergence/strain_path.hpp"

namespace {

using namespace mote;
using namespace strain_path;

template <class Strength>
Strength metal_of(const Metal& metal) {
  return {.shear_modulus = g, .yield = yield, .hardening = metal.isotropic, .kinematic_hardening = metal.kinematic};
}

/// Relative error of one increment from the yield surface, its parts in yield strains.
template <class Strength>
double increment_error(const Metal& metal, double radial, double tangential) {
  const double radius = std::sqrt(2.0 / 3) * yield, unit = radius / (2 * g);
  const Tensor start = Path::in_plane(radius, 0), strain = Path::in_plane(radial * unit, tangential * unit);
  Point exact{start, {}, 0};
  RateEquations{metal}.advance(
      exact, [&](double) { return strain; }, 0, 1, 1000);
  Values<double, 3, typename Strength::particle_fields> state{};
  get<field::DeviatoricStress>(state) = start;
  metal_of<Strength>(metal).update(state, Kinematics<double>(stretch(strain)));
  return magnitude(get<field::DeviatoricStress>(state) - exact.s) / magnitude(exact.s);
}

template <class Strength>
void write(const char* hardening, const char* integrator, const Metal& metal) {
  const Path path;
  const Reference reference(path, metal, 1280);
  for (int steps = 10; steps <= 1280; steps *= 2)
    std::printf("path,%s,%s,%d,%.6g\n", hardening, integrator, steps,
                error(metal_of<Strength>(metal), path, reference, steps));
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j)
      if (i + j > 0)
        std::printf("map,%s,%s,%.3g,%.3g,%.6g\n", hardening, integrator, 0.1 * i, 0.1 * j,
                    increment_error<Strength>(metal, 0.1 * i, 0.1 * j));
}

}  // namespace

int main() {
  for (const auto& [name, metal] : {std::pair{"none", Metal{0, 0}}, std::pair{"5 GPa both", Metal{5e9, 5e9}}}) {
    write<strength::VonMisesMixed>(name, "radial return", metal);
    write<strength::VonMisesMixedExponential>(name, "exponential map", metal);
  }
}
