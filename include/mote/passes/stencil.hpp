/// \file
/// The tensor-product kernels of a pack of particles, and the two contractions that every transfer is made of.
///
/// A node record has two halves of node_width<D> numbers each. One pass over a particle's nodes gathers (or scatters)
/// both: `value` weights w w w apply to the whole record, `slope` weights are the derivative of w along one axis in one
/// half and, for affine transfers, its first moment w (i - f) in the other.
#pragma once

#include <array>

#include <mote/core/field.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/passes/tiles.hpp>

namespace mote::passes {

/// Which weights the two halves of a node record get in the axis-wise contraction.
enum class Halves { slope_slope, slope_moment, moment_slope };

/// Weights and first nodes of up to eight particles.
template <class T, int D, class Shape>
struct Stencil {
  static constexpr int support = Shape::support;
  static constexpr int width = 2 * grid::node_width<D>;
  using Record = Simd<T, width>;

  alignas(64) T value[D][support][lanes];
  alignas(64) T slope[D][support][lanes];
  alignas(64) T moment[D][support][lanes];
  int node[lanes];         ///< the lowest node's number in the tile's box
  int relative[D][lanes];  ///< the lowest node relative to the tile's block

  /// \param xi positions in cells, relative to the first node of the tile's block
  template <bool Slopes, bool Moments>
  void set(const Vec<Pack<T>, D>& xi, const NodeBox<D>& box) {
    for (int l = 0; l < lanes; ++l) node[l] = 0;
    for (int a = 0; a < D; ++a) {
      const auto u = std::size_t(a);
      const Pack<T> base = inside(floor(Pack<T>(xi[a] - T(Shape::first)), relative[a]), box.lo[u],
                                  box.lo[u] + box.extent[u] - support, relative[a]);
      const Pack<T> f = xi[a] - base;
      for (int l = 0; l < lanes; ++l) node[l] += (relative[a][l] - box.lo[u]) * box.stride[u];
      Pack<T> w[support], d[support];
      Shape::values(f, w);
      if constexpr (Slopes) Shape::slopes(f, d);
      for (int i = 0; i < support; ++i) {
        write(w[i], value[a][i]);
        if constexpr (Slopes) write(d[i], slope[a][i]);
        if constexpr (Moments) write(Pack<T>(w[i] * (T(i) - f)), moment[a][i]);
      }
    }
  }

  /// The lowest nodes only.
  void locate(const Vec<Pack<T>, D>& xi) {
    for (int a = 0; a < D; ++a) floor(Pack<T>(xi[a] - T(Shape::first)), relative[a]);
  }

  /// Axis-wise weights of one particle for both halves.
  template <Halves H>
  [[gnu::always_inline]] Record axis_weight(int a, int i, int l) const {
    if constexpr (H == Halves::slope_slope) {
      return Record(slope[a][i][l]);
    } else {
      constexpr bool slope_first = H == Halves::slope_moment;
      const T first = slope_first ? slope[a][i][l] : moment[a][i][l],
              second = slope_first ? moment[a][i][l] : slope[a][i][l];
      return mote::halves<T, width>(first, second);
    }
  }

