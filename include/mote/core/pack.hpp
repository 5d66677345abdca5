/// \file
/// Pack<T>: eight numbers of eight particles that one instruction works on, and the few functions by which a policy is
/// written once for a plain number and for a pack.
///
/// Write `using std::sqrt; sqrt(x)` and `select(x > y, a, b)` instead of branches, and the same code serves both.
///
/// Simd stands on the vector types of g++ and clang. std::experimental::simd says the same, but its operators are deep
/// calls that g++ 12 stops inlining in functions of this size: a step took 1.7 times as long.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace mote {

namespace detail {

/// Bytes of the machine's vectors, as the compiler was told.
#if defined(__AVX512F__)
inline constexpr int vector_bytes = 64;
#elif defined(__AVX__)
inline constexpr int vector_bytes = 32;
#else
inline constexpr int vector_bytes = 16;
#endif

template <class T, int N>
struct Registers {
  static constexpr int total = N * int(sizeof(T)), bytes = total < vector_bytes ? total : vector_bytes;
  static constexpr int count = total / bytes, each = N / count;
  typedef T type __attribute__((vector_size(bytes)));
};

}  // namespace detail

/// N truth values, the result of comparing two Simd<T, N>.
template <class T, int N>
struct SimdMask {
  using R = detail::Registers<T, N>;
  using M = decltype(typename R::type{} < typename R::type{});
  M v[R::count];

  bool operator[](std::size_t i) const { return v[i / R::each][i % R::each] != 0; }
};

/// N numbers, N a power of two, with elementwise arithmetic.
template <class T, int N>
struct Simd {
  using R = detail::Registers<T, N>;
  using V = typename R::type;
  V v[R::count];

  Simd() = default;
  template <class S>
  requires std::is_arithmetic_v<S>
  [[gnu::always_inline]] Simd(S s) {
    for (auto& r : v) r = T(s) - V{};  // s - 0 is s, even for -0: a bare broadcast
  }
  /// Lane i is f(i).
  template <class F>
  requires std::is_invocable_r_v<T, F, int>
  [[gnu::always_inline]] explicit Simd(F f) {
    for (int i = 0; i < N; ++i) v[i / R::each][i % R::each] = T(f(i));
  }

  static constexpr int size() { return N; }
  [[gnu::always_inline]] T operator[](std::size_t i) const { return v[i / R::each][i % R::each]; }
  [[gnu::always_inline]] void set(int i, T s) { v[i / R::each][i % R::each] = s; }

  [[gnu::always_inline]] Simd& operator+=(const Simd& b) { return *this = *this + b; }
  [[gnu::always_inline]] Simd& operator-=(const Simd& b) { return *this = *this - b; }
  [[gnu::always_inline]] Simd& operator*=(const Simd& b) { return *this = *this * b; }
  [[gnu::always_inline]] Simd& operator/=(const Simd& b) { return *this = *this / b; }

  [[gnu::always_inline]] friend Simd operator+(const Simd& a, const Simd& b) {
    Simd r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] + b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend Simd operator-(const Simd& a, const Simd& b) {
    Simd r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] - b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend Simd operator*(const Simd& a, const Simd& b) {
    Simd r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] * b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend Simd operator/(const Simd& a, const Simd& b) {
    Simd r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] / b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend Simd operator-(const Simd& a) {
    Simd r;
    for (int k = 0; k < R::count; ++k) r.v[k] = -a.v[k];
    return r;
  }
  [[gnu::always_inline]] friend SimdMask<T, N> operator<(const Simd& a, const Simd& b) {
    SimdMask<T, N> r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] < b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend SimdMask<T, N> operator==(const Simd& a, const Simd& b) {
    SimdMask<T, N> r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] == b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend SimdMask<T, N> operator<=(const Simd& a, const Simd& b) {
    SimdMask<T, N> r;
    for (int k = 0; k < R::count; ++k) r.v[k] = a.v[k] <= b.v[k];
    return r;
  }
  [[gnu::always_inline]] friend SimdMask<T, N> operator>(const Simd& a, const Simd& b) { return b < a; }
  [[gnu::always_inline]] friend SimdMask<T, N> operator>=(const Simd& a, const Simd& b) { return b <= a; }
};

/// Particles per pack. Fixed, not the machine's width: the layout does not depend on the compiler's flags.
inline constexpr int lanes = 8;

template <class T>
using Pack = Simd<T, lanes>;

