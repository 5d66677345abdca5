/// \file
/// FLIP that carries an affine velocity field.
#pragma once

#include <mote/core/error.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::transfer {

/// FLIP for the velocity and for its gradient:
///
///   v_p <- sum w v + blend (v_p + sum w dv - sum w v),
///   C_p <- L + affine_blend (C_p + dL - L),   L = sum v (x) grad w,
///
/// and a particle brings v + C (x_i - x_p) to its nodes. The affine part continues the velocity with its slope to nodes
/// beyond a free surface, where FLIP alone brings a mean; the increments keep what a kernel smooths away, where APIC
/// loses it in every step, the gradient at a curved surface above all. On the paper's mesh the cavity so grows as on a
/// fine one (docs/accuracy.md). Blends just below one damp what the grid does not see, within 1/(1 - blend) steps.
///
/// Not for linear hats at free surfaces, whose gradient feeds the noise of tiny nodes back (update/musl.hpp).
/// A gradient that is kept does not see what a moving particle should, its change by -C C dt: a disc that spins five turns
/// keeps 65% of its kinetic energy, 96% with affine_blend = 0 (43% with FLIP, 89% with APIC; tests/stability/plane.cpp).
/// Where much turns, take affine_blend = 0, which costs the cavity 0.3% of its volume.
/// Conserves linear momentum; angular momentum not exactly, since C is the gradient. Needs field::Affine.
/// Source: Fei, Guo, Wu, Huang, Gao, ACM Trans. Graph. 40 (2021) 109 (increments beside an affine field); Nakamura,
/// Matsumura, Mizutani, CMAME 403 (2023) 115720 (the gradient as the affine field). The increment of C is our own.
struct AffineFlip {
  using role = mote::role::Transfer;
  using particle_fields = fields<field::Affine>;
  static constexpr bool affine = true;
  static constexpr bool increment = true;
  static constexpr bool gradient = true;

  double blend = 0.95;         ///< of the velocity, 0 to 1
  double affine_blend = 0.95;  ///< of its gradient, 0 to 1

  void validate() const {
    require(blend >= 0 && blend <= 1, "the FLIP blend is ", blend, "; it must be in [0, 1]");
    require(affine_blend >= 0 && affine_blend <= 1, "the blend of the gradient is ", affine_blend,
            "; it must be in [0, 1]");
  }

  double kept() const { return blend; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    auto& v = get<field::Velocity>(values);
    auto& c = get<field::Affine>(values);
    v = grid.pic + T(blend) * (v + grid.increment - grid.pic);
    c = grid.affine + T(affine_blend) * (c + grid.affine_increment - grid.affine);
  }
};

}  // namespace mote::transfer
