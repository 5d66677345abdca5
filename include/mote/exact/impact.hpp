/// \file
/// Exact plate impact: a flyer plate hits a target at rest, both of elastic-plastic metal.
///
/// From the interface elastic-plastic waves run into both plates: for each metal the interface is a rigid wall that it
/// is driven into (plane_wave.hpp), and both walls move alike. Velocity and normal stress are continuous there, so the
/// velocity of the interface is where the two stresses meet (impedance matching):
///
///     sigma_flyer(speed - u) = sigma_target(u)
///
/// with sigma(w) the stress that a metal answers a velocity jump w with. Both grow with w, so there is one u.
/// Source: Davison, Fundamentals of Shock Wave Propagation in Solids (2008), ch. 3 and 7; Meyers, Dynamic Behavior of
/// Materials (1994), ch. 4.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <mote/exact/plane_wave.hpp>

namespace mote::exact {

/// What the impact of two plates makes, until the first wave comes back from a free surface. The flyer moves along +z
/// and touches the target at z = 0 at time 0.
struct Impact {
  double speed;      ///< of the flyer before, m/s; the target is at rest
  double velocity;   ///< of the interface, m/s
  double stress;     ///< sigma_zz on both sides of the interface, Pa, tension positive
  PlaneWave flyer;   ///< seen from the interface, away from it: velocities are (interface's - metal's)
  PlaneWave target;  ///< the same: velocities are (metal's - interface's)
};

/// A stretch of uniform state between two fronts, or a front and the interface.
struct Stretch {
  double from, to;   ///< z, m, in space
  bool flyer;        ///< of the flyer, or else of the target
  PlaneState state;  ///< velocity is that in space, along +z
};

namespace detail {

/// Compression that the metal answers a velocity jump with, Pa, >= 0.
inline double answer(const UniaxialPath& push, double jump) {
  const double x = bisect([&](double y) { return push.velocity_change(y) - jump; }, 1, push.farthest());
  return -push.state(x).stress;
}

}  // namespace detail

/// The impact of a flyer at `speed` > 0 (m/s) on a target at rest, both as plane_wave() takes them.
///
/// \throws InputError unless speed > 0 and neither metal is driven beyond UniaxialPath::farthest.
template <class HeatA, class ViscosityA, class HeatB, class ViscosityB>
Impact impact(const Material<eos::MieGruneisen, strength::VonMises, HeatA, ViscosityA>& flyer,
              const Material<eos::MieGruneisen, strength::VonMises, HeatB, ViscosityB>& target, double speed) {
  const UniaxialPath a = detail::uniaxial_path(flyer, -1), b = detail::uniaxial_path(target, -1);
  const auto surplus = [&](double u) { return detail::answer(b, u) - detail::answer(a, speed - u); };
  const double least = std::max(0.0, speed - a.velocity_change(a.farthest()));
  const double most = std::min(speed, b.velocity_change(b.farthest()));
  require(speed > 0 && least < most && surplus(least) <= 0 && surplus(most) >= 0, "the impact speed is ", speed,
          " m/s; it must be > 0 and not so large that it drives one of these metals beyond its equation of state");
  Impact i{};
  i.speed = speed;
  i.velocity = detail::bisect(surplus, least, most);
  i.flyer = plane_wave(flyer, i.velocity - speed);
  i.target = plane_wave(target, -i.velocity);
  i.stress = i.target.behind.stress;
  return i;
}

/// The stretches of uniform state at `time` (s) along z, from the flyer's undisturbed metal (from = -infinity) to the
/// target's (to = infinity): two or three per plate, since an elastic wave or an overdriven shock is one front. Valid
/// until the first wave comes back from a free surface.
///
/// \throws InputError unless time > 0.
inline std::vector<Stretch> profile(const Impact& impact, double time) {
  require(time > 0, "the time after the impact is ", time, " s; it must be > 0");
  std::vector<Stretch> all;
  const auto add = [&](const PlaneWave& wave, int sign) {
    const std::array<const PlaneState*, 3> states{&wave.behind, &wave.elastic_limit, &wave.ahead};
    const std::array<double, 4> fronts{0, wave.plastic_speed * time, wave.elastic_speed * time,
                                       std::numeric_limits<double>::infinity()};  // in the metal's own length
    double z = impact.velocity * time;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(fronts[k + 1] > fronts[k])) continue;
      Stretch s{z, z + sign * states[k]->x * (fronts[k + 1] - fronts[k]), sign < 0, *states[k]};
      s.state.velocity = impact.velocity + sign * states[k]->velocity;
      z = s.to;
      all.push_back(s);
    }
  };
  add(impact.flyer, -1);
  for (Stretch& s : all) std::swap(s.from, s.to);
  std::reverse(all.begin(), all.end());
  add(impact.target, 1);
  return all;
}

/// The state at the place z (m, in space) at `time` (s) after the impact; on a front, that behind it in the flyer and
/// ahead of it in the target.
///
/// \throws InputError unless time > 0.
inline PlaneState at(const Impact& impact, double z, double time) {
  const auto stretches = profile(impact, time);
  return std::find_if(stretches.begin(), stretches.end() - 1, [&](const Stretch& s) { return z < s.to; })->state;
}

}  // namespace mote::exact
