/// \file
/// APIC, the affine particle-in-cell transfer.
#pragma once

#include <mote/transfer/concept.hpp>

namespace mote::transfer {

/// v_p <- sum w v, C_p <- (sum w v (x_i - x_p)^T) D^-1: a particle carries a locally affine velocity field.
///
/// Conserves linear and, with kernels whose D = inertia h^2 is constant (quadratic and cubic B-splines), angular
/// momentum. Filters what is not affine within a kernel, so it is quiet and dissipative. For linear hats D is singular
/// at nodes; there C = sum v (x) grad w, which gives up exact angular momentum. Needs field::Affine. Source: Jiang,
/// Schroeder, Teran, JCP 338 (2017) 137.
struct Apic {
  using role = mote::role::Transfer;
  using particle_fields = fields<field::Affine>;
  static constexpr bool affine = true;
  static constexpr bool increment = false;

  double kept() const { return 0; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    get<field::Velocity>(values) = grid.pic;
    get<field::Affine>(values) = grid.affine;
  }
};

}  // namespace mote::transfer
