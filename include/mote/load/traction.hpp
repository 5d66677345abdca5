/// \file
/// Surface traction.
#pragma once

#include <concepts>
#include <functional>

#include <mote/core/role.hpp>
#include <mote/core/vec.hpp>
#include <mote/core/vector_field.hpp>

namespace mote::load {

/// Everywhere, or where a region (or any value with contains(x)) says.
template <int D>
class Where {
  std::function<bool(const Vec<double, D>&)> contains_;

 public:
  Where() = default;
  template <class R>
  requires requires(const R& region, const Vec<double, D>& x) {
    { region.contains(x) } -> std::convertible_to<bool>;
  }
  Where(const R& region) : contains_([region](const Vec<double, D>& x) { return region.contains(x); }) {}

  bool operator()(const Vec<double, D>& x) const { return !contains_ || contains_(x); }
};

/// A force per area, Pa (components along the axes, positive towards +), on the faces that look to one side: constant,
/// or a function of position and time.
///
/// The faces are found when a region is filled: those of particles whose neighbour site towards `side` got no particle
/// in that fill and lies within the boundaries, and whose place then is in `where`. Each has the area of a site's side,
/// (h/per_axis)^(d-1), for good: the traction is per initial area, and its direction does not turn with the body. The
/// particle carries the area as a field, and the force moves with it. Fill touching regions in one go, or say `where`:
/// the face between two fills looks open. On a surface that is oblique to the axes the faces are stairs; they add up to
/// its projections.
///
/// The force goes to the particle's own nodes with its own weights, so each of them has mass: it acts at the particle's
/// centre, half a particle below the surface. That spoils the stress within a cell or so only: since force, mass and
/// momentum are right, the wave runs as if sent out from the face, to order 2 in h (tests/unit/load/traction.cpp).
/// NairnMPM adds it at the particle's edge instead, which needs a kernel that ends there.
template <int D>
struct Traction {
  using role = mote::role::Load;
  Side side;
  VectorField<D> traction;
  Where<D> where = {};
};

}  // namespace mote::load
