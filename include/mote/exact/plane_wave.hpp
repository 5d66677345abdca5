/// \file
/// Exact plane waves: a half-space of elastic-plastic metal launched away from a rigid wall or into it.
///
/// Uniaxial strain along a monotone path, x = V/V0 and t = +1 in tension, -1 in compression, has closed forms in x.
/// With the log strain L = t ln x the deviator is s = t (4/3) G L up to the yield point L = Y/(2G), and beyond it
///
///     eps_p = k (L - Y/(2G)),  k = 2G/(3G + H),   sigma_y = Y + H eps_p,   s = t (2/3) sigma_y,
///     W_p = t (k/rho0) int sigma_y dx,            sigma = s - P(x, W_p).
///
/// Both branches of sigma(x) are concave in tension and convex in compression, whatever the parameters. Hence
/// - tension: an elastic fan, the plateau at the elastic limit, a plastic fan; across a fan dv = -t c |dx| with the
///   Lagrangian speed c = sqrt((dsigma/dx)/rho0). The heads are the fast sides: the fans open, but by little;
/// - compression: an elastic shock, the plateau, a plastic shock; or one overdriven shock when the plastic one would
///   outrun the precursor. Across a shock U^2 = [sigma]/(rho0 [x]) and |[v]| = U |[x]|.
///
/// The closure is the material's: the energy above the reference curve is the specific plastic work, so a shock leaves
/// the metal where the path through x leads. Lagrangian speeds: initial distance per time, seen from the moving metal.
/// Source: Davison, Fundamentals of Shock Wave Propagation in Solids (2008), ch. 5 and 7.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <mote/core/error.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/heat/adiabatic.hpp>
#include <mote/heat/none.hpp>
#include <mote/material.hpp>
#include <mote/strength/von_mises.hpp>

namespace mote::exact {

namespace detail {

/// The root of f between `below`, where f <= 0, and `above`, where f >= 0, to the last bit; either may be the larger.
template <class F>
double bisect(const F& f, double below, double above) {
  for (;;) {
    const double middle = 0.5 * (below + above);
    if (middle == below || middle == above) return middle;
    const double value = f(middle);
    if (value == 0) return middle;
    (value < 0 ? below : above) = middle;
  }
}

/// int_a^b f, five-point Gauss on 32 equal panels: round-off for the smooth functions of this file.
template <class F>
double integrate(const F& f, double a, double b) {
  constexpr int panels = 32;
  constexpr double node[] = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double half = 0.5 * (b - a) / panels;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double centre = a + (2 * i + 1) * half;
    sum += weight[0] * f(centre);
    for (int j = 1; j < 3; ++j) sum += weight[j] * (f(centre - node[j] * half) + f(centre + node[j] * half));
  }
  return sum * half;
}

}  // namespace detail

/// What a plane wave leaves at a point; the direction is the wall's normal, positive away from the wall.
struct PlaneState {
  double velocity = 0;                                            ///< of the metal, m/s; the wall is at rest
  double x = 1;                                                   ///< V/V0
  double density = 0;                                             ///< kg/m^3
  double stress = 0;                                              ///< sigma along the normal, Pa, tension positive
  double pressure = 0;                                            ///< P, Pa, positive in compression
  double plastic_strain = 0;                                      ///< eps_p
  double plastic_work = 0;                                        ///< W_p, J/kg
  double temperature = std::numeric_limits<double>::quiet_NaN();  ///< K; nan for a cold material
};

/// Monotone uniaxial strain of one material, from rest: everything as a function of x = V/V0.
struct UniaxialPath {
  eos::MieGruneisen eos;
  strength::VonMises strength;
  double specific_heat;        ///< J/(kg K); nan for a cold material
  double initial_temperature;  ///< K; nan for a cold material
  int sign;                    ///< +1: tension, x >= 1; -1: compression, x <= 1

  /// x at the yield point.
  double limit() const { return std::exp(sign * yield_strain()); }

  bool plastic(double x) const { return sign * (x - limit()) > 0; }

  /// State at x, with velocity 0.
  PlaneState state(double x) const {
    PlaneState s;
    s.x = x;
    s.density = eos.rho0 / x;
    s.plastic_strain = plastic(x) ? flow() * (sign * std::log(x) - yield_strain()) : 0;
    s.plastic_work = plastic(x) ? plastic_work(x) : 0;
    s.pressure = eos.pressure(x, s.plastic_work);
    const double elastic = 4.0 / 3 * strength.shear_modulus * std::log(x);
    s.stress = (plastic(x) ? sign * 2.0 / 3 * yield_stress(x) : elastic) - s.pressure;
    s.temperature = temperature(x);
    return s;
  }

