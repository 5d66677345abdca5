/// \file
/// Pack<T>: eight numbers of eight particles that one instruction works on, and the few functions by which a policy is
/// written once for a plain number and for a pack.
///
/// Write `using std::sqrt; sqrt(x)` and `select(x > y, a, b)` instead of branches, and the same code serves both.
#pragma once

#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <type_traits>

namespace mote {

/// Particles per pack. Fixed, not the machine's width: the layout does not depend on the compiler's flags.
inline constexpr int lanes = 8;

template <class T, int N>
using Simd = std::experimental::fixed_size_simd<T, N>;

template <class T>
using Pack = Simd<T, lanes>;

namespace detail {
template <class T>
struct ScalarOf {
  using type = T;
};
template <class T, class Abi>
struct ScalarOf<std::experimental::simd<T, Abi>> {
  using type = T;
};
}  // namespace detail

/// The number type inside T: double for double and for Pack<double>.
template <class T>
using Scalar = typename detail::ScalarOf<T>::type;

template <class T>
inline constexpr bool is_pack = !std::is_same_v<T, Scalar<T>>;

/// `yes` where the condition holds, `no` elsewhere; both are computed.
template <class T>
  requires(!is_pack<T>)
constexpr T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}

template <class T, class Abi>
std::experimental::simd<T, Abi> select(const std::experimental::simd_mask<T, Abi>& condition,
                                       const std::experimental::simd<T, Abi>& yes,
                                       const std::experimental::simd<T, Abi>& no) {
  auto result = no;
  std::experimental::where(condition, result) = yes;
  return result;
}

constexpr bool any_of(bool condition) { return condition; }
constexpr bool all_of(bool condition) { return condition; }
using std::experimental::all_of;
using std::experimental::any_of;

/// Lane i of a pack, or the number itself.
template <class T>
constexpr Scalar<T> lane(const T& value, int i) {
  if constexpr (is_pack<T>)
    return value[std::size_t(i)];
  else
    return value;
}

template <class V>
V read(const Scalar<V>* from) {
  return V(from, std::experimental::element_aligned);
}
template <class V>
void write(const V& v, Scalar<V>* to) {
  v.copy_to(to, std::experimental::element_aligned);
}

}  // namespace mote
