/// \file
/// What a transfer offers: what a particle keeps of the grid's velocity field.
#pragma once

#include <concepts>

#include <mote/core/field.hpp>
#include <mote/core/role.hpp>

namespace mote {

/// What the grid offers a particle; all sums over its nodes.
template <class T, int D>
struct GridVelocity {
  double dt;            ///< length of the step, s
  Vec<T, D> pic;        ///< sum w v, m/s
  Vec<T, D> increment;  ///< sum w (v - v before the forces), m/s; only if the transfer states `increment`
  Vec<T, D> sharp;      ///< sum w (v + corrections of v before the forces), m/s; only with Sharpens::incoming
  Mat<T, D> affine;     ///< D^-1-weighted moment sum w v (x_i - x_p)^T, or sum v grad w where D is singular, 1/s;
                        ///< only if the transfer states `affine`
};

namespace detail {
template <class X>
inline constexpr bool takes_gradient = false;
template <class X>
requires requires { X::gradient; }
inline constexpr bool takes_gradient<X> = X::gradient;
}  // namespace detail

/// Which of the grid's velocities a transfer sharpens. A lumped mass smooths: to the particles and back, S+ S, takes a
/// field not to itself. Sharpening adds what that lost, and what is lost of that: sum (1 - S+ S)^j v, 0 < j < order.
enum class Sharpens {
  nothing,
  incoming,  ///< the velocity before the forces, in what the particles take (GridVelocity::sharp); not what moves them
  change,    ///< the change of velocity by the forces
  grid,      ///< every velocity of the grid, as a better inverse of its mass matrix would
};

/// X::sharpens, if a transfer says so (then x.order, too), or nothing.
template <class X>
inline constexpr Sharpens sharpens = Sharpens::nothing;
template <class X>
requires requires { X::sharpens; }
inline constexpr Sharpens sharpens<X> = X::sharpens;

/// The weight of the last term of a transfer that sharpens: x.tail, if it has one. It stands for all that are cut off.
template <class X>
double tail(const X& x) {
  if constexpr (requires { x.tail; }) return x.tail;
  return 1;
}

/// X::affine       whether particles carry field::Affine and momentum m w (v + C (x_i - x_p)) goes to the grid
/// X::increment    whether particles take the grid's change of velocity
/// X::gradient     optional: whether the affine matrix is the velocity gradient with every kernel
/// X::sharpens     optional, see above; x.order is then the number of terms, x.tail (optional) the weight of the last
/// x.kept()        the part of its own velocity that a particle keeps, 0 to 1
/// x.update(values, grid)    sets the particle's field::Velocity (and field::Affine)
template <class X>
concept Transfer = HasRole<X, role::Transfer> && requires(const X& x) {
  { x.kept() } -> std::convertible_to<double>;
  { X::affine } -> std::convertible_to<bool>;
  { X::increment } -> std::convertible_to<bool>;
  requires requires(Values<double, 1, fields<field::Velocity, field::Affine>> values, GridVelocity<double, 1> grid) {
    x.update(values, grid);
  };
};

}  // namespace mote
