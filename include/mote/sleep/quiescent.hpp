/// \file
/// Sleep of material that a wave has not reached yet.
#pragma once

#include <cmath>

#include <mote/core/error.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/sleep/concept.hpp>

namespace mote::sleep {

/// A tile (the particles of one block of 4^D cells) of one velocity and without stress sleeps while its neighbours are
/// like it: it is neither transferred nor updated, and moves as a whole. passes/sleep.hpp says when it wakes.
///
/// A particle's disturbance is the largest component of (v - v_ref)/c, sigma/(rho c^2) and, with an affine field, h
/// C/c, where c is its longitudinal speed of sound. What lies below the tolerance may be held up at the edge of what
/// sleeps. The default is the largest of 1, 2 and 5 times a power of ten with which every column of the cavity's
/// history agrees with that of a run without sleep to 1e-9 of its maximum: to 3.3e-10 (docs/performance.md,
/// bench/plot_sleep.py). The material must not change of itself at rest (creep, conduction), and there must be no
/// loads: a body force moves what is at rest.
struct Quiescent {
  using role = mote::role::Sleep;
  static constexpr bool sleeps = true;

  double tolerance = 2e-10;  ///< > 0
  bool enabled = true;       ///< false: like Never, for a program that leaves the choice to its user

  void validate() const {
    require(tolerance > 0 && tolerance < 1, "the tolerance of sleep is ", tolerance,
            "; it must be > 0 and < 1 (sleep::Never has none)");
  }

  /// The largest of (v - v_ref)/c, sigma/(rho c^2) and h C/c.
  template <class M, class V, class N, int D>
  typename V::number disturbance(const M& material, const V& values, const Vec<N, D>& v_ref, double spacing) const {
    using std::abs, std::max, std::sqrt;
    using T = typename V::number;
    const T over_c = T(1) / sqrt(material.sound_speed2(values));
    const SymTensor<T> stress = material.stress(values);
    T tension(0), speed(0);
    for (int i = 0; i < 6; ++i) tension = max(tension, T(abs(stress.c[i])));
    for (int i = 0; i < D; ++i) speed = max(speed, T(abs(T(get<field::Velocity>(values)[i] - T(v_ref[i])))));
    if constexpr (carries<V, field::Affine>)
      for (int i = 0; i < D * D; ++i)
        speed = max(speed, T(T(Scalar<T>(spacing)) * abs(component<field::Affine>(get<field::Affine>(values), i))));
    const T over_density = get<field::VolumeRatio>(values) * T(Scalar<T>(1 / material.rho0()));
    return max(T(speed * over_c), T(tension * over_density * over_c * over_c));
  }
};

}  // namespace mote::sleep
