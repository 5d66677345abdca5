/// \file
/// No temperature.
#pragma once

#include <mote/heat/concept.hpp>

namespace mote::heat {

/// A cold scene: no temperature column, no instruction.
struct None {
  using role = mote::role::Heat;
  template <class V, class E, class T>
  void update(V&, const E&, const T&, const T&, const T&) const {}

  friend bool operator==(const None&, const None&) = default;
};

}  // namespace mote::heat
