/// \file
/// No shock viscosity.
#pragma once

#include <mote/core/role.hpp>

namespace mote::viscosity {

/// No artificial viscosity; leaves no instruction behind.
struct None {
  using role = mote::role::Viscosity;

  friend bool operator==(const None&, const None&) = default;
};

}  // namespace mote::viscosity
