/// \file
/// Body force.
#pragma once

#include <mote/core/role.hpp>
#include <mote/core/vector_field.hpp>

namespace mote::load {

/// An acceleration of every node, m/s^2, constant or a function of position and time.
template <int D>
struct BodyForce {
  using role = mote::role::Load;
  VectorField<D> acceleration;
};

}  // namespace mote::load
