/// \file
/// Update stress last.
#pragma once

#include <mote/core/role.hpp>

namespace mote::update {

/// Particles take velocity, position and stress from one and the same grid velocity, that of the end of the step.
///
/// With linear hats a node of tiny mass at a free surface gets a huge velocity, since its force falls less than its
/// mass, and the steep gradient of its hat turns that into stress: FLIP and APIC alike fail there in the end, even in
/// free flight, from round-off. With quadratic B-splines (grad w)^2/w stays bounded, and they do not mind. Source:
/// Bardenhagen, JCP 180 (2002) 383.
struct Usl {
  using role = mote::role::Update;
  static constexpr bool remaps = false;

  template <class Phases>
  void operator()(Phases& step) const {
    step.scatter_momentum_and_force();
    step.update_grid();
    step.gather_velocity_and_deform();
  }
};

}  // namespace mote::update
