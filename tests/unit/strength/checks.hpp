/// \file
/// What every strength must do, and the tools to ask for it.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <mote/strength/von_mises.hpp>
#include <numbers>
#include <random>

#include "catch.hpp"

namespace checks {

using namespace mote;
using Matrix = Mat<double, 3>;
using Tensor = SymTensor<double>;

/// All fields that the shipped strengths declare, whichever of them a policy uses.
template <class T>
using State = Values<T, 3,
                     fields<field::DeviatoricStress, field::BackStress, field::PlasticStrain, field::VolumeRatio,
                            field::LeftCauchyGreen>>;

/// Unstressed, at the initial volume.
template <class T = double>
State<T> rest() {
  State<T> state;
  for (auto* t : {&get<field::DeviatoricStress>(state), &get<field::BackStress>(state)})
    for (auto& c : t->c) c = T(0);
  get<field::LeftCauchyGreen>(state) = {{T(1), T(1), T(1), T(0), T(0), T(0)}};
  get<field::PlasticStrain>(state) = T(0);
  get<field::VolumeRatio>(state) = T(1);
  return state;
}

inline Tensor& s_of(State<double>& state) { return get<field::DeviatoricStress>(state); }
inline const Tensor& s_of(const State<double>& state) { return get<field::DeviatoricStress>(state); }
inline Tensor relative(const State<double>& state) { return s_of(state) - get<field::BackStress>(state); }
inline double strain_of(const State<double>& state) { return get<field::PlasticStrain>(state); }
inline double magnitude(const Tensor& s) { return std::sqrt(ddot(s, s)); }

/// Q - I of a turn about z, without the round-off of cos - 1, which would be a strain in every step.
inline Matrix turning(double angle) {
  const double c = -2 * std::pow(std::sin(angle / 2), 2), s = std::sin(angle);
  return {c, -s, 0, s, c, 0, 0, 0, 0};
}
inline Matrix turn(double angle) { return Matrix::identity() + turning(angle); }

struct Random {
  std::mt19937 engine{1};
  double operator()(double size) { return std::uniform_real_distribution(-size, size)(engine); }
  Matrix matrix(double size) {
    Matrix m{};
    for (double& c : m.c) c = (*this)(size);
    return m;
  }
  /// From far below the yield strain (0.0015) to far above it.
  double size() { return std::pow(10, -3 + (*this)(2)); }
};

/// As a material does it: the volume first.
template <class Strength, class T>
auto move(const Strength& strength, State<T>& state, const Mat<T, 3>& a) {
  const Kinematics<T> k(a);
  T& x = get<field::VolumeRatio>(state);
  x = x * k.volume_factor;
  return strength.update(state, k);
}

/// A displacement increment without rotation whose mid-point strain is `e`.
inline Matrix straining(const Tensor& e) {
  Matrix m{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = e(i, j);
  return m * inverse(Matrix::identity() - 0.5 * m);
}

/// sqrt(3/2) |s - alpha| stays at or below Y + H eps_p, on it while flowing; eps_p and the dissipation do not fall, and
/// the latter is the yield stress's mean times the rise.
template <class Make>
void yield_surface(const Make& make) {
  CHECK(rc::check([&](unsigned seed) {
    Random random{std::mt19937(seed)};
    const auto metal = make(random, seed);
    State<double> state = rest();
    for (int step = 0; step < 20; ++step) {
      const State<double> before = state;
      Matrix a = random.matrix(random.size());
      get<field::VolumeRatio>(state) = 1;  // keeps the volume near 1
      const double work = move(metal, state, a);
      const double stress = std::sqrt(1.5) * magnitude(relative(state));
      const double limit = metal.yield + metal.hardening * strain_of(state);
      const double old_limit = metal.yield + metal.hardening * strain_of(before);
      const double rise = strain_of(state) - strain_of(before);
      const double round_off = 1e-15 * metal.shear_modulus * (magnitude(sym(a)) + 1);
      RC_ASSERT(work >= 0);
      RC_ASSERT(rise >= 0);
      if (work > 0)
        RC_ASSERT(std::abs(stress - limit) < 1e-12 * limit + 10 * round_off);
      else
        RC_ASSERT(stress <= limit * (1 + 1e-12) + 10 * round_off);
      RC_ASSERT(std::abs(work - 0.5 * (old_limit + limit) * rise) <= 1e-12 * work + 1e-15 * limit * strain_of(state));
      RC_ASSERT(std::abs(trace(s_of(state))) < 1e-12 * limit + 10 * round_off);
      RC_ASSERT(std::abs(trace(get<field::BackStress>(state))) < 1e-10 * limit);
    }
  }));
}

/// 100 turns in 2000 or 36000 steps leave the stresses, turned, and nothing else.
template <class Strength>
void large_spin(const Strength& strength, double start_strain) {
  const int per_turn = GENERATE(20, 360);
  State<double> state = rest();
  move(strength, state, Matrix{3e-4, start_strain, 0, 0, -4e-4, 5e-4, 0, 0, 3e-4});
  move(strength, state, Matrix{0, 0, start_strain, 0, 0, 0, 0, 0, 0});
  const State<double> start = state;
  const Matrix spin = turning(2 * std::numbers::pi / per_turn), quarter = turn(std::numbers::pi / 2);
  double work = 0;
  for (int n = 1; n <= 100 * per_turn; ++n) {
    work += move(strength, state, spin);
    if (n != per_turn / 4) continue;
    REQUIRE(magnitude(s_of(state) - rotate(quarter, s_of(start))) < 1e-11 * magnitude(s_of(start)));
    REQUIRE(magnitude(relative(state) - rotate(quarter, relative(start))) < 1e-11 * magnitude(s_of(start)));
  }
  CHECK(magnitude(s_of(state) - s_of(start)) < 2e-9 * magnitude(s_of(start)));
  CHECK(magnitude(relative(state) - relative(start)) < 2e-9 * magnitude(s_of(start)));
  CHECK(strain_of(state) - strain_of(start) < 1e-11);
  CHECK(work < 1e-11 * 120e6);
}

/// Superposed rotations of any size: moving by F in a body turned by Q is moving by Q F Q^T.
template <class Strength>
void objectivity(const Strength& strength) {
  CHECK(rc::check([&](unsigned seed) {
    Random random{std::mt19937(seed)};
    const Matrix q = Kinematics<double>(random.matrix(2)).rotation;
    State<double> state = rest(), turned = rest();
    for (int step = 0; step < 10; ++step) {
      const Matrix a = random.matrix(random.size());
      const double scale = 1e-13 * (strength.shear_modulus * 1e-2 + magnitude(s_of(state)));
      const double work = move(strength, state, a);
      const double other = move(strength, turned, q * a * transpose(q));
      RC_ASSERT(std::abs(work - other) < 1e-11 * work + 1e-6);
      RC_ASSERT(magnitude(s_of(turned) - rotate(q, s_of(state))) < 1e3 * scale);
      RC_ASSERT(magnitude(relative(turned) - rotate(q, relative(state))) < 1e3 * scale);
      RC_ASSERT(std::abs(strain_of(turned) - strain_of(state)) < 1e-12 * (1 + strain_of(state)));
    }
  }));
}

/// Lane by lane what numbers give; single precision nearly so. `every` reads out what is compared, in units of 1.
template <class Strength, class Read>
void packs(const Strength& strength, const Read& every, double size, double margin, double single_margin) {
  Random random{std::mt19937(7)};
  State<Pack<double>> pack = rest<Pack<double>>();
  State<double> one[lanes];
  State<float> single[lanes];
  for (int l = 0; l < lanes; ++l) one[l] = rest(), single[l] = rest<float>();
  for (int step = 0; step < 20; ++step) {
    Mat<Pack<double>, 3> all{};
    Matrix a[lanes];
    for (int l = 0; l < lanes; ++l) a[l] = random.matrix(l % 2 ? size : 1e-3 * size);  // some lanes stay elastic
    for (int c = 0; c < 9; ++c) all.c[c] = Pack<double>([&](int l) { return a[l].c[c]; });
    move(strength, pack, all);
    const auto packed = every(pack);
    for (int l = 0; l < lanes; ++l) {
      Mat<float, 3> b{};
      for (int c = 0; c < 9; ++c) b.c[c] = float(a[l].c[c]);
      move(strength, one[l], a[l]);
      move(strength, single[l], b);
      const auto expected = every(one[l]);
      const auto rough = every(single[l]);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        REQUIRE(lane(packed[i], l) == Approx(expected[i]).margin(margin));
        REQUIRE(double(rough[i]) == Approx(expected[i]).margin(single_margin));
      }
    }
  }
}

}  // namespace checks
