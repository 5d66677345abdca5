/// \file
/// What the solver needs to be assembled: stand-ins for missing parts, and questions about those given.
#pragma once

#include <chrono>
#include <optional>
#include <tuple>
#include <type_traits>

#include <mote/boundary/concept.hpp>
#include <mote/core/role.hpp>
#include <mote/load/concept.hpp>

namespace mote {

namespace detail {

/// Stand where a needed part is missing, so that the prose of the solver is the first error.
struct Missing {};
struct MissingGrid {
  static constexpr int dimension = 1;
  using number = double;
};

template <class R, class Default, class... Parts>
using First = typename FirstOf<R, Default, Parts...>::type;

template <class P>
inline constexpr bool has_solver_role =
    has_any_role<P, role::Grid, role::Shape, role::Transfer, role::Update, role::Timestep, role::Execution, role::Sleep,
                 role::Boundary, role::Load, role::Material>;

/// Lets a part object to its own numbers.
template <class P>
void validate(const P& part) {
  if constexpr (requires { part.validate(); }) part.validate();
}
template <class P>
void validate(const std::optional<P>& part) {
  if (part) validate(*part);
}

template <class Boundaries>
inline constexpr bool are_boundaries = false;
template <class... B>
inline constexpr bool are_boundaries<std::tuple<B...>> = (Boundary<BoundaryOf<B>> && ...);

/// Whether one of them takes the grid along.
template <class Boundaries>
inline constexpr bool moves = false;
template <class... B>
inline constexpr bool moves<std::tuple<B...>> = (MovingPlane<BoundaryOf<B>> || ...);

template <class Loads, int D>
inline constexpr bool are_loads = false;
template <class... L, int D>
inline constexpr bool are_loads<std::tuple<L...>, D> = ((LoadIn<L, D> || SurfaceLoadIn<L, D>)&&...);

/// What an observer says of itself; see Solver::run().
template <class O>
inline constexpr bool only_when_due = false;
template <class O>
requires requires { std::remove_cvref_t<O>::only_when_due; }
inline constexpr bool only_when_due<O> = std::remove_cvref_t<O>::only_when_due;
template <class O>
inline constexpr bool needs_nodes = false;
template <class O>
requires requires { std::remove_cvref_t<O>::needs_nodes; }
inline constexpr bool needs_nodes<O> = std::remove_cvref_t<O>::needs_nodes;

/// Adds the wall time that it lives to `seconds`.
struct Timed {
  double& seconds;
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  ~Timed() { seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count(); }
};

}  // namespace detail

}  // namespace mote
