/// \file
/// Roles: the places of a solver or a material that a part can fill, and the look-up of parts by role.
///
/// A part states its role once (`using role = mote::role::Shape;`), so parts can be given in any order.
#pragma once

#include <optional>
#include <tuple>
#include <type_traits>

namespace mote {

namespace role {
struct Grid {};
struct Shape {};
struct Transfer {};
struct Update {};
struct Timestep {};
struct Execution {};
struct Sleep {};
struct Boundary {};
struct Load {};
struct Material {};

struct Eos {};
struct Strength {};
struct Heat {};
struct Viscosity {};
struct Energy {};
}  // namespace role

/// A type that can fill the role R.
template <class P, class R>
concept HasRole = std::is_same_v<typename std::remove_cvref_t<P>::role, R>;

namespace detail {

template <class P, class R>
inline constexpr bool has_role = false;
template <class P, class R>
requires HasRole<P, R>
inline constexpr bool has_role<P, R> = true;
/// A boundary that a program has or has not.
template <class P>
requires HasRole<P, role::Boundary>
inline constexpr bool has_role<std::optional<P>, role::Boundary> = true;

template <class R, class Default, class... Parts>
struct FirstOf {
  using type = Default;
};
template <class R, class Default, class P, class... Rest>
struct FirstOf<R, Default, P, Rest...>
    : std::conditional_t<has_role<P, R>, std::type_identity<P>, FirstOf<R, Default, Rest...>> {};

template <class R, class... Parts>
using AllOf = decltype(std::tuple_cat(
    std::declval<std::conditional_t<has_role<Parts, R>, std::tuple<Parts>, std::tuple<>>>()...));

template <class R, class Default, class First, class... Rest>
constexpr auto pick(const First& first, const Rest&... rest) {
  if constexpr (has_role<First, R>)
    return first;
  else if constexpr (sizeof...(Rest) == 0)
    return Default{};
  else
    return pick<R, Default>(rest...);
}

template <class R, class... Parts>
constexpr auto pick_all(const Parts&... parts) {
  return std::tuple_cat([&] {
    if constexpr (has_role<Parts, R>)
      return std::tuple<Parts>(parts);
    else
      return std::tuple<>();
  }()...);
}

}  // namespace detail

/// How many of Parts fill the role R.
template <class R, class... Parts>
inline constexpr int count_of = (0 + ... + int(detail::has_role<Parts, R>));

/// How often T occurs among Ts.
template <class T, class... Ts>
inline constexpr int count_of_type = (0 + ... + int(std::is_same_v<T, Ts>));

/// Whether every one of Parts states one of the roles R.
template <class P, class... R>
inline constexpr bool has_any_role = (detail::has_role<P, R> || ...);

}  // namespace mote
