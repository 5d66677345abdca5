/// \file
/// What one particle costs in one step at least: operations and bytes of each phase, counted, not measured.
///
/// Conventions. An addition, a multiplication, a maximum, a rounding, a division and a root are one operation each, a
/// multiply-add two: so divisions and roots, which take longer, only lower the floor. Three dimensions, n-point kernels
/// contracted axis by axis (sum-factorised); only numbers that are wanted count, not the idle ones that round a record
/// up to eight. Constants of the material are free.
///
/// Bytes are those that pass between memory and core if nothing stays in a cache between two phases: a column that is
/// read moves once; one that is written moves twice, since its lines are fetched first. Node records count per node of
/// a tile's box, or per node of the grid, divided by the particles there: full cells of per_axis^3 particles.
#pragma once

#include <mote/mote.hpp>

#include "machine.hpp"

namespace bench {

struct Count {
  double flops = 0, bytes = 0;

  constexpr Count operator+(const Count& b) const { return {flops + b.flops, bytes + b.bytes}; }
  /// Seconds: the longer of operations at full rate and bytes at full bandwidth.
  template <class T>
  double floor(const Machine& m) const {
    return std::max(flops / m.flops<T>(), bytes / m.bandwidth_one);
  }
};

namespace detail {

/// Numbers of all fields in a list.
template <class... Tags>
constexpr double numbers(mote::fields<Tags...>) {
  return (0 + ... + Tags::shape::template components<3>);
}
template <class... Lists>
inline constexpr double numbers_of = numbers(mote::union_of<Lists...>{});

// ---- contractions of n^3 nodes for one number of a node; a sum of n products takes 2 n - 1 operations

/// sum w f: a sum for each of n^2 rows along z, n along y, one along x.
constexpr double gather_value(double n) { return (2 * n - 1) * (n * n + n + 1); }
/// sum w f and its three slopes: 2 sums along z in n^2 rows, 3 along y in n planes, 4 along x; 31 sums for n = 3.
constexpr double gather_slopes(double n) { return (2 * n - 1) * (2 * n * n + 3 * n + 4); }
/// First moments in addition to the value. Along its own axis a moment adds up the value's products w f times whole
/// numbers i - middle: 0, +-1 and, for n = 4, 2. At last three times sum w (x - x_p) f = sum w (x - middle) f - d f.
constexpr double gather_moments(double n) {
  const double own = n == 4 ? 3 : n - 2, other = 2 * n - 1;
  return n * n * own + n * (own + other) + own + 2 * other + 3 * 2;
}

/// w v added to n^3 nodes.
constexpr double scatter_value(double n) { return n + n * n + 2 * n * n * n; }
/// sum_a u_a b_a, with axis-wise weights u_a: along x three products, along y a b + c d and a product, along z two
/// multiply-adds.
constexpr double scatter_axes(double n) { return 3 * n + 4 * n * n + 4 * n * n * n; }
/// Both: one multiply-add more along x.
constexpr double scatter_value_and_axes(double n) { return scatter_axes(n) + 2 * n; }

/// Position in cells, the lowest node and the distance from it; weights, slopes if wanted, per axis (shape/*.hpp).
constexpr double weights(int n, bool slopes) {
  const double place = 5, values = n == 2 ? 1 : (n == 3 ? 9 : 20), derivatives = n == 2 ? 0 : (n == 3 ? 4 : 14);
  return 3 * (place + values + (slopes ? derivatives : 0));
}
/// w (i - x): a difference and a product per node and axis.
constexpr double moment_weights(double n) { return 3 * n * 2; }

// ---- the material of the scene: Mie-Grueneisen, von Mises, adiabatic; as written, and found the same by a number type
// that counts its own operations

/// Kinematics: det(I + A) 23, (I + A/2)^-1 69, the product with A 45, strain 6, rotation 52.
constexpr double kinematics = 23 + 69 + 45 + 6 + 52;
/// Q S Q^T 75, 2 G dev D and its sum 18; the return to the yield surface 33.
constexpr double radial_return = 75 + 18 + 33;
/// Volume and plastic work 5, temperature 21.
constexpr double update_material = kinematics + radial_return + 5 + 21;
/// Stress 12; volume over h 2, its product with nine components 9.
constexpr double force = 12 + 2 + 9;
/// For the time step: square of the sound speed 13, |v|^2 5, two roots, sum and maximum 2.
constexpr double speed = 13 + 5 + 2 + 2;

/// m v, and m h C.
constexpr double momentum(bool affine) { return affine ? 3 + 1 + 9 : 3; }

}  // namespace detail

/// The counts of a scheme. \tparam Mat the material's type
template <class Shape, class Transfer, class T, class Mat>
struct Counts {
  static constexpr int n = Shape::support;
  static constexpr bool affine = Transfer::affine, increment = Transfer::increment;
  static constexpr bool of_gradient = mote::detail::takes_gradient<Transfer>;  ///< and its change by the forces
  static constexpr bool by_slopes = affine && (Shape::inertia == 0 || of_gradient);  ///< C is the gradient
  static constexpr double number = sizeof(T);

