/// \file
/// What a boundary offers.
#pragma once

#include <optional>

#include <mote/core/error.hpp>
#include <mote/core/role.hpp>
#include <mote/core/vec.hpp>

namespace mote {

/// A mirror plane holds the grid velocity to that of a mirrored body beyond it; components are even or odd.
///
/// B::side, B::at                    where: a plane through grid nodes, m
/// B::odd(component, normal_axis)    whether that component changes sign in the mirror (and so vanishes on the plane)
/// B::body_beyond                    whether the mirrored body is there (symmetry) or a mere device (wall): then its
///                                   momentum does not count before the forces, and FLIP feels the wall. Where all
///                                   components are odd the field may then bend on the plane (passes/orbits.hpp)
template <class B>
concept MirrorPlane = HasRole<B, role::Boundary> && requires(const B& b) {
  { b.side } -> std::convertible_to<Side>;
  { b.at } -> std::convertible_to<double>;
  { B::odd(0, 0) } -> std::convertible_to<bool>;
  { B::body_beyond } -> std::convertible_to<bool>;
};

/// A mirror plane that moves; velocity(t) along its axis, m/s. The grid goes with it.
template <class B>
concept MovingPlane = MirrorPlane<B> && requires(const B& b) {
  { b.velocity(0.0) } -> std::convertible_to<double>;
};

/// B::axis, B::from, B::to: what leaves at `to` comes in at `from`, m.
template <class B>
concept PeriodicPair = HasRole<B, role::Boundary> && requires(const B& b) {
  { b.axis } -> std::convertible_to<int>;
  { b.from } -> std::convertible_to<double>;
  { b.to } -> std::convertible_to<double>;
};

template <class B>
concept Boundary = MirrorPlane<B> || PeriodicPair<B>;

namespace detail {
template <class B>
struct Given {
  using type = B;
};
template <class B>
struct Given<std::optional<B>> {
  using type = B;
};
}  // namespace detail

/// The boundary that a part is, or may be: a solver takes std::optional<B> for B, and an empty one is none.
template <class B>
using BoundaryOf = typename detail::Given<B>::type;

}  // namespace mote
