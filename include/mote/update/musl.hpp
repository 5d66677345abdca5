/// \file
/// Modified update stress last.
#pragma once

#include <mote/core/role.hpp>

namespace mote::update {

/// Particles take their velocity from the grid, map it back to the nodes with the same weights, and are strained by
/// that second, smoother field; the position follows the first. At a node of tiny mass the second field is a mean of
/// its particles' velocities, however small the mass.
///
/// With APIC the second map carries the new affine part, m w (v + C (x_i - x_p)), like the first; with transfers that
/// carry the gradient, the gradient at the old place, where the weights are, whatever they keep. With linear hats,
/// whose C is the gradient, that feeds the noise of tiny nodes back: take FLIP for those. Source: Sulsky, Zhou,
/// Schreyer, Comput. Phys. Commun. 87 (1995) 236; Zhang, Chen, Liu, The Material Point Method (2017), sec. 3.3.
struct Musl {
  using role = mote::role::Update;
  static constexpr bool remaps = true;

  template <class Phases>
  void operator()(Phases& step) const {
    step.scatter_momentum_and_force();
    step.update_grid();
    step.gather_velocity_and_remap();
    step.constrain_remapped();
    step.deform();
  }
};

}  // namespace mote::update
