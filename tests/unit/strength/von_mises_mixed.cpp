#include <mote/strength/von_mises_mixed.hpp>

#include <array>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/material.hpp>

#include "unit/strength/checks.hpp"

namespace {

using namespace checks;
using strength::VonMises;
using strength::VonMisesMixed;

const VonMisesMixed aluminium{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6, .kinematic_hardening = 2e9};

VonMisesMixed some_metal(Random& random, unsigned seed) {
  return {.shear_modulus = 1e9 * (30 + random(29)),
          .yield = 1e8 * (2 + random(1.9)),
          .hardening = seed % 4 ? 1e9 * (1 + random(1)) : 0,
          .kinematic_hardening = seed % 3 ? 5e9 * (1 + random(1)) : 0};
}

}  // namespace

TEST_CASE("mixed hardening: the return ends on the yield surface and dissipates") { yield_surface(some_metal); }

TEST_CASE("mixed hardening: flow along s - alpha, and the back stress moves by (2/3) H_kin de_p") {
  CHECK(rc::check([](unsigned seed) {
    Random random{std::mt19937(seed)};
    const VonMisesMixed metal = some_metal(random, seed);
    State<double> state = rest();
    for (int step = 0; step < 10; ++step) {
      const State<double> before = state;
      const Kinematics<double> k(random.matrix(random.size()));
      metal.update(state, k);
      const Tensor trial = strength::elastic_predictor(before, k, metal.shear_modulus);
      const Tensor plastic = (trial - s_of(state)) * (0.5 / metal.shear_modulus);  // de_p
      const Tensor moved = get<field::BackStress>(state) - rotate(k.rotation, get<field::BackStress>(before));
      const double scale = magnitude(trial) / metal.shear_modulus;
      RC_ASSERT(std::abs(std::sqrt(2.0 / 3) * magnitude(plastic) - (strain_of(state) - strain_of(before))) <
                1e-13 * (scale + strain_of(state)));
      RC_ASSERT(magnitude(moved - (2.0 / 3 * metal.kinematic_hardening) * plastic) <=
                1e-12 * (magnitude(get<field::BackStress>(before)) + metal.kinematic_hardening * scale));
      const double along = ddot(plastic, relative(state)), both = magnitude(plastic) * magnitude(relative(state));
      RC_ASSERT(std::abs(along - both) < 1e-12 * (both + scale * metal.yield));
    }
  }));
}

