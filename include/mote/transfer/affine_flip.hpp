/// \file
/// FLIP that carries an affine velocity field.
#pragma once

#include <mote/core/error.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::transfer {

/// FLIP that carries the velocity gradient:
///
///   v_p <- sum w v + blend (v_p + sum w dv - sum w v),   C_p <- L (1 + dt L)^-1,   L = sum v (x) grad w,
///
/// and a particle brings v + C (x_i - x_p) to its nodes. The affine part continues the velocity with its slope to nodes
/// beyond a free surface, where FLIP alone brings a mean. C is the gradient at the particle's new place, with respect
/// to x + dt v (here to dt^2): dust that flies apart so keeps the account of its volume, and what spins its energy.
/// A blend just below one damps what the grid does not see, within 1/(1 - blend) steps.
///
/// The change of velocity dv = dt f/m of the lumped masses belongs to the centres of mass of what the nodes carry, and
/// at a free surface these lie within, so that what lies beyond is pulled too little. So dv is sharpened
/// (passes/sharpen.hpp): `order` terms of the consistent mass matrix's inverse, dv + (1 - S+ S) dv + ... The last is
/// weighed by `tail`: with two terms, 1 + tail (1 - b) stands for 1/b, b what S+ S takes of a mode, and 5/4 makes it
/// right for b = 4/5, waves of some seven cells, too much by 1.3% at most for longer ones (1: too little, by
/// (1 - b)^2, which is better for smooth waves on many cells). Two terms bring the volume of the paper's cavity on its
/// own mesh to 0.8% from the converged one, from 2 to 3% (docs/accuracy.md). They make a stiffer grid: with quadratic
/// splines a bar stays quiet up to a Courant number of 0.75, instead of 1.
///
/// Not for linear hats at free surfaces, whose gradient feeds the noise of tiny nodes back (update/musl.hpp).
/// Conserves linear momentum; angular momentum not exactly, since C is the gradient. Needs field::Affine.
/// Source: Fei, Guo, Wu, Huang, Gao, ACM Trans. Graph. 40 (2021) 109 (increments beside an affine field); Nakamura,
/// Matsumura, Mizutani, CMAME 403 (2023) 115720 (the gradient as the affine field). The gradient's way to the new place
/// and the sharpened change are our own.
struct AffineFlip {
  using role = mote::role::Transfer;
  using particle_fields = fields<field::Affine>;
  static constexpr bool affine = true;
  static constexpr bool increment = true;
  static constexpr bool gradient = true;
  static constexpr Sharpens sharpens = Sharpens::change;

  double blend = 0.85;  ///< of the velocity, 0 to 1
  int order = 2;        ///< terms of the change of velocity; 1: that of the lumped mass
  double tail = 1.25;   ///< weight of the last of two terms or more, 1 to 2

  void validate() const {
    require(blend >= 0 && blend <= 1, "the FLIP blend is ", blend, "; it must be in [0, 1]");
    require(order >= 1 && order <= 40, "the order of the change of velocity is ", order, "; it must be from 1 to 40");
    require(tail >= 1 && tail <= 2, "the weight of the last term is ", tail, "; it must be in [1, 2]");
  }

  double kept() const { return blend; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    auto& v = get<field::Velocity>(values);
    const Mat<T, D>& l = grid.affine;
    const T dt = T(grid.dt);
    v = grid.pic + T(blend) * (v + grid.increment - grid.pic);
    get<field::Affine>(values) = l - dt * (l * (l - dt * (l * l)));
  }
};

}  // namespace mote::transfer
