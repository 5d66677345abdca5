/// \file
/// The tensor-product kernels of a pack of particles, and the two contractions that every transfer is made of.
///
/// Both are sum-factorised. To gather, the lanes are the particles of a pack: those of one cell share their nodes, and
/// a node's number is spread over all of them. To scatter, the lanes are the numbers of a node's record.
#pragma once

#include <array>
#include <utility>

#include <mote/core/field.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/passes/tiles.hpp>

namespace mote::passes {

/// Calls f(0), ..., f(n - 1) with constants, unrolled.
template <int n, class F>
[[gnu::always_inline]] inline void unrolled(F&& f) {
  [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
    (f(std::integral_constant<int, i>{}), ...);
  }
  (std::make_integer_sequence<int, n>{});
}

/// Axis-wise weights of a pack of particles.
template <class T, int D, class Shape>
struct Stencil {
  static constexpr int support = Shape::support;
  /// First moments are taken about this node of the stencil, which does not enter them then.
  static constexpr int middle = (support - 1) / 2;

  Pack<T> value[D][support];  ///< w_i
  Pack<T> slope[D][support];  ///< d w_i / d xi
  Pack<T> offset[D];          ///< position in cells from the middle node

  /// \param f position in cells from the lowest node
  [[gnu::always_inline]] void set(int axis, const Pack<T>& f) {
    Shape::values(f, value[axis]);
    Shape::slopes(f, slope[axis]);
    offset[axis] = f - T(middle);
  }
};

/// The lowest nodes of a pack of particles within the tile's box.
///
/// A particle is in its tile's box by construction; the clamp keeps a last-bit difference between two inlinings of the
/// same expression, or a column that was written from outside, NaN too, from reaching beyond it.
template <class Shape, class T, int D>
struct LowestNodes {
  Vec<Pack<T>, D> base;  ///< coordinates
  int node[lanes];       ///< number in the box

  /// \param xi positions in cells, relative to the first node of the tile's block
  [[gnu::always_inline]] LowestNodes(const Vec<Pack<T>, D>& xi, const NodeBox<D>& box) {
    Pack<T> place = T(0);
    for (int a = 0; a < D; ++a) {
      const auto u = std::size_t(a);
      const Pack<T> lo(T(box.lo[u])), hi(T(box.lo[u] + box.extent[u] - Shape::support));
      base[a] = max(lo, min(hi, floor(Pack<T>(xi[a] - T(Shape::first)))));
      place += (base[a] - lo) * T(box.stride[u]);
    }
    to_integers(place, node);
  }
};

/// What particles gather of one node field: sum w f, the gradient per cell sum (dw/dxi_a) f, and the first moments
/// sum w (xi_i - xi_p)_a f.
template <class T, int D>
struct Sums {
  Pack<T> value, slope[D], moment[D];
};

/// Which sums are wanted.
struct Wanted {
  bool slopes, moments;
};

/// Sums over the nodes of one cell's particles along the axes from A on. Moments are about the middle node.
template <Wanted W, int A, class T, int D, class Shape>
[[gnu::always_inline]] inline Sums<T, D> contract(const T* at, const IVec<D>& stride,
                                                  const Stencil<T, D, Shape>& s) {
  Sums<T, D> sum;
  if constexpr (A == D) {
    sum.value = Pack<T>(*at);
  } else {
    constexpr int middle = Stencil<T, D, Shape>::middle, first_moment = middle == 0 ? 1 : 0;
    unrolled<Shape::support>([&](auto i) __attribute__((always_inline)) {
      const Sums<T, D> inner = contract<W, A + 1>(at + i * stride[A], stride, s);
      const auto add = [&](Pack<T>& to, const Pack<T>& term) __attribute__((always_inline)) {
        to = i == 0 ? term : Pack<T>(to + term);
      };
      const Pack<T> weighted = s.value[A][i] * inner.value;
      add(sum.value, weighted);
      if constexpr (W.slopes) add(sum.slope[A], s.slope[A][i] * inner.value);
      if constexpr (W.moments && i != middle) {
        const Pack<T> moment = i == middle + 1 ? weighted : Pack<T>(T(i - middle) * weighted);
        sum.moment[A] = i == first_moment ? moment : Pack<T>(sum.moment[A] + moment);
      }
      for (int b = A + 1; b < D; ++b) {
        if constexpr (W.slopes) add(sum.slope[b], s.value[A][i] * inner.slope[b]);
        if constexpr (W.moments) add(sum.moment[b], s.value[A][i] * inner.moment[b]);
      }
    });
  }
  return sum;
}

/// Sums of component c of a node field for particles of one cell; `field` is the lowest node's, with node_width<D>
/// numbers per node.
template <Wanted W, class T, int D, class Shape>
[[gnu::always_inline]] inline Sums<T, D> gather(const T* field, int c, const NodeBox<D>& box,
                                                const Stencil<T, D, Shape>& s) {
  IVec<D> stride;
  for (int a = 0; a < D; ++a) stride[a] = box.stride[std::size_t(a)] * grid::node_width<D>;
  Sums<T, D> sum = contract<W, 0>(field + c, stride, s);
  if constexpr (W.moments)
    for (int a = 0; a < D; ++a) sum.moment[a] -= s.offset[a] * sum.value;
  return sum;
}

/// Which axis-wise weights the numbers of a node's record take.
enum class AxisWeights {
  none,          ///< the record has a value only
  slope,         ///< dw/dxi
  moment,        ///< w (xi_i - xi_p)
  moment_slope,  ///< in turns: moment for even numbers of the record, slope for odd ones
};

/// The weights of a pack, particle by particle.
template <AxisWeights Kind, class T, int D, class Shape>
struct ScatterWeights {
  static constexpr int support = Shape::support, each = Kind == AxisWeights::moment_slope ? 2 : 1;
  alignas(64) T value[D][support][lanes];
  alignas(64) T axis[D][support][lanes][each];

