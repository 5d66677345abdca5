/// \file
/// Compressible neo-Hookean elasticity: rubber, and the published manufactured solutions.
#pragma once

#include <mote/core/pack.hpp>
#include <mote/strength/concept.hpp>

namespace mote::strength {

/// sigma = mu/J (b - I), of the energy mu/2 (tr b - 3 - 2 ln J) per initial volume; b = F F^T.
///
/// Together with eos::LogarithmicBulk{.bulk_modulus = lambda} it is the neo-Hookean solid sigma = mu/J (b - I) +
/// lambda ln J/J I of Young's modulus E = mu (3 lambda + 2 mu)/(lambda + mu): mu and lambda are Lame's constants, and
/// since b has a trace the bulk modulus at rest is lambda + 2/3 mu. In uniaxial strain with lambda = 0 the nominal
/// stress is mu (F - 1/F): the bar of Steffen et al. (2008) with mu = E/2.
///
/// Needs field::LeftCauchyGreen and field::VolumeRatio. Exact for any increment; J is what the increments multiply up
/// to, b too, each to round-off.
/// Source: Bonet and Wood, Nonlinear Continuum Mechanics (1997), eq. 5.28 and 5.29.
struct NeoHookean {
  using role = mote::role::Strength;
  using particle_fields = fields<field::LeftCauchyGreen, field::VolumeRatio>;

  double shear_modulus;  ///< mu, Pa, > 0

  void validate() const { require(shear_modulus > 0, "the shear modulus is ", shear_modulus, " Pa; it must be > 0"); }

  template <class V>
  void initialise(V& values) const {
    using T = typename V::number;
    get<field::LeftCauchyGreen>(values) = {{T(1), T(1), T(1), T(0), T(0), T(0)}};
  }

  template <class V, class T>
  void update(V& values, const Kinematics<T>& k) const {
    auto& b = get<field::LeftCauchyGreen>(values);
    b = rotate(Mat<T, 3>::identity() + k.increment, b);
  }

  /// Its part of the Cauchy stress, Pa, with a trace.
  template <class V>
  auto stress(const V& values) const {
    using T = typename V::number;
    return add_diagonal(get<field::LeftCauchyGreen>(values), T(-1)) *
           (T(shear_modulus) / get<field::VolumeRatio>(values));
  }

  /// mu/2 (tr b - 3 - 2 ln J), J/m^3 of initial volume.
  template <class V>
  auto elastic_energy(const V& values) const {
    using T = typename V::number;
    using std::log;
    const T stretched = trace(get<field::LeftCauchyGreen>(values)) - T(3);
    return T(T(0.5 * shear_modulus) * (stretched - T(2) * log(get<field::VolumeRatio>(values))));
  }

  /// rho0 c^2 of the fastest wave, Pa, where the volume alone makes `bulk` of it: mu (largest eigenvalue of b) + (mu +
  /// bulk, or 0 where that is negative and transverse waves are faster).
  ///
  /// The acoustic tensor along n is rho0 Q = mu (n . b n) I + (mu + lambda (1 - ln J)) n n^T. On a grid of one or two
  /// dimensions only n in the grid counts, and the eigenvalue is exact; in three it is taken as tr b/3 + sqrt(2/3)
  /// |dev b|: exact for a body stretched along one axis, too large by at most a third of tr b.
  template <class V, class T>
  T wave_modulus(const V& values, const T& bulk) const {
    using std::max;
    return T(shear_modulus) * largest(values) + max(T(shear_modulus) + bulk, T(0));
  }

  friend bool operator==(const NeoHookean&, const NeoHookean&) = default;

 private:
  /// The largest n . b n of directions in the grid, or a bound.
  template <class V>
  static auto largest(const V& values) {
    using T = typename V::number;
    using std::sqrt;
    const auto& b = get<field::LeftCauchyGreen>(values);
    if constexpr (V::dimension == 1) {
      return b(0, 0);
    } else if constexpr (V::dimension == 2) {
      const T mean = T(0.5) * (b(0, 0) + b(1, 1)), half = T(0.5) * (b(0, 0) - b(1, 1));
      return T(mean + sqrt(half * half + b(0, 1) * b(0, 1)));
    } else {
      const SymTensor<T> d = deviator(b);
      return T(T(1.0 / 3) * trace(b) + sqrt(T(2.0 / 3) * ddot(d, d)));
    }
  }
};

}  // namespace mote::strength
