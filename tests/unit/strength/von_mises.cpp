#include <mote/strength/von_mises.hpp>

#include <rapidcheck.h>

#include <cmath>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/material.hpp>
#include <numbers>
#include <random>

#include "catch.hpp"

namespace {

using namespace mote;
using strength::VonMises;

const VonMises aluminium{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
const VonMises perfect{.shear_modulus = 25.94e9, .yield = 120e6};

template <class T>
using Solid = Values<T, 3, fields<field::DeviatoricStress, field::PlasticStrain>>;
using State = Solid<double>;
using Matrix = Mat<double, 3>;

const SymTensor<double>& s_of(const State& state) { return get<field::DeviatoricStress>(state); }
double strain_of(const State& state) { return get<field::PlasticStrain>(state); }
double magnitude(const SymTensor<double>& s) { return std::sqrt(ddot(s, s)); }
double equivalent(const State& state) { return std::sqrt(1.5) * magnitude(s_of(state)); }
double yield_stress(const VonMises& metal, const State& state) {
  return metal.yield + metal.hardening * strain_of(state);
}

/// Q - I of the same rotation, without the round-off of cos - 1, which would be a strain in every step.
Matrix turning(double angle) {
  const double c = -2 * std::pow(std::sin(angle / 2), 2), s = std::sin(angle);
  return {c, -s, 0, s, c, 0, 0, 0, 0};
}

Matrix turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, -s, 0, s, c, 0, 0, 0, 1};
}

struct Random {
  std::mt19937 engine;
  double operator()(double size) { return std::uniform_real_distribution(-size, size)(engine); }
  Matrix matrix(double size) {
    Matrix m{};
    for (double& c : m.c) c = (*this)(size);
    return m;
  }
};

/// Strains from far below the yield strain (0.0015) to far above it.
double some_size(Random& random) { return std::pow(10, -3 + random(2)); }

}  // namespace

TEST_CASE("von Mises: the return ends on the yield surface, at the strain that the consistency condition gives") {
  CHECK(rc::check([](unsigned seed) {
    Random random{std::mt19937(seed)};
    VonMises metal{
        .shear_modulus = 1e9 * (30 + random(29)), .yield = 1e8 * (2 + random(1.9)), .hardening = 1e9 * (1 + random(1))};
    if (seed % 4 == 0) metal.hardening = 0;
    State state{};
    for (int step = 0; step < 20; ++step) {
      const State before = state;
      const Kinematics<double> k(random.matrix(some_size(random)));
      const double work = metal.update(state, k);
      const double stress = equivalent(state), limit = yield_stress(metal, state);
      const double rise = strain_of(state) - strain_of(before);
      const auto trial = strength::elastic_predictor(before, k, metal.shear_modulus);
      RC_ASSERT(work >= 0);
      RC_ASSERT(rise >= 0);
      if (rise > 0) {
        // to round-off of the trial stress, from which it is scaled down
        const double round_off = 1e-15 * magnitude(trial);
        RC_ASSERT(std::abs(stress - limit) < 1e-13 * limit + 4 * round_off);
        // s parallel to the trial stress, and 2 G de_p is what was taken away
        const double lost = 1e-15 * strain_of(state);  // by the difference `rise`
        RC_ASSERT(std::abs(magnitude(trial - s_of(state)) - std::sqrt(6) * metal.shear_modulus * rise) <
                  1e-13 * magnitude(trial) + 3 * metal.shear_modulus * lost);
        RC_ASSERT(ddot(trial, s_of(state)) == Approx(magnitude(trial) * magnitude(s_of(state))).epsilon(1e-13));
        // work = mean yield stress times strain
        RC_ASSERT(std::abs(work - 0.5 * (yield_stress(metal, before) + limit) * rise) < 1e-13 * work + limit * lost);
      } else {
        RC_ASSERT(stress <= limit * (1 + 1e-13));
        RC_ASSERT(magnitude(trial - s_of(state)) < 1e-14 * limit);
        RC_ASSERT(work == 0);
      }
      RC_ASSERT(std::abs(trace(s_of(state))) < 1e-12 * limit);
    }
  }));
}

TEST_CASE("von Mises: below the yield stress the metal is elastic, above it flows") {
  for (const double fraction : {0.5, 0.999, 1.001, 2.0}) {
    State state{};
    const double shear = fraction * 120e6 / (std::sqrt(3) * 25.94e9);
    Matrix a{};
    a(0, 1) = shear;
    aluminium.update(state, Kinematics<double>(a));
    CHECK((strain_of(state) > 0) == (fraction > 1));
    if (fraction < 1) CHECK(equivalent(state) == Approx(fraction * 120e6).epsilon(1e-5));
  }
}

