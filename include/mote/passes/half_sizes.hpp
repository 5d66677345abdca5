/// \file
/// The half sizes of a pack of particles, for kernels that depend on them (GIMP); nothing for others.
#pragma once

#include <type_traits>

#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/shape/concept.hpp>

namespace mote::passes {

struct NoHalfSizes {};

/// In cells, per axis.
template <class Shape, class T, int D>
using HalfSizes = std::conditional_t<sized<Shape>, Vec<Pack<T>, D>, NoHalfSizes>;

/// Those of the particles in `values`.
template <class Shape, class V, class T>
[[gnu::always_inline]] inline HalfSizes<Shape, T, V::dimension> half_sizes([[maybe_unused]] const V& values,
                                                                           [[maybe_unused]] T per_spacing) {
  if constexpr (sized<Shape>)
    return get<field::HalfSize>(values) * Pack<T>(per_spacing);
  else
    return {};
}

/// What stands for the argument that kernels without half sizes do not need.
template <class Shape, class T, int D>
constexpr HalfSizes<Shape, T, D> no_half_sizes() {
  static_assert(!sized<Shape>, "mote: this kernel depends on the particles' half sizes");
  return {};
}

/// Rows of half sizes, one number per particle and axis.
template <class Shape, class T, int D, int n>
class HalfSizeRows {
  struct Rows {
    alignas(64) T at[D][n];
  };
  [[no_unique_address]] std::conditional_t<sized<Shape>, Rows, NoHalfSizes> rows_;

 public:
  [[gnu::always_inline]] void put(int i, const HalfSizes<Shape, T, D>& half) {
    if constexpr (sized<Shape>)
      for (int a = 0; a < D; ++a) write(half[a], rows_.at[a] + i);
  }
  /// Of the pack from particle i on.
  [[gnu::always_inline]] HalfSizes<Shape, T, D> get(int i) const {
    HalfSizes<Shape, T, D> half;
    if constexpr (sized<Shape>)
      for (int a = 0; a < D; ++a) half[a] = read<Pack<T>>(rows_.at[a] + i);
    return half;
  }
};

}  // namespace mote::passes
