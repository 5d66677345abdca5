/// \file
/// The tensor-product kernels of a pack of particles, and the two contractions that every transfer is made of.
///
/// Both are sum-factorised. To gather, the lanes are the particles of a pack: those of one cell share their nodes, and
/// a node's number is spread over all of them. To scatter, the lanes are the numbers of a node's record.
#pragma once

#include <type_traits>
#include <utility>

#include <mote/core/field.hpp>
#include <mote/core/rearrange.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/passes/half_sizes.hpp>
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
  [[gnu::always_inline]] void set(int axis, const Pack<T>& f, [[maybe_unused]] const HalfSizes<Shape, T, D>& half) {
    if constexpr (sized<Shape>) {
      Shape::values(f, half[axis], value[axis]);
      Shape::slopes(f, half[axis], slope[axis]);
    } else {
      Shape::values(f, value[axis]);
      Shape::slopes(f, slope[axis]);
    }
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

  void clear() {
    value = T(0);
    for (int a = 0; a < D; ++a) slope[a] = moment[a] = Pack<T>(T(0));
  }
};

/// Which sums are wanted.
struct Wanted {
  bool slopes, moments;
};

/// Sums over the nodes of one cell's particles along the axes from A on. Moments are about the middle node.
template <Wanted W, int A, class T, int D, class Shape>
[[gnu::always_inline]] inline Sums<T, D> contract(const T* at, const IVec<D>& stride, const Stencil<T, D, Shape>& s) {
  Sums<T, D> sum;
  if constexpr (A == D) {
    sum.value = Pack<T>(*at);
  } else {
    const auto add_node = [&](auto i, auto first) __attribute__((always_inline)) {
      const Sums<T, D> inner = contract<W, A + 1>(at + i * stride[A], stride, s);
      const auto add = [&](Pack<T> & to, const Pack<T>& term) __attribute__((always_inline)) {
        to = first ? term : Pack<T>(to + term);
      };
      const Pack<T> weighted = s.value[A][i] * inner.value;
      add(sum.value, weighted);
      if constexpr (W.slopes) add(sum.slope[A], s.slope[A][i] * inner.value);
      if constexpr (W.moments) {
        const int arm = i - Stencil<T, D, Shape>::middle;
        if (arm != 0) add(sum.moment[A], arm == 1 ? weighted : Pack<T>(T(arm) * weighted));
      }
      for (int b = A + 1; b < D; ++b) {
        if constexpr (W.slopes) add(sum.slope[b], s.value[A][i] * inner.slope[b]);
        if constexpr (W.moments) add(sum.moment[b], s.value[A][i] * inner.moment[b]);
      }
    };
    if constexpr (A == 0 && D == 3) {  // a loop: unrolled too, the code would not fit
      sum.clear();
      for (int i = 0; i < Shape::support; ++i) add_node(i, std::false_type{});
    } else {
      if constexpr (W.moments && Stencil<T, D, Shape>::middle == 0) sum.moment[A] = Pack<T>(T(0));
      unrolled<Shape::support>([&](auto i)
                                   __attribute__((always_inline)) { add_node(i, std::bool_constant<i == 0>{}); });
    }
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

/// The node that gets what is left of a sum over all nodes when the others have had their part, or -1. The weights sum
/// to one, so the sum itself takes no weight at all; what is left is accurate where its weight is never small.
template <class Shape>
inline constexpr int rest = Shape::support > 2 ? Stencil<double, 1, Shape>::middle : -1;

/// Adds, for the particles from `first` to `last`, which share their nodes, w value + sum_a u_a axis[a] to the records
/// of those nodes; `at` is the lowest.
template <AxisWeights Kind, class Record, class T, int D, class Shape>
class Scatter {
  static constexpr int n = Shape::support, width = int(Record::size()), rows = D == 1 ? 1 : n, y = D - 2, z = D - 1;
  static constexpr bool axes = Kind != AxisWeights::none;
  /// Planes of nodes that one sweep over the particles serves: as many as registers hold.
  static constexpr int at_once = D == 3 && n == 2 ? 2 : 1;
  using Plane = Record[rows][n];

  const ScatterWeights<Kind, T, D, Shape>& w_;
  const Contribution<Record, D>* of_;
  int first_, last_;

 public:
  [[gnu::always_inline]] Scatter(const ScatterWeights<Kind, T, D, Shape>& w, const Contribution<Record, D>* of,
                                 int first, int last)
      : w_(w), of_(of), first_(first), last_(last) {}

  [[gnu::always_inline]] void operator()(T* at, const NodeBox<D>& box) const {
    const std::ptrdiff_t row = D == 1 ? 0 : std::ptrdiff_t(box.stride[std::size_t(D == 1 ? 0 : y)]) * width,
                         plane = D == 3 ? std::ptrdiff_t(box.stride[0]) * width : 0;
    Plane sum[at_once];
    if constexpr (D < 3 || at_once == n) {
      add_up<false>(sum, 0);
      for (int i = 0; i < at_once; ++i) add(sum[i], at + i * plane, row);
    } else {
      Plane others;
      for_each_node([&](int j, int k) { others[j][k] = Record(0); });
      for (int i = 0; i < n; ++i) {
        if (i == rest<Shape>) continue;
        add_up<false>(sum, i);
        for_each_node([&](int j, int k) __attribute__((always_inline)) { others[j][k] += sum[0][j][k]; });
        add(sum[0], at + i * plane, row);
      }
      add_up<true>(sum, rest<Shape>);
      for_each_node([&](int j, int k) __attribute__((always_inline)) { sum[0][j][k] -= others[j][k]; });
      add(sum[0], at + rest<Shape> * plane, row);
    }
  }

 private:
  template <class F>
  [[gnu::always_inline]] static void for_each_node(F&& f) {
    unrolled<rows * n>([&](auto c) __attribute__((always_inline)) { f(c / n, c % n); });
  }
  [[gnu::always_inline]] static void add(const Plane& sum, T* at, std::ptrdiff_t row) {
    for_each_node([&](int j, int k) __attribute__((always_inline)) {
      T* to = at + j * row + k * width;
      write(Record(read<Record>(to) + sum[j][k]), to);
    });
  }

  [[gnu::always_inline]] Record value(int axis, int i, int l) const { return Record(w_.value[axis][i][l]); }
  [[gnu::always_inline]] Record slope(int axis, int i, int l) const { return repeated<Record>(w_.axis[axis][i][l]); }
  /// w a + u b
  [[gnu::always_inline]] Record both(int axis, int i, int l, const Record& a, const Record& b) const {
    if constexpr (axes)
      return value(axis, i, l) * a + slope(axis, i, l) * b;
    else
      return value(axis, i, l) * a;
  }

  /// The sums over the particles of the planes from i on (in three dimensions).
  template <bool rest_of_planes>
  [[gnu::always_inline]] void add_up(Plane (&sum)[at_once], int i) const {
    for (auto& plane : sum) for_each_node([&](int j, int k) { plane[j][k] = Record(0); });
    for (int l = first_; l < last_; ++l)
      unrolled<at_once>([&](auto m) __attribute__((always_inline)) {
        const int plane = i + m;
        Record a = of_[l].value, along_y{}, along_z{};
        if constexpr (axes) {
          along_y = of_[l].axis[D == 1 ? 0 : y];
          along_z = of_[l].axis[z];
        }
        if constexpr (D == 3 && !rest_of_planes) {
          a = both(0, plane, l, a, of_[l].axis[0]);
          if constexpr (axes) along_y *= value(0, plane, l), along_z *= value(0, plane, l);
        }
        add_plane(sum[m], l, a, along_y, along_z);
      });
    if constexpr (rest<Shape> >= 0) leave_rest(sum[0]);
  }

  /// From the sum over a row or column to what is left for the node that gets the rest.
  [[gnu::always_inline]] static void leave_rest(Plane& sum) {
    constexpr int r = rest<Shape>;
    for_each_node([&](int j, int k) __attribute__((always_inline)) {
      if (k != r) sum[j][r] -= sum[j][k];
    });
    if constexpr (D > 1)
      for_each_node([&](int j, int k) __attribute__((always_inline)) {
        if (j != r) sum[r][k] -= sum[j][k];
      });
  }

  [[gnu::always_inline]] void add_plane(Plane& sum, int l, const Record& a, const Record& along_y,
                                        const Record& along_z) const {
    unrolled<rows>([&](auto j) __attribute__((always_inline)) {
      constexpr bool as_is = D == 1 || j == rest<Shape>;
      Record aj = a, bj = along_z;
      if constexpr (!as_is) {
        aj = both(y, j, l, a, along_y);
        if constexpr (axes) bj = value(y, j, l) * along_z;
      }
      unrolled<n>([&](auto k) __attribute__((always_inline)) {
        if constexpr (k == rest<Shape>) {
          sum[j][k] += aj;
        } else {
          sum[j][k] += value(z, k, l) * aj;
          if constexpr (axes) sum[j][k] += slope(z, k, l) * bj;
        }
      });
    });
  }
};

}  // namespace mote::passes