TEST_CASE("von Mises: uniaxial strain follows s_zz = (2/3)(Y + H eps_p)") {
  const double sign = GENERATE(-1, 1);
  const int steps = GENERATE(10, 1000);
  State state{};
  const double z = std::exp(0.05 * sign);
  Matrix a{};
  a(2, 2) = std::pow(z, 1.0 / steps) - 1;
  for (int n = 0; n < steps; ++n) {
    aluminium.update(state, Kinematics<double>(a));
    REQUIRE(s_of(state)(2, 2) ==
            Approx(sign * 2.0 / 3 * yield_stress(aluminium, state)).epsilon(strain_of(state) > 0 ? 1e-12 : 1));
  }
  // elastic and plastic parts share the strain: (2/3) ln z = s_zz / 2G + eps_p
  const double g = 25.94e9, exact = (2.0 / 3 * 0.05 - 120e6 / (3 * g)) / (1 + 384e6 / (3 * g));
  // each increment misses the logarithm by (ln z / steps)^3 / 12
  CHECK(strain_of(state) == Approx(exact).epsilon(std::pow(0.05 / steps, 2)));
  CHECK(s_of(state)(0, 0) == Approx(-0.5 * s_of(state)(2, 2)).epsilon(1e-12));
}

TEST_CASE("von Mises: without hardening the stress never leaves Y") {
  Random random{std::mt19937(1)};
  State state{};
  double last = 0;
  for (int step = 0; step < 500; ++step) {
    const double work = perfect.update(state, Kinematics<double>(random.matrix(0.02)));
    REQUIRE(equivalent(state) <= 120e6 * (1 + 1e-12));
    REQUIRE(work == Approx(120e6 * (strain_of(state) - last)).margin(1e-6));
    last = strain_of(state);
  }
  CHECK(last > 1);
}

TEST_CASE("von Mises: 100 turns of a stressed body leave its stress, turned, and nothing else") {
  const int per_turn = GENERATE(20, 360);
  const double start_strain = GENERATE(0.0, 6e-3);  // elastic; on the yield surface
  State state{};
  aluminium.update(state, Kinematics<double>(Matrix{3e-4, start_strain, 0, 0, -4e-4, 5e-4, 0, 0, 3e-4}));
  const State start = state;
  CHECK((strain_of(start) > 0) == (start_strain > 0));
  const Kinematics<double> spin(turning(2 * std::numbers::pi / per_turn));
  double work = 0;
  for (int n = 1; n <= 100 * per_turn; ++n) {
    work += aluminium.update(state, spin);
    if (n == per_turn / 4)
      REQUIRE(magnitude(s_of(state) - rotate(turn(std::numbers::pi / 2), s_of(start))) <
              1e-12 * magnitude(s_of(start)));
  }
  CHECK(magnitude(s_of(state) - s_of(start)) < 1e-10 * magnitude(s_of(start)));
  CHECK(strain_of(state) - strain_of(start) < 1e-12);
  CHECK(work < 1e-10 * 120e6);
}

TEST_CASE("von Mises: a stress-free particle at rest stays exactly so") {
  State state{};
  const double work = aluminium.update(state, Kinematics<double>(Matrix{}));
  CHECK(work == 0);
  CHECK(strain_of(state) == 0);
  for (const double c : s_of(state).c) CHECK(c == 0);
}

