/// \file
/// Stress tests in two dimensions: spin and oblique flight.
#pragma once

#include "line.hpp"

namespace stability {

/// A body in the plane, far from the wall at y = 0.
template <class S>
using Plane = decltype(Solver{grid::Cartesian<2>{}, typename S::Shape{}, typename S::Transfer{}, typename S::Update{},
                              timestep::Cfl{}, boundary::RigidWall{.side = side::y_min}, metal});

template <class S>
std::unique_ptr<Plane<S>> make_plane() {
  return std::make_unique<Plane<S>>(grid::Cartesian<2>{.spacing = h}, typename S::Shape{}, typename S::Transfer{},
                                    typename S::Update{}, timestep::Cfl{.courant = 0.4},
                                    boundary::RigidWall{.side = side::y_min, .at = 0}, spring);
}

struct Motion {
  End end;
  double kinetic;           ///< at the end over that at the start
  double angular_momentum;  ///< the same, about the centre of mass
  double stress;            ///< largest |P| at the end, Pa
  double size;              ///< the largest extent along x at the end, over that at the start
  double turns;             ///< done
};

template <class Solver>
double angular_momentum(const Solver& solver) {
  const auto& p = solver.particles();
  double m = 0, x[2] = {}, v[2] = {}, sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double mi = p.template column<field::Mass>()[i];
    m += mi;
    for (int a = 0; a < 2; ++a)
      x[a] += mi * p.template column<field::Position>(a)[i], v[a] += mi * p.template column<field::Velocity>(a)[i];
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto xi = p.template get<field::Position>(i), vi = p.template get<field::Velocity>(i);
    sum += p.template column<field::Mass>()[i] *
           ((xi[0] - x[0] / m) * (vi[1] - v[1] / m) - (xi[1] - x[1] / m) * (vi[0] - v[0] / m));
  }
  return sum;
}

template <class Solver>
double width(const Solver& solver) {
  Span span;
  for (const double x : solver.particles().template column<field::Position>(0)) span.add(x);
  return span.most - span.least;
}

/// Runs a filled solver and compares its end with its start.
template <class Solver>
Motion watch(Solver& solver, double until) {
  const double k = observe::ledger(solver).kinetic, l = angular_momentum(solver), w = width(solver);
  Motion out{};
  double angle = 0, before = 0;
  bool first = true;
  // the turn of one particle about the middle
  std::size_t last_sorts = ~std::size_t(0), who = 0;
  out.end = march(solver, until, [&] {
    const auto& p = solver.particles();
    if (solver.sorts() != last_sorts) {
      const auto id = p.template column<field::Id>();
      for (std::size_t i = 0; i < p.size(); ++i)
        if (id[i] == 0) who = i;
      last_sorts = solver.sorts();
    }
    double x[2] = {};
    for (int a = 0; a < 2; ++a) {
      const auto column = p.template column<field::Position>(a);
      for (const double xi : column) x[a] += xi / double(p.size());
      x[a] = column[who] - x[a];
    }
    const double now = std::atan2(x[1], x[0]);
    if (!first) angle += std::remainder(now - before, 2 * std::numbers::pi);
    before = now, first = false;
    return std::isfinite(now);
  });
  out.kinetic = observe::ledger(solver).kinetic / k;
  out.angular_momentum = angular_momentum(solver) / l;
  const Span p = pressures(solver);
  out.stress = std::max(std::abs(p.least), std::abs(p.most));
  out.size = width(solver) / w;
  out.turns = angle / (2 * std::numbers::pi);
  return out;
}

/// A disc of radius 4 h, its rim at 500 m/s, for as long as so many turns of a rigid one take.
template <class S>
Motion spin(double turns) {
  const auto solver = make_plane<S>();
  const double omega = 500 / (4 * h);
  solver->fill(geometry::Ball<2>{.centre = {0, 50 * h}, .radius = 4 * h}, spring,
               {.per_axis = 2, .velocity = [&](const Vec<double, 2>& x) {
                  return Vec<double, 2>{-omega * (x[1] - 50 * h), omega * x[0]};
                }});
  return watch(*solver, turns * 2 * std::numbers::pi / omega);
}

/// A jittered square of 4 x 4 cells without stress flies over so many cells along x, 0.37 as many along y.
template <class S>
Motion fly(double far) {
  const auto solver = make_plane<S>();
  solver->fill(geometry::Box<2>{.lower = {0, 50 * h}, .upper = {4 * h, 54 * h}}, spring,
               {.per_axis = 2, .velocity = Vec<double, 2>{2000, 740}, .jitter = 0.3, .seed = 1});
  return watch(*solver, far * h / 2000);
}

}  // namespace stability
