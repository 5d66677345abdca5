/// \file
/// XPIC(m), the extended particle-in-cell transfer.
#pragma once

#include <mote/core/error.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::transfer {

/// V <- (1 - (1 - S S+)^m) V + S dv: a particle takes the grid's change of velocity like FLIP, and loses of its own
/// what the grid cannot see: noise in the null space of S+. m = 1 is PIC, which loses much more; m without limit is the
/// projection on what the grid can represent.
///
/// S takes a node field to the particles, S+ a particle field to the nodes with the lumped mass. The filter is
/// S sum_r (-1)^(r+1) C(m, r) (S+ S)^(r-1) v of the velocity v = S+ V before the forces, as published; computed is the
/// same sum as v + (1 - S+ S) v + ... + (1 - S+ S)^(m-1) v, whose terms do not grow with m and cancel no digits. Each
/// term is held to the planes, so that a wall stops what flies at it at once, as in PIC. Each order costs one transfer
/// to the particles and back.
///
/// Only the particles' velocities are filtered so. What moves and strains them is the lumped velocity after the forces,
/// as with FLIP: x += dt S v. (The paper moves them by dt (S v before the forces + half the change of V), half a step
/// earlier in time and not by the field that strains; here volumes follow positions.)
///
/// Conserves linear momentum exactly; angular momentum the filter does in the limit, the change S dv as little as FLIP.
/// Stable to the same Courant number as FLIP, measured for m up to 20. m = 2 already helps, 5 is a good compromise; the
/// authors find m > 40 unstable. Source: Hammerquist and Nairn, CMAME 318 (2017) 724.
struct Xpic {
  using role = mote::role::Transfer;
  static constexpr bool affine = false;
  static constexpr bool increment = false;
  static constexpr Sharpens sharpens = Sharpens::incoming;

  int order = 5;  ///< m; 1: PIC

  void validate() const {
    require(order >= 1 && order <= 40, "the XPIC order is ", order, "; it must be from 1 to 40");
  }

  double kept() const { return 0; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    get<field::Velocity>(values) = grid.sharp;
  }
};

}  // namespace mote::transfer
