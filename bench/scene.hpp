/// \file
/// The cavity scene of the benchmarks, for the library and for the textbook loop.
#pragma once

#include <mote/mote.hpp>

#include "textbook.hpp"

namespace bench {

using namespace mote;

inline constexpr double um = 1e-6;

inline auto aluminium() {
  return Material{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                  strength::VonMises{.shear_modulus = 69e9 / 2.66, .yield = 120e6, .hardening = 384e6},
                  heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
}

/// The body [-w, w]^2 x [0, height] with the cavity of the paper, on a mesh of 1 um.
struct Scene {
  int half_width = 20, height = 50;  // um
  double speed = 100;

  auto region() const {
    const double w = half_width * um;
    return geometry::Box<3>{.lower = {-w, -w, 0}, .upper = {w, w, height * um}} -
           geometry::Ball<3>{.centre = {0, 0, 10 * um}, .radius = 5 * um};
  }

  /// A solver on this scene, filled; on the heap, since solvers do not move.
  template <class T, class Shape, class Transfer, class Update, class Executor>
  auto library(Shape shape, Transfer transfer, Update update, Executor executor) const {
    const double w = half_width * um;
    const auto make = [&] {
      return Solver{grid::Cartesian<3, T>{.spacing = um},
                    shape,
                    transfer,
                    update,
                    timestep::Cfl{.courant = 0.4},
                    executor,
                    boundary::Periodic{.axis = axis::x, .from = -w, .to = w},
                    boundary::Periodic{.axis = axis::y, .from = -w, .to = w},
                    boundary::RigidWall{.side = side::z_min, .at = 0},
                    aluminium()};
    };
    auto solver = std::unique_ptr<decltype(make())>(new auto(make()));
    solver->fill(region(), aluminium(), {.per_axis = 2, .velocity = {0, 0, speed}});
    return solver;
  }

  /// The same in the textbook loop.
  template <class Loop>
  Loop textbook() const {
    Loop loop({.spacing = um,
               .lower = {-half_width, -half_width, 0},
               .upper = {half_width, half_width, height + 10},
               .periodic = {true, true, false},
               .planes = {{.axis = 2, .node = 0}}});
    for (const auto& s : geometry::seeds(region(), geometry::Lattice<3>{um, 2, {}}))
      loop.add({s.position[0], s.position[1], s.position[2]}, {0, 0, speed}, 2700 * s.volume);
    return loop;
  }
};

}  // namespace bench
