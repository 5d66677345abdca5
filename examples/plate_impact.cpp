// A plate of aluminium flies at 500 m/s into one of copper: two bodies in one solver. Waves of compression run from the
// impact into both plates, in each a small elastic one ahead of a large plastic one. Half a microsecond later, while
// all four are on their way, the profiles are written beside the exact solution; plot_plate_impact.py draws them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <mote/mote.hpp>
using namespace mote;

// Two materials of one C++ type are told apart by their numbers. Aluminium is that of the cavity, copper is half-hard
// OFHC of Steinberg, Equation of State and Strength Properties of Selected Materials (1996), without its hardening.
const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                         strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                         heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
const Material copper{eos::MieGruneisen{.rho0 = 8930, .c0 = 3940, .lambda = 1.489, .gamma0 = 2.02},
                      strength::VonMises{.shear_modulus = 47.7e9, .yield = 120e6},
                      heat::Adiabatic{.specific_heat = 383, .initial_temperature = 300}};

constexpr double speed = 500, time_shown = 0.5e-6;        // m/s, s
constexpr double flyer_back = -4e-3, target_back = 3e-3;  // free surfaces, m; the plates touch at z = 0

/// Writes a row per particle of a plate. Returns mean stress (Pa) and velocity (m/s) over the plateau, from the
/// interface to the plastic front, without a fifth of it at each end.
template <class Metal, class Particles>
exact::PlaneState write_plate(const Metal& metal, const Particles& plate, const exact::Stretch& plateau,
                              observe::LineFile& file) {
  const double middle = 0.5 * (plateau.from + plateau.to), half = 0.3 * (plateau.to - plateau.from);
  exact::PlaneState mean{};
  int inside = 0;
  for (std::size_t i = 0; i < plate.size(); ++i) {
    typename Metal::template State<double, 1> state;  // what the material needs: V/V0, deviator, temperature, ...
    plate.load(i, state);
    const double z = plate.template column<field::Position>()[i], v = plate.template column<field::Velocity>()[i];
    const double sigma = metal.stress(state)(0, 0);
    file.row(int(plateau.flyer), 1e3 * z, 1e-9 * sigma, v, 1e-9 * metal.pressure(state),
             get<field::Temperature>(state));
    if (std::abs(z - middle) > half) continue;
    mean.stress += sigma, mean.velocity += v, ++inside;
  }
  mean.stress /= inside, mean.velocity /= inside;
  return mean;
}

int main(int argc, char** argv) {
  const double h = argc > 1 ? std::stod(argv[1]) : 10e-6;  // grid spacing, m

  // One dimension: the plates are wide, so that nothing moves sideways. FLIP's part of PIC damps as a viscosity would.
  Solver solver{grid::Cartesian<1>{.spacing = h},
                shape::QuadraticBSpline{},
                transfer::Flip{.blend = 0.65},
                timestep::Cfl{.courant = 0.4},
                aluminium,
                copper};
  solver.fill(geometry::Box<1>{.lower = {flyer_back}, .upper = {0}}, aluminium, {.per_axis = 4, .velocity = {speed}});
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {target_back}}, copper, {.per_axis = 4});
  solver.run({.until = time_shown});

  const exact::Impact impact = exact::impact(aluminium, copper, speed);
  const auto stretches = exact::profile(impact, time_shown);
  observe::LineFile exact_file{"plate_impact_exact.csv", "time_us,flyer,from_mm,to_mm,sigma_gpa,v_m_s,p_gpa,t_k"};
  for (const auto& [from, to, flyer, state] : stretches)
    exact_file.row(1e6 * time_shown, int(flyer), 1e3 * std::max(from, flyer_back + speed * time_shown),
                   1e3 * std::min(to, target_back), 1e-9 * state.stress, state.velocity, 1e-9 * state.pressure,
                   state.temperature);

  std::printf("%zu particles, %zu steps, %.2f s\n", solver.size(), solver.steps(), solver.seconds());
  std::printf("%-22s %10s %14s\n", "behind the shocks", "v, m/s", "sigma, GPa");
  std::printf("%-22s %10.2f %14.4f\n", "exact", impact.velocity, 1e-9 * impact.stress);
  observe::LineFile file{"plate_impact.csv", "flyer,z_mm,sigma_gpa,v_m_s,p_gpa,t_k"};
  double off = 0;
  const auto target = std::find_if(stretches.begin(), stretches.end(), [](const auto& s) { return !s.flyer; });
  for (const exact::Stretch& plateau : {target[-1], target[0]}) {  // on both sides of the interface
    const auto& metal = plateau.flyer ? aluminium : copper;
    const auto mean = write_plate(metal, solver.particles(metal), plateau, file);
    const double off_v = mean.velocity / impact.velocity - 1, off_sigma = mean.stress / impact.stress - 1;
    std::printf("%-22s %10.2f %14.4f   (%+.2f%%, %+.2f%%)\n",
                plateau.flyer ? "computed, aluminium" : "computed, copper", mean.velocity, 1e-9 * mean.stress,
                100 * off_v, 100 * off_sigma);
    off = std::max({off, std::abs(off_v), std::abs(off_sigma)});
  }
  return off < 0.01 ? 0 : 1;
}
