/// \file
/// Rearranging the numbers of packs, which the passes do between particles and nodes; policies do not need it.
#pragma once

#include <cstring>

#include <mote/core/pack.hpp>

namespace mote {

/// Bit i is whether a[i] == b[i].
template <class T, int N>
[[gnu::always_inline]] inline unsigned equal_bits(const Simd<T, N>& a, const Simd<T, N>& b) {
#if defined(__AVX512VL__)
  if constexpr (sizeof(T) == 4 && N == 8) return _mm256_cmpeq_epi32_mask((__m256i)a.v[0], (__m256i)b.v[0]);
#endif
  unsigned bits = 0;
  for (int i = 0; i < N; ++i) bits |= unsigned(a[std::size_t(i)] == b[std::size_t(i)]) << i;
  return bits;
}

/// True where bit i is set.
template <class T, int N>
[[gnu::always_inline]] inline SimdMask<T, N> mask_of_bits(unsigned bits) {
  using R = detail::Registers<T, N>;
  using M = typename SimdMask<T, N>::M;
  SimdMask<T, N> r;
  for (int k = 0; k < R::count; ++k) {
    M place{};
    for (int i = 0; i < R::each; ++i) place[i] = 1 << (k * R::each + i);
    r.v[k] = (place & int(bits)) != 0;
  }
  return r;
}

/// Whole numbers as integers; what does not fit into 32 bits, and NaN, gives some integer far off (x86).
template <class T, int N>
[[gnu::always_inline]] inline void to_integers(const Simd<T, N>& a, int (&whole)[N]) {
  using R = detail::Registers<T, N>;
  typedef int I __attribute__((vector_size(R::each * sizeof(int))));
  for (int k = 0; k < R::count; ++k) {
    const I i = __builtin_convertvector(a.v[k], I);
    std::memcpy(whole + k * R::each, &i, sizeof i);
  }
}

/// V from the numbers in `from`, over and over.
template <class V, int n>
[[gnu::always_inline]] inline V repeated(const Scalar<V> (&from)[n]) {
  if constexpr (n == 1) {
    return V(from[0]);
  } else {
    static_assert(n == 2);
    V r;
    for (auto& part : r.v) {
      using Part = std::remove_reference_t<decltype(part)>;
      // g++ 12 makes a round trip through memory of the shuffle that says the same
#if defined(__AVX512DQ__)
      if constexpr (sizeof(Part) == 64 && sizeof(Scalar<V>) == 8)
        part = _mm512_maskz_broadcast_f64x2(0xff, _mm_loadu_pd(from));
      else
#endif
          if constexpr (sizeof(Scalar<V>) == 4) {
        typedef long long Pairs __attribute__((vector_size(sizeof(Part))));
        long long pair;
        std::memcpy(&pair, from, sizeof pair);
        part = reinterpret_cast<Part>(pair - Pairs{});
      } else
        for (int i = 0; i < V::R::each; ++i) part[i] = from[i % 2];
    }
    return r;
  }
}

/// Writes a[0], b[0], a[1], b[1], ...
template <class T>
[[gnu::always_inline]] inline void write_in_turns(const Pack<T>& a, const Pack<T>& b, T* to) {
  if constexpr (Pack<T>::R::count == 1) {
    const auto low = __builtin_shufflevector(a.v[0], b.v[0], 0, 8, 1, 9, 2, 10, 3, 11);
    const auto high = __builtin_shufflevector(a.v[0], b.v[0], 4, 12, 5, 13, 6, 14, 7, 15);
    std::memcpy(to, &low, sizeof low);
    std::memcpy(to + lanes, &high, sizeof high);
  } else {
    for (int l = 0; l < lanes; ++l) to[2 * l] = a[std::size_t(l)], to[2 * l + 1] = b[std::size_t(l)];
  }
}

/// Rows to columns: lane i of out[j] is lane j of in[i].
template <class T>
[[gnu::always_inline]] inline void transpose(const Pack<T> (&in)[lanes], Pack<T> (&out)[lanes]) {
  if constexpr (Pack<T>::R::count == 1) {
    // three perfect shuffles
    Pack<T> a[lanes];
    const auto shuffle = [](const Pack<T>* from, Pack<T>* to) __attribute__((always_inline)) {
      for (int i = 0; i < lanes / 2; ++i) {
        to[2 * i].v[0] = __builtin_shufflevector(from[i].v[0], from[i + 4].v[0], 0, 8, 1, 9, 2, 10, 3, 11);
        to[2 * i + 1].v[0] = __builtin_shufflevector(from[i].v[0], from[i + 4].v[0], 4, 12, 5, 13, 6, 14, 7, 15);
      }
    };
    shuffle(in, out);
    shuffle(out, a);
    shuffle(a, out);
  } else {
    for (int i = 0; i < lanes; ++i)
      for (int j = 0; j < lanes; ++j) out[j].set(i, in[i][std::size_t(j)]);
  }
}

}  // namespace mote
