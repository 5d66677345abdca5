/// \file
/// FLIP, with a blend towards PIC.
#pragma once

#include <mote/core/error.hpp>
#include <mote/transfer/concept.hpp>

namespace mote::transfer {

/// v_p <- blend (v_p + sum w dv) + (1 - blend) sum w v: a particle takes the grid's change of velocity (FLIP), or a
/// part `1 - blend` of the velocity itself (PIC, which damps). Conserves linear momentum; dissipates almost nothing,
/// and so keeps the noise of single particles. Source: Brackbill and Ruppel, JCP 65 (1986) 314.
struct Flip {
  using role = mote::role::Transfer;
  static constexpr bool affine = false;
  static constexpr bool increment = true;

  double blend = 1;  ///< 1: FLIP, 0: PIC

  void validate() const { require(blend >= 0 && blend <= 1, "the FLIP blend is ", blend, "; it must be in [0, 1]"); }

  double kept() const { return blend; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    auto& v = get<field::Velocity>(values);
    v = grid.pic + T(blend) * (v + grid.increment - grid.pic);
  }
};

}  // namespace mote::transfer
