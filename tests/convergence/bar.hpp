/// \file
/// A bar of the paper's aluminium launched off a rigid wall or into it, in one dimension, beside the exact solution.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <mote/mote.hpp>

namespace bar {

using namespace mote;

inline constexpr eos::MieGruneisen eos_of_aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
inline constexpr strength::VonMises von_mises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6};
inline constexpr heat::Adiabatic adiabatic{.specific_heat = 880, .initial_temperature = 300};
inline const Material aluminium{eos_of_aluminium, von_mises, adiabatic};

inline constexpr double length = 50e-6;  // m

/// Von Mises and a viscous pressure rho0 h (0.3 c0 D + 1.2 h D |D|), in compression and in tension.
struct Damped {
  struct Deviator {
    using shape = shape_of::Symmetric;
    static constexpr const char *name = "deviator_without_viscosity", *unit = "Pa";
  };
  using role = mote::role::Strength;
  using particle_fields = union_of<strength::VonMises::particle_fields, fields<Deviator>>;
  double spacing_over_dt;
  double shear_modulus = von_mises.shear_modulus;

  template <class V, class T>
  T update(V& values, const Kinematics<T>& k) const {
    using std::abs;
    auto& s = get<field::DeviatoricStress>(values);
    s = get<Deviator>(values);
    const T work = von_mises.update(values, k);
    get<Deviator>(values) = s;
    const T hd = T(spacing_over_dt) * trace(k.strain);
    s = add_diagonal(s, T(T(eos_of_aluminium.rho0) * hd * (T(0.3 * eos_of_aluminium.c0) + T(1.2) * abs(hd))));
    return work;
  }
};

/// The parts of preset `paper` of the cavity program.
struct LinearFlipMusl {
  static constexpr const char* name = "linear FLIP MUSL";
  static auto timestep(double) { return timestep::Cfl{.courant = 0.4}; }
  static auto material() { return aluminium; }
  shape::Linear shape;
  transfer::Flip transfer;
  update::Musl update;
};
/// Those of preset `accurate`.
struct QuadraticAffineFlipUsl {
  static constexpr const char* name = "quadratic AffineFlip USL";
  static auto timestep(double) { return timestep::Cfl{.courant = 0.4}; }
  static auto material() { return aluminium; }
  shape::QuadraticBSpline shape;
  transfer::AffineFlip transfer;
  update::Usl update;
};
struct QuadraticApicUsl {
  static constexpr const char* name = "quadratic APIC USL";
  static auto timestep(double) { return timestep::Cfl{.courant = 0.4}; }
  static auto material() { return aluminium; }
  shape::QuadraticBSpline shape;
  transfer::Apic transfer;
  update::Usl update;
};
/// FLIP with a third of PIC: its dissipation takes the ringing away, as a viscosity would.
struct BlendedQuadraticFlipUsl {
  static constexpr const char* name = "quadratic FLIP 0.65 USL";
  static auto timestep(double) { return timestep::Cfl{.courant = 0.4}; }
  static auto material() { return aluminium; }
  shape::QuadraticBSpline shape;
  transfer::Flip transfer{.blend = 0.65};
  update::Usl update;
};
/// Quadratic APIC with a viscosity, to see what of its error is ringing.
struct DampedQuadraticApicUsl : QuadraticApicUsl {
  static constexpr const char* name = "quadratic APIC USL, viscous";
  static constexpr double spacing_over_dt = 7300 / 0.4;  // m/s; c + |v| stays below 7300
  static auto timestep(double spacing) { return timestep::Fixed{spacing / spacing_over_dt}; }
  static auto material() { return Material{eos_of_aluminium, Damped{spacing_over_dt}, adiabatic}; }
};

/// Height of a step from one value to another is passed at this time, or never.
class Crossing {
  double level_;
  std::optional<double> time_;
  double last_time_ = 0, last_ = std::numeric_limits<double>::quiet_NaN();

 public:
  explicit Crossing(double level) : level_(level) {}
  void add(double time, double value) {
    if (!time_ && (last_ - level_) * (value - level_) <= 0)
      time_ = last_time_ + (time - last_time_) * (level_ - last_) / (value - last_);
    last_time_ = time, last_ = value;
  }
  double time() const { return time_.value_or(std::numeric_limits<double>::quiet_NaN()); }
};

