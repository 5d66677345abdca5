/// \file
/// Courant condition.
#pragma once

#include <mote/core/error.hpp>
#include <mote/core/role.hpp>

namespace mote::timestep {

/// dt = courant h / max_p (c_p + |v_p|), c the longitudinal sound speed: particle speed counts, since it moves
/// information across the fixed grid too.
struct Cfl {
  using role = mote::role::Timestep;
  double courant = 0.4;

  void validate() const {
    require(courant > 0 && courant <= 2, "the Courant number is ", courant, "; it must be in (0, 2]");
  }
  double operator()(double spacing, double max_speed) const { return courant * spacing / max_speed; }
};

}  // namespace mote::timestep