TEST_CASE("mixed hardening: without H_kin it is the isotropic metal") {
  const VonMises isotropic{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
  const VonMisesMixed mixed{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
  Random random;
  State<double> one = rest(), other = rest();
  for (int step = 0; step < 100; ++step) {
    const Matrix a = random.matrix(random.size());
    const double work = move(isotropic, one, a);
    // the margin is the round-off of a trial stress of some GPa, times Y/3G
    REQUIRE(move(mixed, other, a) == Approx(work).epsilon(1e-12).margin(1e-8));
    REQUIRE(magnitude(s_of(one) - s_of(other)) < 1e-12 * 120e6);
    REQUIRE(strain_of(one) == Approx(strain_of(other)).epsilon(1e-13));
  }
  CHECK(strain_of(one) > 0.1);
  CHECK(magnitude(get<field::BackStress>(other)) == 0);
}

TEST_CASE("mixed hardening: a bar pulled and pushed yields again 2 Y below where it was (Bauschinger)") {
  // pure shear: equivalent stress sqrt(3) tau, plastic shear strain gamma_p = sqrt(3) eps_p
  const VonMisesMixed metal{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 0, .kinematic_hardening = 5e9};
  State<double> state = rest();
  const Tensor step{0, 0, 0, 1e-6, 0, 0};  // tensor shear
  const auto tau = [&] { return s_of(state)(0, 1); };
  for (int n = 0; n < 4000; ++n) move(metal, state, straining(step));
  const double top = tau(), eps = strain_of(state), gamma = 2 * 4000e-6;
  // sqrt(3) tau = Y + H eps_p and gamma = tau/G + sqrt(3) eps_p
  CHECK(std::sqrt(3) * top == Approx(120e6 + 5e9 * eps).epsilon(1e-10));
  CHECK(gamma == Approx(top / 25.94e9 + std::sqrt(3) * eps).epsilon(1e-10));
  int n = 0;
  while (strain_of(state) == eps && ++n < 10000) move(metal, state, straining(-1.0 * step));
  // it gave way in the step whose end passed top - 2 Y/sqrt(3)
  CHECK(2 * 25.94e9 * 1e-6 * n >= 2 * 120e6 / std::sqrt(3));
  CHECK(2 * 25.94e9 * 1e-6 * (n - 1) <= 2 * 120e6 / std::sqrt(3));
}

TEST_CASE("mixed hardening: work is what is dissipated plus what is stored") {
  const eos::MieGruneisen eos{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
  const Material metal{eos, aluminium};
  // there and back in pure shear, many times: the volume stays, so that all work is shear work
  const auto gap = [&](int steps) {
    auto state = metal.initial<double>();
    double work = 0;
    for (int n = 0; n < steps; ++n) {
      const auto angle = [&](int i) { return 0.01 * std::sin(4.5 * std::numbers::pi * i / steps); };
      const Matrix a = straining({0, 0, 0, angle(n + 1) - angle(n), 0, 0});
      const auto before = get<field::DeviatoricStress>(state);
      metal.update(state, a);
      const Kinematics<double> k(a);
      work += 0.5 * ddot(before + get<field::DeviatoricStress>(state), k.strain) / 2700;
    }
    const double kept = metal.elastic_energy(state) + get<field::PlasticWork>(state);
    INFO("work " << work << ", kept " << kept);
    CHECK(get<field::PlasticWork>(state) > 1000);
    // the back stress alone keeps more than the error that is left
    const auto& back = get<field::BackStress>(state);
    CHECK(0.75 / 2e9 * ddot(back, back) / 2700 > 5e-3 * work);
    return std::abs(work - kept) / work;
  };
  // radial return is first order in time on a reversal
  const double coarse = gap(1000), fine = gap(4000);
  CHECK(fine < 1e-4);
  CHECK(fine < 0.5 * coarse + 1e-9);
}

TEST_CASE("mixed hardening: 100 turns of a stressed body leave its stresses, turned, and nothing else") {
  large_spin(aluminium, GENERATE(1e-4, 6e-3));
}
TEST_CASE("mixed hardening: objective") { objectivity(aluminium); }

TEST_CASE("mixed hardening: packs give what numbers give, single precision nearly so") {
  const auto all = [](const auto& state) {
    using T = typename std::remove_cvref_t<decltype(state)>::number;
    std::array<T, 14> r;
    for (int i = 0; i < 6; ++i) r[std::size_t(i)] = get<field::DeviatoricStress>(state).c[i] * T(1 / 120e6);
    for (int i = 0; i < 6; ++i) r[std::size_t(6 + i)] = get<field::BackStress>(state).c[i] * T(1 / 120e6);
    r[12] = get<field::PlasticStrain>(state);
    r[13] = aluminium.elastic_energy(state) * T(1 / 120e6);
    return r;
  };
  packs(aluminium, all, 1e-2, 1e-12, 1e-4);
}

TEST_CASE("mixed hardening: impossible parameters are refused in a sentence") {
  CHECK_NOTHROW(aluminium.validate());
  CHECK_THROWS_WITH((VonMisesMixed{.shear_modulus = 1, .yield = 1, .kinematic_hardening = -3}.validate()),
                    "mote: the kinematic hardening modulus is -3 Pa; it must be >= 0");
  CHECK_THROWS_WITH((VonMisesMixed{.shear_modulus = 1, .yield = 1, .hardening = -3}.validate()),
                    "mote: the hardening modulus is -3 Pa; it must be >= 0");
  CHECK_THROWS_WITH((VonMisesMixed{.shear_modulus = 0, .yield = 1}.validate()),
                    "mote: the shear modulus is 0 Pa; it must be > 0");
}
