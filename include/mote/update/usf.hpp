/// \file
/// Update stress first.
#pragma once

#include <mote/core/role.hpp>

namespace mote::update {

/// Particles are strained by the velocity field that their momenta bring to the grid, before the forces, which the new
/// stresses then make; velocity and position follow from the field after the forces.
///
/// The field that strains is a mean of the particles' velocities at every node, however small its mass, as in MUSL.
/// Stress and velocity leap over each other as in USL: what is different is that the strain of a step comes from the
/// particles' velocities, by the weights at their new places, and not from the very field that moved them. FLIP, whose
/// particles keep noise that the grid does not see, then strains and moves by different fields, and its error grows
/// with the Courant number. Costs one transfer more than USL. Source: Bardenhagen, JCP 180 (2002) 383.
struct Usf {
  using role = mote::role::Update;
  static constexpr bool remaps = false;

  template <class Phases>
  void operator()(Phases& step) const {
    step.scatter_momentum();
    step.find_velocity();
    step.strain();
    step.scatter_momentum_and_force();
    step.update_grid();
    step.gather_velocity_and_move();
  }
};

}  // namespace mote::update
