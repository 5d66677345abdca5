/// \file
/// Schemes, the metal of the scenes, and what tests of the passes ask of a solver.
#pragma once

#include <cstring>
#include <random>
#include <vector>

#include <mote/mote.hpp>

namespace schemes {

using namespace mote;

inline constexpr double h = 1e-6;
inline const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                                strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                                heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
using Aluminium = std::remove_const_t<decltype(aluminium)>;

template <class S, class X, class U>
struct Scheme {
  using Shape = S;
  using Transfer = X;
  using Update = U;
  static constexpr bool flip = std::is_same_v<X, transfer::Flip>, affine_flip = std::is_same_v<X, transfer::AffineFlip>;
};

using LinearFlipUsl = Scheme<shape::Linear, transfer::Flip, update::Usl>;
using LinearFlipMusl = Scheme<shape::Linear, transfer::Flip, update::Musl>;
using LinearApicUsl = Scheme<shape::Linear, transfer::Apic, update::Usl>;
using LinearApicMusl = Scheme<shape::Linear, transfer::Apic, update::Musl>;
using QuadraticFlipUsl = Scheme<shape::QuadraticBSpline, transfer::Flip, update::Usl>;
using QuadraticFlipMusl = Scheme<shape::QuadraticBSpline, transfer::Flip, update::Musl>;
using QuadraticApicUsl = Scheme<shape::QuadraticBSpline, transfer::Apic, update::Usl>;
using QuadraticApicMusl = Scheme<shape::QuadraticBSpline, transfer::Apic, update::Musl>;
using QuadraticAffineFlipMusl = Scheme<shape::QuadraticBSpline, transfer::AffineFlip, update::Musl>;
using QuadraticAffineFlipUsl = Scheme<shape::QuadraticBSpline, transfer::AffineFlip, update::Usl>;
using CubicAffineFlipMusl = Scheme<shape::CubicBSpline, transfer::AffineFlip, update::Musl>;
using CubicFlipUsl = Scheme<shape::CubicBSpline, transfer::Flip, update::Usl>;
using CubicFlipMusl = Scheme<shape::CubicBSpline, transfer::Flip, update::Musl>;
using CubicApicUsl = Scheme<shape::CubicBSpline, transfer::Apic, update::Usl>;
using CubicApicMusl = Scheme<shape::CubicBSpline, transfer::Apic, update::Musl>;
using GimpFlipUsl = Scheme<shape::Gimp, transfer::Flip, update::Usl>;
using GimpApicMusl = Scheme<shape::Gimp, transfer::Apic, update::Musl>;
using ContiguousGimpFlipUsl = Scheme<shape::ContiguousGimp, transfer::Flip, update::Usl>;
using ContiguousGimpFlipMusl = Scheme<shape::ContiguousGimp, transfer::Flip, update::Musl>;
using ContiguousGimpApicUsl = Scheme<shape::ContiguousGimp, transfer::Apic, update::Usl>;

template <class Scheme>
typename Scheme::Transfer transfer_of(double blend) {
  if constexpr (Scheme::flip || Scheme::affine_flip)
    return {.blend = blend};
  else
    return {};
}

#define MOTE_TEST_LINEAR_SCHEMES \
  schemes::LinearFlipUsl, schemes::LinearFlipMusl, schemes::LinearApicUsl, schemes::LinearApicMusl
#define MOTE_TEST_QUADRATIC_SCHEMES \
  schemes::QuadraticFlipUsl, schemes::QuadraticFlipMusl, schemes::QuadraticApicUsl, schemes::QuadraticApicMusl
#define MOTE_TEST_CUBIC_SCHEMES \
  schemes::CubicFlipUsl, schemes::CubicFlipMusl, schemes::CubicApicUsl, schemes::CubicApicMusl
#define MOTE_TEST_GIMP_SCHEMES                                                                                  \
  schemes::GimpFlipUsl, schemes::GimpApicMusl, schemes::ContiguousGimpFlipUsl, schemes::ContiguousGimpFlipMusl, \
      schemes::ContiguousGimpApicUsl

#define MOTE_TEST_AFFINE_FLIP_SCHEMES \
  schemes::QuadraticAffineFlipMusl, schemes::QuadraticAffineFlipUsl, schemes::CubicAffineFlipMusl
#define MOTE_TEST_SCHEMES                                                                                 \
  MOTE_TEST_LINEAR_SCHEMES, MOTE_TEST_QUADRATIC_SCHEMES, MOTE_TEST_CUBIC_SCHEMES, MOTE_TEST_GIMP_SCHEMES, \
      MOTE_TEST_AFFINE_FLIP_SCHEMES

/// All numbers of a solver's columns, column by column, body by body.
template <class S>
std::vector<double> columns(const S& solver) {
  std::vector<double> all;
  solver.for_each_body([&](const auto&, const auto& particles) {
    particles.for_each_column([&](const auto& column) { all.insert(all.end(), column.begin(), column.end()); });
  });
  return all;
}

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

struct Random {
  std::mt19937 generator{7};
  double operator()(double size) { return std::uniform_real_distribution<double>(-size, size)(generator); }
};

/// Moves each number of a field's columns by up to `size`.
template <class Tag, class P>
void shake(P& particles, int components, double size, Random& random) {
  for (int a = 0; a < components; ++a)
    for (auto& value : particles.template column<Tag>(a)) value += random(size);
}

/// Jittered positions, masses, half sizes, velocities about their mean, and affine matrices where there are any.
template <class P>
void shake(P& particles, double speed) {
  constexpr int D = P::dimension;
  Random random;
  shake<field::Position>(particles, D, 0.1 * h, random);
  shake<field::Velocity>(particles, D, speed, random);
  for (auto& m : particles.template column<field::Mass>()) m *= 1 + random(0.1);
  if constexpr (contains<typename P::list, field::HalfSize>) shake<field::HalfSize>(particles, D, 0.2 * h, random);
  if constexpr (contains<typename P::list, field::Affine>) shake<field::Affine>(particles, D * D, speed / h, random);
}

}  // namespace schemes