  using Material = mote::particle_fields_of<Mat>;
  using Kept = mote::particle_fields_of<Transfer>;
  using X = mote::fields<mote::field::Position>;
  using V = mote::fields<mote::field::Velocity>;
  using M = mote::fields<mote::field::Mass>;
  using Stress = mote::fields<mote::field::VolumeRatio, mote::field::DeviatoricStress, mote::field::PlasticWork>;

  double per_cell;  ///< particles

  /// Of a tile's box, per particle: 4 cells along an axis reach 3 + n nodes.
  constexpr double box_nodes() const { return (3 + n) * (3 + n) * (3 + n) / (64 * per_cell); }
  constexpr double grid_nodes() const { return 1 / per_cell; }
  constexpr double bytes(double numbers_read, double numbers_written) const {
    return number * (numbers_read + 2 * numbers_written);
  }

  constexpr Count scatter() const {
    using namespace detail;
    const double p = affine ? scatter_value_and_axes(n) : scatter_value(n), f = scatter_axes(n), m = scatter_value(n);
    return {weights(n, true) + (affine ? moment_weights(n) : 0) + momentum(affine) + force + 3 * p + 3 * f + m,
            bytes(numbers_of<X, V, M, Kept, Stress>, 7 * box_nodes())};
  }
  /// Sums of the boxes, v = p/m and dt f/m, the sums of energies. Reads the boxes; writes mass and two velocities.
  constexpr Count grid() const {
    return {7 * box_nodes() + (1 + 3 + 3 * 2 + 3 + 10) * grid_nodes(), bytes(7 * box_nodes(), 7 * grid_nodes())};
  }
  /// USL: velocity, position and state.
  constexpr Count gather() const {
    using namespace detail;
    const double of_v = gather_slopes(n) + (affine && !by_slopes ? gather_moments(n) : 0);
    return {weights(n, true) + 3 * of_v + take_velocity() + deformation(),
            bytes((increment ? 6 : 3) * box_nodes(), numbers_of<X, V, Kept, Material>)};
  }
  /// MUSL: velocity, and its momentum to the boxes.
  constexpr Count remap() const {
    using namespace detail;
    const double of_v = by_slopes ? gather_slopes(n) : gather_value(n) + (affine ? gather_moments(n) : 0);
    const double p = affine ? scatter_value_and_axes(n) : scatter_value(n);
    return {weights(n, by_slopes) + (affine ? moment_weights(n) : 0) + 3 * of_v + take_velocity() + momentum(affine) +
                3 * p,
            bytes(numbers_of<X, M> + (increment ? 6 : 3) * box_nodes(), numbers_of<V, Kept> + 3 * box_nodes())};
  }
  /// MUSL: the second velocity field.
  constexpr Count second_grid() const {
    return {3 * box_nodes() + 4 * grid_nodes(), bytes(3 * box_nodes() + grid_nodes(), 3 * grid_nodes())};
  }
  /// MUSL: position from one field, state from the other.
  constexpr Count deform() const {
    using namespace detail;
    return {weights(n, true) + 3 * (gather_value(n) + gather_slopes(n)) + deformation(),
            bytes(numbers_of<V> + 6 * box_nodes(), numbers_of<X, Material>)};
  }

 private:
  /// C scaled, or v + blend (v_p + dv - v) with its own contraction of dv.
  constexpr double take_velocity() const {
    const double of_increment = of_gradient ? detail::gather_slopes(n) + 3 * 4 : detail::gather_value(n);
    return (affine ? 9 : 0) + (increment ? 3 * (4 + of_increment) : 0);
  }
  /// x + dt v, dt L, the material, the speed.
  constexpr double deformation() const { return 3 * 2 + 9 + detail::update_material + detail::speed; }
};

static_assert(detail::gather_slopes(3) == 31 * 5, "31 sums of three products");

}  // namespace bench
