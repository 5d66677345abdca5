/// \file
/// No shock viscosity.
#pragma once

#include <mote/core/role.hpp>

namespace mote::viscosity {

/// No artificial viscosity; leaves no instruction behind.
struct None {
  using role = mote::role::Viscosity;
};

}  // namespace mote::viscosity