  /// Lagrangian speed of a weak wave at x, m/s, on the elastic or the plastic branch: they differ at the yield point.
  /// nan where the stress falls with growing strain, so that waves do not run.
  double speed(double x, bool on_plastic) const {
    const double volumetric = eos.rho0 * eos.bulk_sound_speed2(x, 0.0) / (x * x);
    const double shear = on_plastic ? 2.0 / 3 * strength.hardening * flow() / x -
                                          eos.gamma_over_volume() * sign * flow() * yield_stress(x)
                                    : 4.0 / 3 * strength.shear_modulus / x;
    return std::sqrt((volumetric + shear) / eos.rho0);
  }

  /// Speed of the shock that leads from x = a to x = b, m/s.
  double shock_speed(double a, double b) const {
    return std::sqrt((state(b).stress - state(a).stress) / (eos.rho0 * (b - a)));
  }

  /// Whether one shock leads straight to x, without an elastic precursor.
  bool overdriven(double x) const {
    return sign < 0 && plastic(x) && shock_speed(limit(), x) >= shock_speed(1, limit());
  }

  /// Change of velocity that the waves from rest to x bring, m/s, >= 0; it grows with |x - 1|.
  double velocity_change(double x) const {
    const double knee = plastic(x) ? limit() : x;
    if (sign > 0) {
      const auto fan = [&](double from, double to, bool on_plastic) {
        return detail::integrate([&](double y) { return speed(y, on_plastic); }, from, to);
      };
      return fan(1, knee, false) + (plastic(x) ? fan(knee, x, true) : 0);
    }
    if (x == 1) return 0;
    if (overdriven(x)) return shock_speed(1, x) * (1 - x);
    return shock_speed(1, knee) * (1 - knee) + (plastic(x) ? shock_speed(knee, x) * (knee - x) : 0);
  }

  /// The farthest x that waves are computed for: 2 in tension, or less where the stress stops growing; in compression
  /// nine tenths of the way to the pole of the Hugoniot.
  double farthest() const {
    if (sign < 0) return 1 - 0.9 * (1 - eos.smallest_x());
    if (!plastic(2) || speed(2, true) > 0) return 2;
    return detail::bisect([&](double x) { return speed(x, true) > 0 ? -1.0 : 1.0; }, limit(), 2);
  }

 private:
  double yield_strain() const { return strength.yield / (2 * strength.shear_modulus); }
  /// k = d(eps_p)/dL.
  double flow() const { return 2 * strength.shear_modulus / (3 * strength.shear_modulus + strength.hardening); }
  double yield_stress(double x) const {
    return strength.yield + strength.hardening * flow() * (sign * std::log(x) - yield_strain());
  }
  double plastic_work(double x) const {
    const double from = limit(), slope = strength.hardening * flow();
    const double logs = x * std::log(x) - x - from * std::log(from) + from;  // int ln x dx
    return sign * flow() / eos.rho0 * ((strength.yield - slope * yield_strain()) * (x - from) + sign * slope * logs);
  }

  /// The heat equation dT = [h/cv - Gamma T] dx + dW_p/cv by its integrating factor exp(Gamma x).
  double temperature(double x) const {
    const double gamma = eos.gamma_over_volume(), knee = limit();
    const auto kept = [&](double y) { return std::exp(gamma * (y - x)); };
    double heat = 0;
    if (sign < 0) heat = detail::integrate([&](double y) { return eos.reference_heating(y) * kept(y); }, 1, x);
    if (plastic(x))
      heat +=
          sign * flow() / eos.rho0 * detail::integrate([&](double y) { return yield_stress(y) * kept(y); }, knee, x);
    return initial_temperature * kept(1) + heat / specific_heat;
  }
};

/// The waves that leave the wall: states from the undisturbed metal inwards, Lagrangian front speeds in m/s.
///
/// `speed` is a wave's head and `tail` its end: equal for a shock, tail < speed for a fan. A purely elastic wave has
/// elastic_limit = behind and plastic_speed = plastic_tail = 0. An overdriven shock is one front: all four speeds are
/// equal and elastic_limit = ahead.
struct PlaneWave {
  double elastic_speed, elastic_tail;
  double plastic_speed, plastic_tail;
  PlaneState ahead;          ///< moving at the launch speed
  PlaneState elastic_limit;  ///< plateau between the elastic and the plastic wave (HEL)
  PlaneState behind;         ///< at rest with the wall
  bool overdriven;
  UniaxialPath path;

