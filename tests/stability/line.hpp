/// \file
/// Stress tests in one dimension: what a scheme survives. Used by the tests here and by bench/stability.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <mote/exact/vibrating_bar.hpp>
#include <mote/mote.hpp>
#include <mote/observe/ledger.hpp>

namespace stability {

using namespace mote;

inline constexpr double h = 1e-6;  // m

/// The paper's aluminium without heat; the others have its type, so that a scheme is compiled once.
inline const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                            strength::VonMises{.shear_modulus = 69e9 / 2.66, .yield = 120e6, .hardening = 384e6}};
/// Does not yield, and is linear in V/V0.
inline const Material spring{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 0, .gamma0 = 0},
                             strength::VonMises{.shear_modulus = 69e9 / 2.66, .yield = 1e30, .hardening = 0}};
/// So soft that nothing holds it: sound at 1 m/s.
inline const Material dust{eos::MieGruneisen{.rho0 = 2700, .c0 = 1, .lambda = 0, .gamma0 = 0},
                           strength::VonMises{.shear_modulus = 1, .yield = 1e30, .hardening = 0}};
using Metal = std::remove_const_t<decltype(metal)>;

/// The metal with a shock viscosity.
inline const Material viscous_metal{metal.eos, metal.strength, viscosity::VonNeumann{}};

template <class S, class X, class U>
struct Scheme {
  using Shape = S;
  using Transfer = X;
  using Update = U;
};
using Default = Scheme<shape::QuadraticBSpline, transfer::AffineFlip, update::Usl>;

/// A body on a line, and a wall at x = 0. What shall be free lies far from it.
template <class S, class M = Metal>
using Line = decltype(Solver{grid::Cartesian<1>{}, typename S::Shape{}, typename S::Transfer{}, typename S::Update{},
                             timestep::Cfl{}, boundary::RigidWall{.side = side::x_min}, std::declval<M>()});

template <class S, class M>
std::unique_ptr<Line<S, M>> make_line(const M& material, double courant) {
  return std::make_unique<Line<S, M>>(grid::Cartesian<1>{.spacing = h}, typename S::Shape{}, typename S::Transfer{},
                                      typename S::Update{}, timestep::Cfl{.courant = courant},
                                      boundary::RigidWall{.side = side::x_min, .at = 0}, material);
}

/// From a to b, in cells.
inline geometry::Box<1> cells(double a, double b) { return {.lower = {a * h}, .upper = {b * h}}; }

/// How a run ended.
struct End {
  std::string error;  ///< of a NumericalError; empty: none
  double time = 0;    ///< s
  bool failed() const { return !error.empty(); }
};

/// Steps until `until` or a NumericalError, and calls f after each step. f may say false to end.
template <class Solver, class F>
End march(Solver& solver, double until, F&& f) {
  End end;
  try {
    while (solver.time() < until && end.error.empty()) {
      solver.step(until - solver.time());
      if (!f()) break;
    }
  } catch (const NumericalError& e) {
    end.error = e.what();
  }
  end.time = solver.time();
  return end;
}

template <class Solver>
double energy(const Solver& solver) {
  const auto l = observe::ledger(solver);
  return l.kinetic + l.elastic;
}

template <class Solver>
double momentum(const Solver& solver) {
  const auto& p = solver.particles();
  const auto m = p.template column<field::Mass>(), v = p.template column<field::Velocity>();
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += m[i] * v[i];
  return sum;
}

struct Span {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void add(double x) {
    least = std::min(least, x);
    most = x > most || x != x ? x : most;
  }
};

template <class Solver>
Span pressures(const Solver& solver) {
  Span span;
  const auto& p = solver.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<double, Solver::dimension, typename std::remove_cvref_t<decltype(p)>::list> v;
    p.load(i, v);
    span.add(solver.material().pressure(v));
  }
  return span;
}
template <class Solver>
Span volume_ratios(const Solver& solver) {
  Span span;
  for (const double x : solver.particles().template column<field::VolumeRatio>()) span.add(x);
  return span;
}

