/// \file
/// FMPM(k), the transfer with an approximate inverse of the full mass matrix.
#pragma once

#include <mote/core/error.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::transfer {

/// v <- sum_(j<k) (1 - S+ S)^j v, V <- S v: the grid's velocities are those of the consistent mass matrix, to k terms
/// of its inverse's series, and a particle takes them as they are (PIC).
///
/// The consistent matrix is m S+ S with the lumped masses m. The published form of the sum is
/// sum_l (-1)^(l+1) C(k, l) (S+ S)^(l-1) v, by v*_l = ((k-l+1)/l) S+ S v*_(l-1) from v*_1 = k v; the increments used
/// here are those of arXiv:2604.07307. Each term is held to the planes and costs one transfer to the particles and
/// back.
///
/// One and the same field gives the particles' velocities, moves them, x += dt S v, and strains them; so do those that
/// update::Usf strains by, from the incoming momentum, and update::Musl, from the remapped one. (The paper moves
/// particles by the mean of V before and after.) k = 1 is the lumped mass: PIC. Conserves linear momentum exactly,
/// angular momentum in the limit. A consistent mass makes a stiffer grid: with linear hats in one dimension, two
/// particles per cell, a bar stays quiet up to Courant numbers of 0.90, 0.60, 0.55, 0.50 and 0.45 for k = 1, 2, 3, 5 and
/// 10 (update::Usl; FLIP: 0.75). Source: Nairn and Hammerquist, CMAME 377 (2021) 113667.
struct Fmpm {
  using role = mote::role::Transfer;
  static constexpr bool affine = false;
  static constexpr bool increment = false;
  static constexpr Sharpens sharpens = Sharpens::grid;

  int order = 2;  ///< k; 1: PIC

  void validate() const {
    require(order >= 1 && order <= 40, "the FMPM order is ", order, "; it must be from 1 to 40");
  }

  double kept() const { return 0; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    get<field::Velocity>(values) = grid.pic;
  }
};

}  // namespace mote::transfer