  /// State of the metal when the waves have brought it to x.
  PlaneState state(double x) const {
    PlaneState s = path.state(x);
    s.velocity = ahead.velocity - path.sign * path.velocity_change(x);
    return s;
  }
};

namespace detail {

template <class Heat, class Viscosity>
UniaxialPath uniaxial_path(const Material<eos::MieGruneisen, strength::VonMises, Heat, Viscosity>& m, int sign) {
  constexpr bool cold = std::is_same_v<Heat, heat::None>;
  static_assert(cold || std::is_same_v<Heat, heat::Adiabatic>, "mote: exact plane waves take heat::None or Adiabatic");
  UniaxialPath path{m.eos, m.strength, std::nan(""), std::nan(""), sign};
  if constexpr (!cold) {
    path.specific_heat = m.heat.specific_heat;
    path.initial_temperature = m.heat.initial_temperature;
  }
  return path;
}

inline void set_speeds(PlaneWave& w) {
  const UniaxialPath& path = w.path;
  const double end = w.behind.x, knee = path.plastic(end) ? path.limit() : end;
  w.plastic_speed = w.plastic_tail = 0;
  if (w.overdriven) {
    w.elastic_speed = w.elastic_tail = w.plastic_speed = w.plastic_tail = path.shock_speed(1, end);
  } else if (path.sign < 0) {
    w.elastic_speed = w.elastic_tail = path.shock_speed(1, knee);
    if (path.plastic(end)) w.plastic_speed = w.plastic_tail = path.shock_speed(knee, end);
  } else {
    w.elastic_speed = path.speed(1, false);
    w.elastic_tail = path.speed(knee, false);
    if (path.plastic(end)) w.plastic_speed = path.speed(knee, true), w.plastic_tail = path.speed(end, true);
  }
}

}  // namespace detail

/// The waves in a body of which every particle starts at `launch_speed` (m/s) along the normal of a rigid wall that it
/// sticks to: > 0 pulls it away from the wall (tension), < 0 drives it into the wall (compression).
///
/// \throws InputError for a speed of 0, or one that leads beyond UniaxialPath::farthest.
template <class Heat, class Viscosity>
PlaneWave plane_wave(const Material<eos::MieGruneisen, strength::VonMises, Heat, Viscosity>& material,
                     double launch_speed) {
  const UniaxialPath pull = detail::uniaxial_path(material, 1), push = detail::uniaxial_path(material, -1);
  const double fastest = pull.velocity_change(pull.farthest()), slowest = -push.velocity_change(push.farthest());
  require(launch_speed >= slowest && launch_speed <= fastest && launch_speed != 0, "the launch speed is ", launch_speed,
          " m/s; it must lie between ", slowest, " and ", fastest, " m/s for this material and not be 0");
  PlaneWave w{};
  w.path = launch_speed > 0 ? pull : push;
  const UniaxialPath& path = w.path;
  const auto missing = [&](double x) { return path.velocity_change(x) - std::abs(launch_speed); };
  const double end = detail::bisect(missing, 1, path.farthest());
  // the smallest speeds fall between two numbers x: keep at least one ulp, so that a front has a speed
  const double x = end == 1 ? std::nextafter(1.0, path.farthest()) : end;
  w.overdriven = path.overdriven(x);
  w.ahead = path.state(1);
  w.ahead.velocity = launch_speed;
  w.behind = path.state(x);
  w.elastic_limit = w.overdriven ? w.ahead : path.plastic(x) ? w.state(path.limit()) : w.behind;
  detail::set_speeds(w);
  return w;
}

/// State at a material point, `distance` metres from the wall before the launch, `time` seconds after it. On a front it
/// is the state ahead. Valid until the first wave comes back from the body's far end.
///
/// \throws InputError unless distance >= 0 and time >= 0.
inline PlaneState at(const PlaneWave& wave, double distance, double time) {
  require(distance >= 0, "the distance from the wall is ", distance, " m; it must be >= 0");
  require(time >= 0, "the time is ", time, " s; it must be >= 0");
  if (distance >= wave.elastic_speed * time) return wave.ahead;
  const double ray = distance / time;  // in a fan the state rides on the ray of its own speed
  const auto in_fan = [&](double from, double to, bool on_plastic) {
    return wave.state(detail::bisect([&](double x) { return ray - wave.path.speed(x, on_plastic); }, from, to));
  };
  if (ray > wave.elastic_tail) return in_fan(1, wave.elastic_limit.x, false);
  if (ray >= wave.plastic_speed) return wave.elastic_limit;
  if (ray > wave.plastic_tail) return in_fan(wave.elastic_limit.x, wave.behind.x, true);
  return wave.behind;
}

}  // namespace mote::exact