namespace detail {
template <class T>
struct ScalarOf {
  using type = T;
};
template <class T, int N>
struct ScalarOf<Simd<T, N>> {
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
requires(!is_pack<T>) constexpr T select(bool condition, const T& yes, const T& no) { return condition ? yes : no; }
template <class T, int N>
[[gnu::always_inline]] inline Simd<T, N> select(const SimdMask<T, N>& condition, const Simd<T, N>& yes,
                                                const Simd<T, N>& no) {
  Simd<T, N> r;
  for (int k = 0; k < Simd<T, N>::R::count; ++k) r.v[k] = condition.v[k] ? yes.v[k] : no.v[k];
  return r;
}

constexpr bool all_of(bool condition) { return condition; }
template <class T, int N>
bool all_of(const SimdMask<T, N>& mask) {
  bool all = true;
  for (int i = 0; i < N; ++i) all &= mask[std::size_t(i)];
  return all;
}

template <class T, int N>
[[gnu::always_inline]] inline Simd<T, N> max(const Simd<T, N>& a, const Simd<T, N>& b) {
  return select(a < b, b, a);
}
template <class T, int N>
[[gnu::always_inline]] inline Simd<T, N> min(const Simd<T, N>& a, const Simd<T, N>& b) {
  return select(b < a, b, a);
}
template <class T, int N>
[[gnu::always_inline]] inline Simd<T, N> abs(const Simd<T, N>& a) {
  return select(a < Simd<T, N>(0), -a, a);
}

template <class T, int N>
[[gnu::always_inline]] inline Simd<T, N> sqrt(const Simd<T, N>& a) {
  Simd<T, N> r;
  for (int k = 0; k < Simd<T, N>::R::count; ++k) {
    const auto& x = a.v[k];
    // the masked forms, since g++ 12 warns about the undefined register inside the plain ones
#if defined(__AVX512F__)
    if constexpr (sizeof(x) == 64 && sizeof(T) == 8)
      r.v[k] = _mm512_maskz_sqrt_pd(0xff, x);
    else if constexpr (sizeof(x) == 64)
      r.v[k] = _mm512_maskz_sqrt_ps(0xffff, x);
    else
#endif
#if defined(__AVX__)
        if constexpr (sizeof(x) == 32 && sizeof(T) == 8)
      r.v[k] = _mm256_sqrt_pd(x);
    else if constexpr (sizeof(x) == 32)
      r.v[k] = _mm256_sqrt_ps(x);
    else
#endif
      for (int i = 0; i < Simd<T, N>::R::each; ++i) r.v[k][i] = std::sqrt(x[i]);
  }
  return r;
}

namespace detail {
template <class T, int N, class F>
Simd<T, N> by_lane(const Simd<T, N>& a, F f) {
  return Simd<T, N>([&](int i) { return f(a[std::size_t(i)]); });
}
}  // namespace detail
template <class T, int N>
Simd<T, N> exp(const Simd<T, N>& a) {
  return detail::by_lane(a, [](T x) { return std::exp(x); });
}
template <class T, int N>
Simd<T, N> expm1(const Simd<T, N>& a) {
  return detail::by_lane(a, [](T x) { return std::expm1(x); });
}
template <class T, int N>
Simd<T, N> log1p(const Simd<T, N>& a) {
  return detail::by_lane(a, [](T x) { return std::log1p(x); });
}
template <class T, int N>
Simd<T, N> log(const Simd<T, N>& a) {
  return detail::by_lane(a, [](T x) { return std::log(x); });
}
template <class T, int N>
Simd<T, N> pow(const Simd<T, N>& a, T e) {
  return detail::by_lane(a, [e](T x) { return std::pow(x, e); });
}

/// The largest lane.
template <class T, int N>
T largest(const Simd<T, N>& a) {
  T m = a[0];
  for (int i = 1; i < N; ++i) m = a[std::size_t(i)] > m ? a[std::size_t(i)] : m;
  return m;
}

/// Rounds down.
template <class T, int N>
[[gnu::always_inline]] inline Simd<T, N> floor(const Simd<T, N>& a) {
  Simd<T, N> r;
  for (int k = 0; k < Simd<T, N>::R::count; ++k) {
    const auto& x = a.v[k];
#if defined(__AVX512F__)
    if constexpr (sizeof(x) == 64 && sizeof(T) == 8)
      r.v[k] = _mm512_maskz_roundscale_pd(0xff, x, _MM_FROUND_TO_NEG_INF);
    else if constexpr (sizeof(x) == 64)
      r.v[k] = _mm512_maskz_roundscale_ps(0xffff, x, _MM_FROUND_TO_NEG_INF);
    else
#endif
#if defined(__AVX__)
        if constexpr (sizeof(x) == 32 && sizeof(T) == 8)
      r.v[k] = _mm256_floor_pd(x);
    else if constexpr (sizeof(x) == 32)
      r.v[k] = _mm256_floor_ps(x);
    else
#endif
      for (int i = 0; i < Simd<T, N>::R::each; ++i) r.v[k][i] = std::floor(x[i]);
  }
  return r;
}

/// Lane i of a pack.
template <class T, int N>
constexpr T lane(const Simd<T, N>& value, int i) {
  return value[std::size_t(i)];
}

template <class V>
[[gnu::always_inline]] inline V read(const Scalar<V>* from) {
  V r;
  std::memcpy(r.v, from, sizeof r.v);
  return r;
}
template <class V>
[[gnu::always_inline]] inline void write(const V& v, Scalar<V>* to) {
  std::memcpy(to, v.v, sizeof v.v);
}

}  // namespace mote
