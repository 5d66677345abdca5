/// \file
/// No sleep.
#pragma once

#include <mote/core/role.hpp>

namespace mote::sleep {

/// Every particle is updated in every step.
struct Never {
  using role = mote::role::Sleep;
  static constexpr bool sleeps = false;
};

}  // namespace mote::sleep