// ---- the vibrating bar: 16 cells, one end at the wall, the other free

struct Bar {
  double strain = 1e-3;  ///< v0/c; with 0.05 the end swings over half a cell to either side
  double courant = 0.4;
  int per_axis = 2;
  double jitter = 0;
  std::uint64_t seed = 0;
};

struct Vibration {
  End end;
  double most_energy = 0;         ///< over that at the start
  std::vector<double> energy;     ///< at the checkpoints, over that at the start
  std::vector<double> amplitude;  ///< of the momentum in the period before them, over the exact one
  bool blew_up() const { return end.failed() || !(most_energy < 2); }
};

/// Largest energy over the first of a bar that swings undamped. Stress q and velocity p are half a step apart: what the
/// symplectic step keeps is p^2 + q^2 - omega dt p q, and so p^2 + q^2 swings up to 1/(1 - omega dt/2).
/// \param quarter its length over h in quarters of a wave
inline double ripple(double courant, double quarter = 16) {
  return 1 / (1 - courant * std::numbers::pi / (4 * quarter));
}

/// \param periods checkpoints, rising
template <class S>
Vibration vibrate(const Bar& bar, const std::vector<double>& periods) {
  const double c = std::sqrt(spring.sound_speed2(spring.initial<double, 1>()));
  const exact::VibratingBar exact(
      {.length = 16 * h, .modulus = 2700 * c * c, .density = 2700, .speed = bar.strain * c});
  const auto solver = make_line<S>(spring, bar.courant);
  solver->fill(cells(0, 16), spring,
               {.per_axis = bar.per_axis,
                .velocity = [&](const Vec<double, 1>& x) { return Vec<double, 1>{exact.velocity(x[0], 0)}; },
                .jitter = bar.jitter,
                .seed = bar.seed});
  const double first = energy(*solver), p0 = 2700 * 16 * h * exact.mean_velocity(0);
  Vibration out;
  for (const double n : periods) {
    double p = 0;
    out.end = march(*solver, n * exact.period(), [&] {
      if (solver->time() > (n - 1) * exact.period()) p = std::max(p, std::abs(momentum(*solver)));
      if (solver->steps() % 16 == 0) {
        const double e = energy(*solver) / first;
        out.most_energy = e > out.most_energy || e != e ? e : out.most_energy;
      }
      return out.most_energy < 100;
    });
    out.energy.push_back(energy(*solver) / first);
    out.amplitude.push_back(p / p0);
    if (out.blew_up()) break;
  }
  return out;
}

// ---- a body's surface that reaches barely into a node's support

/// Where the last particle has to be, in cells from a node, for the farthest node it reaches to get this part of its
/// mass: w = d, d^2/2, d^3/6, and d^2 for GIMP with two particles per cell, whose domain is half a cell long.
inline double reach(shape::Linear, double part) { return part; }
inline double reach(shape::QuadraticBSpline, double part) { return 0.5 + std::sqrt(2 * part); }
inline double reach(shape::CubicBSpline, double part) { return std::cbrt(6 * part); }
inline double reach(shape::ContiguousGimp, double part) { return -0.25 + std::sqrt(part); }

/// Eight cells with two particles each, whose last particle reaches as far as that.
template <class S, class V>
auto surface_body(double part, double courant, const V& velocity) {
  auto solver = make_line<S>(spring, courant);
  solver->fill(cells(96, 104), spring, {.per_axis = 2, .velocity = velocity});
  solver->refresh();
  auto x = solver->particles().template column<field::Position>();
  const double shift = (104 + reach(typename S::Shape{}, part)) * h - x.back();
  for (double& place : x) place += shift;
  solver->refresh();
  return solver;
}

struct Surface {
  double least_mass;  ///< of a node that has any, over a particle's
  double kick;    ///< largest change of a node's velocity in the step, over courant times strain times speed of sound
  double strain;  ///< of the last particle in the step, over courant^2 times the strain that pulls
};

