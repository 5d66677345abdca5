/// \file
/// What an update order offers.
#pragma once

#include <concepts>

#include <mote/core/role.hpp>

namespace mote {

/// U::remaps      whether it needs the velocity field that the particles' new momenta make
/// u(step)        calls the phases of a step in order; update::Usl, update::Musl and update::Usf show them all
template <class U>
concept Update = HasRole<U, role::Update> && requires {
  { U::remaps } -> std::convertible_to<bool>;
};

}  // namespace mote
