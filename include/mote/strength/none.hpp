/// \file
/// No strength: a fluid.
#pragma once

#include <mote/strength/concept.hpp>

namespace mote::strength {

/// No deviatoric stress; stores nothing and leaves no instruction behind.
struct None {
  using role = mote::role::Strength;
  template <class V, class T>
  void update(V&, const Kinematics<T>&) const {}

  friend bool operator==(const None&, const None&) = default;
};

}  // namespace mote::strength