/// A body at rest under a uniform tension of strain 1e-6, let go. The last node gets f/m.
template <class S>
Surface let_go(double part) {
  const double courant = 0.4, pull = 1e-6;
  const auto solver = surface_body<S>(part, courant, Vec<double, 1>{0});
  for (double& x : solver->particles().template column<field::VolumeRatio>()) x = 1 + pull;
  solver->refresh();
  const double before = solver->particles().template column<field::VolumeRatio>().back();
  try {
    solver->step();
  } catch (const NumericalError&) {  // a strain below -1, which the columns now hold
  }
  const double m = solver->particles().template column<field::Mass>()[0];
  Surface out{1, 0, 0};
  const auto& nodes = solver->nodes();
  for (std::size_t n = 0; n < nodes.mass.size(); ++n)
    if (nodes.mass[n] > 0) {
      out.least_mass = std::min(out.least_mass, nodes.mass[n] / m);
      out.kick = std::max(out.kick, std::abs(nodes.velocity[grid::node_width<1> * n]));
    }
  const double c = std::sqrt(spring.sound_speed2(spring.initial<double, 1>()));
  out.kick /= courant * pull * c;
  out.strain =
      (solver->particles().template column<field::VolumeRatio>().back() / before - 1) / (courant * courant * pull);
  return out;
}

/// The same, strain `pull`, for five periods. \return the largest energy over the first, inf after a NumericalError
template <class S>
double release(double part, double pull, double courant = 0.4) {
  const auto solver = surface_body<S>(part, courant, Vec<double, 1>{0});
  for (double& x : solver->particles().template column<field::VolumeRatio>()) x = 1 + pull;
  solver->refresh();
  const double first = energy(*solver), c = std::sqrt(spring.sound_speed2(spring.initial<double, 1>()));
  double most = 0;
  const auto end = march(*solver, 5 * 16 * h / c, [&] {
    const double e = energy(*solver) / first;
    most = e > most || e != e ? e : most;
    return most < 100;
  });
  return end.failed() ? std::numeric_limits<double>::infinity() : most;
}

/// The same body swings freely, strain 0.01, for five periods. \return the largest energy over the first, inf if lost
template <class S>
double swing(double part, double courant = 0.4) {
  const double c = std::sqrt(spring.sound_speed2(spring.initial<double, 1>()));
  const auto solver = surface_body<S>(part, courant, [&](const Vec<double, 1>& x) {
    return Vec<double, 1>{0.01 * c * std::sin(std::numbers::pi * (x[0] / h - 100) / 8)};
  });
  const double first = energy(*solver);
  double most = 0;
  const auto end = march(*solver, 5 * 16 * h / c, [&] {
    const double e = energy(*solver) / first;
    most = e > most || e != e ? e : most;
    return most < 100;
  });
  return end.failed() ? std::numeric_limits<double>::infinity() : most;
}

// ---- violence

struct Crash {
  End end;
  double pressure;  ///< largest, over that of the exact shock
  double middle;    ///< mean over the middle half of what the shock has passed, over that of the exact shock
  Span volume;      ///< V/V0 at the end
  bool finite;
};

/// 40 cells flung at the wall, until the shock has gone through three quarters of them.
template <class S, class M = Metal>
Crash crash(double speed, double courant = 0.4, const M& material = metal) {
  const auto solver = make_line<S>(material, courant);
  solver->fill(cells(0, 40), material, {.per_axis = 2, .velocity = Vec<double, 1>{-speed}});
  const double shock = 5350 + 1.34 * speed, exact = 2700 * shock * speed;
  Crash out{};
  double most = 0;
  out.end = march(*solver, 30 * h / shock, [&] {
    most = std::max(most, pressures(*solver).most);
    return true;
  });
  out.pressure = most / exact;
  out.volume = volume_ratios(*solver);
  const auto& p = solver->particles();
  double sum = 0, mass = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<double, 1, typename std::remove_cvref_t<decltype(p)>::list> v;
    p.load(i, v);
    if (p.template column<field::Id>()[i] < 15 || p.template column<field::Id>()[i] >= 45) continue;
    sum += get<field::Mass>(v) * material.pressure(v), mass += get<field::Mass>(v);
  }
  out.middle = sum / mass / exact;
  out.finite = std::isfinite(energy(*solver)) && std::isfinite(sum);
  return out;
}