  explicit ScatterWeights(const Stencil<T, D, Shape>& s) {
    for (int a = 0; a < D; ++a)
      for (int i = 0; i < support; ++i) {
        write(s.value[a][i], value[a][i]);
        const auto moment = [&] {
          return Pack<T>(s.value[a][i] * (T(i - Stencil<T, D, Shape>::middle) - s.offset[a]));
        };
        if constexpr (Kind == AxisWeights::slope) write(s.slope[a][i], axis[a][i][0]);
        if constexpr (Kind == AxisWeights::moment) write(moment(), axis[a][i][0]);
        if constexpr (Kind == AxisWeights::moment_slope) write_in_turns(moment(), s.slope[a][i], axis[a][i][0]);
      }
  }
};

/// What particle l brings to its nodes: a record that takes the weights w, and one per axis for the axis-wise weights.
template <class Record, int D>
struct Contribution {
  Record value, axis[D];
};

/// Adds sum over particles from `first` to `last`, which share their nodes, of w value + sum_a u_a axis[a], to the
/// records of those nodes; `at` is the lowest.
template <AxisWeights Kind, class Record, class T, int D, class Shape>
[[gnu::always_inline]] inline void scatter(T* at, const NodeBox<D>& box, const ScatterWeights<Kind, T, D, Shape>& w,
                                           const Contribution<Record, D>* of, int first, int last) {
  constexpr int n = Shape::support, width = int(Record::size()), planes = D == 3 ? n : 1, rows = D == 1 ? 1 : n;
  constexpr int y = D == 1 ? 0 : D - 2, z = D - 1;
  constexpr bool axes = Kind != AxisWeights::none;
  const auto value = [&](int a, int i, int l) __attribute__((always_inline)) { return Record(w.value[a][i][l]); };
  const auto axis = [&](int a, int i, int l) __attribute__((always_inline)) {
    return repeated<Record>(w.axis[a][i][l]);
  };
  // w a + u b
  const auto both = [&](int axis_number, int i, int l, const Record& a, const Record& b) __attribute__((always_inline)) {
    if constexpr (axes)
      return Record(value(axis_number, i, l) * a + axis(axis_number, i, l) * b);
    else
      return Record(value(axis_number, i, l) * a);
  };
  const std::ptrdiff_t row_stride = D == 1 ? 0 : std::ptrdiff_t(box.stride[std::size_t(y)]) * width;
  for (int i = 0; i < planes; ++i) {
    T* plane = at + (D == 3 ? std::ptrdiff_t(i) * box.stride[0] * width : 0);
    Record sum[rows][n];
    unrolled<rows>([&](auto j) __attribute__((always_inline)) {
      unrolled<n>([&](auto k) __attribute__((always_inline)) { sum[j][k] = read<Record>(plane + j * row_stride + k * width); });
    });
    for (int l = first; l < last; ++l) {
      Record a = of[l].value, along_y, along_z;
      if constexpr (axes) {
        along_y = of[l].axis[y];
        along_z = of[l].axis[z];
      }
      if constexpr (D == 3) {
        a = both(0, i, l, a, of[l].axis[0]);
        if constexpr (axes) along_y *= value(0, i, l), along_z *= value(0, i, l);
      }
      Record wk[n], uk[n];
      unrolled<n>([&](auto k) __attribute__((always_inline)) {
        wk[k] = value(z, k, l);
        if constexpr (axes) uk[k] = axis(z, k, l);
      });
      unrolled<rows>([&](auto j) __attribute__((always_inline)) {
        const Record aj = D == 1 ? a : both(y, j, l, a, along_y);
        Record bj;
        if constexpr (axes) bj = D == 1 ? along_z : Record(value(y, j, l) * along_z);
        unrolled<n>([&](auto k) __attribute__((always_inline)) {
          sum[j][k] += wk[k] * aj;
          if constexpr (axes) sum[j][k] += uk[k] * bj;
        });
      });
    }
    unrolled<rows>([&](auto j) __attribute__((always_inline)) {
      unrolled<n>([&](auto k) __attribute__((always_inline)) { write(sum[j][k], plane + j * row_stride + k * width); });
    });
  }
}

}  // namespace mote::passes