/// Relative errors against the exact plane wave.
struct Errors {
  double stress, pressure;              ///< means behind the plastic front, over 0.3 to 0.8 of its path
  double deviator, plastic_strain;      ///< same means of s along the bar and of eps_p
  double elastic_speed, plastic_speed;  ///< between stations at 15 and 40 um
  double profile;                       ///< L1 of the velocity over the bar, relative to launch speed and length
};

/// Exact speed of the middle of the elastic or plastic jump of velocity: a ray of a fan, or the shock.
inline double middle_speed(const exact::PlaneWave& w, double velocity, bool plastic) {
  if (w.path.sign < 0) return plastic ? w.plastic_speed : w.elastic_speed;
  double ahead = plastic ? w.plastic_tail : w.elastic_tail, behind = plastic ? w.plastic_speed : w.elastic_speed;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (ahead + behind);
    (exact::at(w, middle, 1).velocity > velocity ? behind : ahead) = middle;  // tension: faster metal lies farther out
  }
  return 0.5 * (ahead + behind);
}

/// Runs the bar until the plastic front has come 43 um far (material coordinate), before the elastic one is back.
template <class Scheme>
Errors run(const Scheme& scheme, double spacing, double launch_speed) {
  const auto wave = exact::plane_wave(aluminium, launch_speed);
  const auto material = scheme.material();
  Solver solver{grid::Cartesian<1>{.spacing = spacing},
                scheme.shape,
                scheme.transfer,
                scheme.update,
                scheme.timestep(spacing),
                boundary::RigidWall{.side = side::x_min, .at = 0},
                material};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {length}}, material,
              {.per_axis = 2, .velocity = Vec<double, 1>{launch_speed}});
  solver.refresh();  // into the order of the line
  auto& p = solver.particles();
  const auto initial = p.template column<field::Position>();
  const std::vector<double> place(initial.begin(), initial.end());

  const double half[] = {0.5 * (wave.ahead.velocity + wave.elastic_limit.velocity),
                         0.5 * (wave.elastic_limit.velocity + wave.behind.velocity)};
  const auto nearest = [&](double x) {
    return std::size_t(std::lower_bound(place.begin(), place.end(), x) - place.begin());
  };
  const std::size_t station[] = {nearest(15e-6), nearest(40e-6)};
  Crossing crossing[2][2] = {{Crossing(half[0]), Crossing(half[0])}, {Crossing(half[1]), Crossing(half[1])}};
  const auto listen = [&] {
    for (int wave_number = 0; wave_number < 2; ++wave_number)
      for (int s = 0; s < 2; ++s)
        crossing[wave_number][s].add(solver.time(), p.template column<field::Velocity>()[station[s]]);
  };
  // the elastic front must not have come back; in the fastest compression it leads by 6%
  const double end = 43e-6 / wave.plastic_speed;
  listen();
  while (solver.time() < end) {
    solver.step(end - solver.time());
    listen();
  }

  Errors e{};
  double volume = 0;
  const double from = 0.3 * 43e-6, to = 0.8 * 43e-6;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<double, 1, typename std::remove_cvref_t<decltype(p)>::list> state;
    p.load(i, state);
    const double v = get<field::Velocity>(state)[0];
    e.profile += std::abs(v - exact::at(wave, place[i], solver.time()).velocity) / double(p.size());
    if (place[i] < from || place[i] > to) continue;
    const double part = get<field::Mass>(state) * get<field::VolumeRatio>(state);
    volume += part;
    e.stress += part * material.stress(state)(0, 0);
    e.pressure += part * material.pressure(state);
    e.plastic_strain += part * get<field::PlasticStrain>(state);
  }
  e.deviator = (e.stress + e.pressure) / volume / (wave.behind.stress + wave.behind.pressure) - 1;
  e.plastic_strain = e.plastic_strain / volume / wave.behind.plastic_strain - 1;
  e.stress = e.stress / volume / wave.behind.stress - 1;
  e.pressure = e.pressure / volume / wave.behind.pressure - 1;
  e.profile /= std::abs(launch_speed);
  const double way = place[station[1]] - place[station[0]];
  const auto speed_error = [&](int n) {
    return way / (crossing[n][1].time() - crossing[n][0].time()) / middle_speed(wave, half[n], n == 1) - 1;
  };
  e.elastic_speed = speed_error(0);
  e.plastic_speed = speed_error(1);
  return e;
}

}  // namespace bar
