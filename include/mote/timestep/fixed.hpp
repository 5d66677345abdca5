/// \file
/// Fixed time step.
#pragma once

#include <mote/core/error.hpp>
#include <mote/core/role.hpp>

namespace mote::timestep {

/// The step the user names, whatever the state; stability is the user's.
struct Fixed {
  using role = mote::role::Timestep;
  double dt;  ///< s, > 0

  void validate() const { require(dt > 0, "the time step is ", dt, " s; it must be > 0"); }
  double operator()(double, double) const { return dt; }
};

}  // namespace mote::timestep
