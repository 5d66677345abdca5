/// \file
/// Von Mises plasticity on multiplicative logarithmic strain, with linear isotropic hardening.
#pragma once

#include <mote/core/spectral.hpp>
#include <mote/strength/radial_return.hpp>

namespace mote::strength {

/// F = F_e F_p, b_e = F_e F_e^T; h = dev(ln b_e)/2 is the elastic strain and J s = 2 G h the Kirchhoff stress (Hencky).
///
/// One increment moves b_e by (I + A) b_e (I + A)^T, and a radial return in h, which leaves its principal axes alone,
/// brings the stress back to sqrt(3/2) |s| = Y + H eps_p. So the elastic part has an energy, takes no work on closed
/// paths, whatever their steps, and is exact for any increment and under any rotation. The Jaumann rate of
/// strength::VonMises costs a sixth of it and agrees to second order in the elastic strain; where yield keeps that
/// small it is enough.
///
/// Needs field::DeviatoricStress, field::PlasticStrain and field::VolumeRatio: h is kept as the stress that it makes,
/// so that nothing is stored beyond the fields of strength::VonMises. Source: Simo, CMAME 99 (1992) 61; Weber and
/// Anand, CMAME 79 (1990) 173.
struct VonMisesLogarithmic {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::PlasticStrain, field::VolumeRatio>;

  double shear_modulus;  ///< G of the Kirchhoff stress, Pa, > 0
  double yield;          ///< Y, initial yield stress (Cauchy) in uniaxial tension, Pa, > 0
  double hardening = 0;  ///< H, d(yield stress)/d(eps_p), Pa, >= 0

  LinearHardening law() const { return {yield, hardening}; }
  void validate() const { law().validate(shear_modulus); }

  /// Returns the plastic work of the increment, J/m^3 of current volume, never negative.
  template <class V, class T>
  T update(V& values, const Kinematics<T>& k) const {
    auto& s = get<field::DeviatoricStress>(values);
    auto& eps = get<field::PlasticStrain>(values);
    const T x = get<field::VolumeRatio>(values);
    // all in b_e - I, so that small strains keep their digits
    const SymTensor<T> before = expm1(s * (x / k.volume_factor * T(1 / shear_modulus)));
    const Mat<T, 3> f = Mat<T, 3>::identity() + k.increment;
    const SymTensor<T> stretch = rotate(k.increment, identity<T>()) + T(2) * sym(k.increment);
    const T modulus = T(shear_modulus) / x;  // of the Cauchy stress
    s = deviator(log1p(rotate(f, before) + stretch)) * modulus;
    const auto flow = radial_return(s, eps, modulus, law());
    s = s * (T(1) - T(3) * modulus * flow.rise / flow.equivalent);
    eps += flow.rise;
    return flow.dissipated;
  }

  /// G h : h, J/m^3 of initial volume.
  template <class V>
  auto elastic_energy(const V& values) const {
    using T = typename V::number;
    const auto& s = get<field::DeviatoricStress>(values);
    const T x = get<field::VolumeRatio>(values);
    return T(T(0.25 / shear_modulus) * x * x * ddot(s, s));
  }

  /// rho0 c^2 of the fastest wave, Pa, where the volume alone makes `bulk` of it: bulk + 4/3 G at rest, and a bound for
  /// any elastic strain.
  ///
  /// To bulk a longitudinal wave along a principal axis 1 adds 4/3 G - J s_1. A transverse one has 2 G d/(1 - exp(-2
  /// d))
  /// <= G (1 + 2 |d|) with d = h_1 - h_2, and 2 G |d| <= sqrt(2) |J s|.
  template <class V, class T>
  T wave_modulus(const V& values, const T& bulk) const {
    using std::sqrt;
    const auto& s = get<field::DeviatoricStress>(values);
    return bulk + T(4.0 / 3 * shear_modulus) + get<field::VolumeRatio>(values) * sqrt(T(2) * ddot(s, s));
  }

  friend bool operator==(const VonMisesLogarithmic&, const VonMisesLogarithmic&) = default;

 private:
  template <class T>
  static SymTensor<T> identity() {
    return {{T(1), T(1), T(1), T(0), T(0), T(0)}};
  }
};

}  // namespace mote::strength