 private:
  /// A particle is in its tile's box by construction; the clamp keeps a last-bit difference between two inlinings of
  /// the same expression, or a column that was written from outside, from reaching beyond it.
  static Pack<T> inside(const Pack<T>& base, int lo, int hi, int (&whole)[lanes]) {
    for (int& w : whole) w = std::clamp(w, lo, hi);
    return max(min(base, Pack<T>(hi)), Pack<T>(lo));
  }
};

/// What a particle gathers from its nodes: the value and, per axis, the axis-wise contraction.
template <class Record, int D>
struct Gathered {
  Record value;
  Record axis[D];
};

/// Sums over the nodes of particle l: sum-factorised, last axis first. `nodes` points at the tile's box.
template <bool Axes, Halves H, class T, int D, class Shape>
[[gnu::always_inline]] inline auto gather(const T* nodes, const NodeBox<D>& box, const Stencil<T, D, Shape>& s, int l) {
  using Record = typename Stencil<T, D, Shape>::Record;
  constexpr int n = Shape::support, width = Stencil<T, D, Shape>::width, z = D - 1;
  Gathered<Record, D> sum{};
  const T* first = nodes + std::ptrdiff_t(s.node[l]) * width;
  Record w[n], u[n];
  for (int k = 0; k < n; ++k) {
    w[k] = Record(s.value[z][k][l]);
    if constexpr (Axes) u[k] = s.template axis_weight<H>(z, k, l);
  }
  const auto row = [&](const T* at, Record& value, Record& along) __attribute__((always_inline)) {
    Record node = read<Record>(at);
    value = w[0] * node;
    if constexpr (Axes) along = u[0] * node;
    for (int k = 1; k < n; ++k) {
      node = read<Record>(at + k * width);
      value += w[k] * node;
      if constexpr (Axes) along += u[k] * node;
    }
  };
  if constexpr (D == 1) {
    row(first, sum.value, sum.axis[0]);
  } else {
    const auto plane = [&](const T* at, Record& value, Record& along_y, Record& along_z)
        __attribute__((always_inline)) {
      constexpr int y = D - 2;
      value = along_y = along_z = Record(0);
      for (int j = 0; j < n; ++j) {
        Record a, b;
        row(at + j * box.stride[std::size_t(y)] * width, a, b);
        const Record wj(s.value[y][j][l]);
        value += wj * a;
        if constexpr (Axes) {
          along_y += s.template axis_weight<H>(y, j, l) * a;
          along_z += wj * b;
        }
      }
    };
    if constexpr (D == 2) {
      plane(first, sum.value, sum.axis[0], sum.axis[1]);
    } else {
      sum.value = sum.axis[0] = sum.axis[1] = sum.axis[2] = Record(0);
      for (int i = 0; i < n; ++i) {
        Record a, b, c;
        plane(first + i * box.stride[0] * width, a, b, c);
        const Record wi(s.value[0][i][l]);
        sum.value += wi * a;
        if constexpr (Axes) {
          sum.axis[0] += s.template axis_weight<H>(0, i, l) * a;
          sum.axis[1] += wi * b;
          sum.axis[2] += wi * c;
        }
      }
    }
  }
  return sum;
}

/// Adds to the nodes of particle l: value weights times `value` plus (with Axes), per axis, axis-wise weights times
/// axis[a].
template <bool Axes, Halves H, class T, int D, class Shape, class Record>
[[gnu::always_inline]] inline void scatter(T* nodes, const NodeBox<D>& box, const Stencil<T, D, Shape>& s, int l,
                                           const Record& value, const Record (&axis)[D]) {
  constexpr int n = Shape::support, width = int(Record::size()), z = D - 1;
  T* first = nodes + std::ptrdiff_t(s.node[l]) * width;
  Record w[n], u[n];
  for (int k = 0; k < n; ++k) {
    w[k] = Record(s.value[z][k][l]);
    u[k] = Axes ? s.template axis_weight<H>(z, k, l) : w[k];
  }
  const auto add = [&](Record sum, const Record& more) __attribute__((always_inline)) {
    if constexpr (Axes) sum += more;
    return sum;
  };
  const auto row = [&](T * at, const Record& value_xy, const Record& along) __attribute__((always_inline)) {
    for (int k = 0; k < n; ++k)
      write(Record(read<Record>(at + k * width) + add(w[k] * value_xy, u[k] * along)), at + k * width);
  };
  if constexpr (D == 1) {
    row(first, value, axis[0]);
  } else {
    constexpr int y = D - 2;
    const auto plane = [&](T * at, const Record& value_x, const Record& along_y, const Record& along_z)
        __attribute__((always_inline)) {
      for (int j = 0; j < n; ++j) {
        const Record wj(s.value[y][j][l]);
        row(at + j * box.stride[std::size_t(y)] * width,
            add(wj * value_x, s.template axis_weight<H>(y, j, l) * along_y), wj * along_z);
      }
    };
    if constexpr (D == 2) {
      plane(first, value, axis[0], axis[1]);
    } else {
      for (int i = 0; i < n; ++i) {
        const Record wi(s.value[0][i][l]);
        plane(first + i * box.stride[0] * width, add(wi * value, s.template axis_weight<H>(0, i, l) * axis[0]),
              wi * axis[1], wi * axis[2]);
      }
    }
  }
}

}  // namespace mote::passes