TEST_CASE("von Mises: packs give what numbers give, single precision nearly so") {
  Random random{std::mt19937(7)};
  Solid<Pack<double>> pack{};
  for (auto& c : get<field::DeviatoricStress>(pack).c) c = 0.0;
  get<field::PlasticStrain>(pack) = 0.0;
  State one[lanes]{};
  Solid<float> single[lanes]{};
  for (int step = 0; step < 20; ++step) {
    Matrix a[lanes];
    // lanes that stay elastic, and lanes that flow
    for (int l = 0; l < lanes; ++l) a[l] = random.matrix(l % 2 ? 1e-2 : 1e-5);
    Mat<Pack<double>, 3> all{};
    for (int c = 0; c < 9; ++c) all.c[c] = Pack<double>([&](int l) { return a[l].c[c]; });
    const auto work = aluminium.update(pack, Kinematics<Pack<double>>(all));
    for (int l = 0; l < lanes; ++l) {
      Mat<float, 3> b{};
      for (int c = 0; c < 9; ++c) b.c[c] = float(a[l].c[c]);
      const double expected = aluminium.update(one[l], Kinematics<double>(a[l]));
      aluminium.update(single[l], Kinematics<float>(b));
      REQUIRE(lane(work, l) == Approx(expected).margin(1e-12 * 120e6 * 1e-2));
      for (int c = 0; c < 6; ++c) {
        REQUIRE(lane(get<field::DeviatoricStress>(pack).c[c], l) == Approx(s_of(one[l]).c[c]).margin(1e-12 * 120e6));
        REQUIRE(double(get<field::DeviatoricStress>(single[l]).c[c]) == Approx(s_of(one[l]).c[c]).margin(1e-5 * 120e6));
      }
      REQUIRE(lane(get<field::PlasticStrain>(pack), l) == Approx(strain_of(one[l])).margin(1e-15));
      REQUIRE(double(get<field::PlasticStrain>(single[l])) == Approx(strain_of(one[l])).margin(1e-6));
    }
  }
  CHECK(strain_of(one[1]) > 0.1);
  CHECK(strain_of(one[0]) == 0);
}

namespace {

/// A user's metal that knows numbers only: branches, no packs.
struct ScalarMetal {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::PlasticStrain>;
  static constexpr bool scalar_only = true;
  double shear_modulus, yield, hardening;

  template <class V>
  double update(V& values, const Kinematics<double>& k) const {
    auto& s = get<field::DeviatoricStress>(values);
    double& eps = get<field::PlasticStrain>(values);
    s = strength::elastic_predictor(values, k, shear_modulus);
    const double size = std::sqrt(1.5 * ddot(s, s)), limit = yield + hardening * eps;
    if (size <= limit) return 0;
    const double rise = (size - limit) / (3 * shear_modulus + hardening);
    s = s * ((limit + hardening * rise) / size);
    eps += rise;
    return (limit + 0.5 * hardening * rise) * rise;
  }
};

}  // namespace

TEST_CASE("von Mises: a user's policy for numbers only works in packs, lane by lane") {
  const eos::MieGruneisen eos{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
  const Material mine{eos, ScalarMetal{25.94e9, 120e6, 384e6}};
  const Material shipped{eos, aluminium};
  auto by_lane = mine.initial<Pack<double>>();
  auto by_pack = shipped.initial<Pack<double>>();
  Random random{std::mt19937(3)};
  for (int step = 0; step < 20; ++step) {
    Mat<Pack<double>, 3> a{};
    for (auto& c : a.c) c = Pack<double>([&](int l) { return random(l % 2 ? 1e-2 : 1e-5); });
    mine.update(by_lane, a);
    shipped.update(by_pack, a);
  }
  for (int l = 0; l < lanes; ++l) {
    CHECK(lane(get<field::VolumeRatio>(by_lane), l) ==
          Approx(lane(get<field::VolumeRatio>(by_pack), l)).epsilon(1e-14));
    CHECK(lane(get<field::PlasticStrain>(by_lane), l) ==
          Approx(lane(get<field::PlasticStrain>(by_pack), l)).margin(1e-14));
    CHECK(lane(get<field::PlasticWork>(by_lane), l) == Approx(lane(get<field::PlasticWork>(by_pack), l)).margin(1e-8));
    for (int c = 0; c < 6; ++c)
      CHECK(lane(mine.stress(by_lane).c[c], l) == Approx(lane(shipped.stress(by_pack).c[c], l)).margin(1e-12 * 77e9));
  }
  CHECK(lane(get<field::PlasticStrain>(by_lane), 1) > 0.1);
}

TEST_CASE("von Mises: impossible parameters are refused in a sentence") {
  const auto complaint = [](const VonMises& metal) -> std::string {
    try {
      metal.validate();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(complaint(aluminium).empty());
  CHECK(complaint(perfect).empty());
  CHECK(complaint({.shear_modulus = 0, .yield = 1}) == "mote: the shear modulus is 0 Pa; it must be > 0");
  CHECK(complaint({.shear_modulus = 1, .yield = 0}) ==
        "mote: the yield stress is 0 Pa; it must be > 0 (strength::Elastic has none)");
  CHECK(complaint({.shear_modulus = 1, .yield = 1, .hardening = -3}) ==
        "mote: the hardening modulus is -3 Pa; it must be >= 0");
  CHECK(complaint({.shear_modulus = std::nan(""), .yield = 1}) != "");
}