struct Tear {
  End end;
  Span pressure, volume;
  bool finite;
};

/// The same flung away from the wall, which holds on: tension beyond any spall strength.
template <class S>
Tear tear(double speed, double until = 6e-9) {
  const auto solver = make_line<S>(metal, 0.4);
  solver->fill(cells(0, 40), metal, {.per_axis = 2, .velocity = Vec<double, 1>{speed}});
  Tear out{};
  out.end = march(*solver, until, [] { return true; });
  out.pressure = pressures(*solver), out.volume = volume_ratios(*solver);
  out.finite = std::isfinite(energy(*solver)) && std::isfinite(out.pressure.most);
  return out;
}

struct Collision {
  End end;
  double pressure;  ///< largest, over that of the exact shock
  double energy;    ///< change of the sum of all energies over the kinetic energy at the start
  double momentum;  ///< change over that of one body
  bool finite;
};

/// Two bodies of 15 cells meet at a relative speed, over a gap of half a cell.
template <class S>
Collision collide(double speed) {
  const auto solver = make_line<S>(metal, 0.4);
  const double u = speed / 2, shock = 5350 + 1.34 * u, exact = 2700 * shock * u;
  solver->fill(cells(84, 99), metal, {.per_axis = 2, .velocity = Vec<double, 1>{u}});
  solver->fill(cells(100, 115), metal, {.per_axis = 2, .velocity = Vec<double, 1>{-u}});
  const auto start = observe::ledger(*solver);
  Collision out{};
  double most = 0;
  out.end = march(*solver, 60 * h / shock, [&] {
    most = std::max(most, pressures(*solver).most);
    return true;
  });
  const auto now = observe::ledger(*solver);
  out.pressure = most / exact;
  out.energy = (now.energy() - start.energy()) / start.kinetic;
  out.momentum = momentum(*solver) / (2700 * 15 * h * u);
  out.finite = std::isfinite(now.energy());
  return out;
}

// ---- no forces to speak of

/// Dust that flies apart, v = rate x, to three times its length. \return V/V0 over 3, least and most
template <class S>
Span stretch(int per_axis, double courant = 0.05) {
  const double rate = 1e9;  // 1/s
  const auto solver = make_line<S>(dust, courant);
  solver->fill(cells(96, 104), dust, {.per_axis = per_axis, .velocity = [&](const Vec<double, 1>& x) {
                                        return Vec<double, 1>{rate * (x[0] - 100 * h)};
                                      }});
  const auto end = march(*solver, 2 / rate, [] { return true; });
  Span span = volume_ratios(*solver);
  span.least /= 3, span.most /= 3;
  if (end.failed()) span.most = std::numeric_limits<double>::quiet_NaN();
  return span;
}

struct Flight {
  End end;
  double speed;  ///< largest departure from that at the start, relative
  Span volume;
};

/// One particle that starts 1% dense, over 1000 cells.
template <class S>
Flight fly_alone() {
  const auto solver = make_line<S>(spring, 0.4);
  solver->fill(cells(100, 101), spring, {.per_axis = 1, .velocity = Vec<double, 1>{2000}});
  solver->particles().template column<field::VolumeRatio>()[0] = 0.99;
  solver->refresh();
  Flight out{};
  out.end = march(*solver, 1000 * h / 2000, [&] {
    out.speed = std::max(out.speed, std::abs(solver->particles().template column<field::Velocity>()[0] / 2000 - 1));
    out.volume.add(solver->particles().template column<field::VolumeRatio>()[0]);
    return true;
  });
  return out;
}

}  // namespace stability
