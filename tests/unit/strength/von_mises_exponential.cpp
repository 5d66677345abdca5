#include <mote/strength/von_mises_exponential.hpp>

#include <array>
#include <mote/strength/von_mises_mixed.hpp>
#include <mote/strength/von_mises_mixed_exponential.hpp>

#include "unit/strength/checks.hpp"

namespace {

using namespace checks;
using strength::VonMisesExponential;
using strength::VonMisesMixed;
using strength::VonMisesMixedExponential;

const VonMisesExponential aluminium{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
const VonMisesMixedExponential mixed{
    .shear_modulus = 25.94e9, .yield = 120e6, .hardening = 5e9, .kinematic_hardening = 5e9};

VonMisesMixedExponential some_metal(Random& random, unsigned seed) {
  return {.shear_modulus = 1e9 * (30 + random(29)),
          .yield = 1e8 * (2 + random(1.9)),
          .hardening = seed % 4 ? 1e9 * (1 + random(1)) : 0,
          .kinematic_hardening = seed % 3 ? 5e9 * (1 + random(1)) : 0};
}

Tensor deviatoric(Random& random, double size) { return deviator(sym(random.matrix(size))); }

/// The same increment in n equal parts.
template <class Strength>
double in_parts(const Strength& metal, State<double>& state, const Tensor& strain, int n) {
  double work = 0;
  for (int i = 0; i < n; ++i) work += move(metal, state, straining(strain * (1.0 / n)));
  return work;
}

}  // namespace

TEST_CASE("exponential map: it ends on the yield surface and dissipates") {
  yield_surface(some_metal);
  yield_surface([](Random& random, unsigned seed) {
    const auto m = some_metal(random, seed);
    return VonMisesExponential{.shear_modulus = m.shear_modulus, .yield = m.yield, .hardening = m.hardening};
  });
}

TEST_CASE("exponential map: without isotropic hardening a straight increment is exact, however it is cut") {
  // elastic parts, unloading through the elastic ball and flow on its far side included
  CHECK(rc::check([](unsigned seed) {
    Random random{std::mt19937(seed)};
    auto metal = some_metal(random, seed);
    metal.hardening = 0;
    State<double> whole = rest(), parts = rest();
    for (int step = 0; step < 10; ++step) {
      // Y/2G is about 2e-3; opposite to the stress now and then
      Tensor e = deviatoric(random, std::pow(10, -2.5 + random(1)));
      if (step % 3 == 2) e = s_of(whole) * (-std::pow(10, random(1)) / metal.shear_modulus);
      const double work = in_parts(metal, whole, e, 1), sum = in_parts(metal, parts, e, 7);
      RC_ASSERT(std::abs(work - sum) < 1e-11 * metal.yield * (1e-3 + strain_of(whole)));
      RC_ASSERT(magnitude(s_of(whole) - s_of(parts)) < 1e-10 * metal.yield * (1 + strain_of(whole) * 1e2));
      RC_ASSERT(std::abs(strain_of(whole) - strain_of(parts)) < 1e-11 * (1e-3 + strain_of(whole)));
    }
  }));
}

TEST_CASE("exponential map: radial return in ever more parts tends to it, to first order") {
  Random random;
  for (int trial = 0; trial < 10; ++trial) {
    auto exact = some_metal(random, unsigned(trial));
    exact.hardening = 0;
    const VonMisesMixed radial{
        .shear_modulus = exact.shear_modulus, .yield = exact.yield, .kinematic_hardening = exact.kinematic_hardening};
    State<double> start = rest();
    move(exact, start, straining(deviatoric(random, 1e-2)));
    const Tensor e = deviatoric(random, 2e-2);
    State<double> end = start;
    const double work = in_parts(exact, end, e, 1);
    double last = 0;
    for (const int n : {2000, 4000, 8000}) {
      State<double> state = start;
      const double sum = in_parts(radial, state, e, n);
      const double error = magnitude(s_of(state) - s_of(end)) / exact.yield;
      INFO("trial " << trial << ", " << n << " parts, error " << error);
      REQUIRE(error < 20.0 / n);
      if (last > 1e-7) REQUIRE(last / error == Approx(2).epsilon(0.1));
      REQUIRE(sum == Approx(work).epsilon(20.0 / n));
      REQUIRE(strain_of(state) == Approx(strain_of(end)).epsilon(20.0 / n));
      last = error;
    }
  }
}

TEST_CASE("exponential map: with isotropic hardening, cutting an increment in half changes it to third order") {
  Random random;
  for (int trial = 0; trial < 10; ++trial) {
    State<double> start = rest();
    move(mixed, start, straining(deviatoric(random, 1e-2)));
    const Tensor n = relative(start) * (1 / magnitude(relative(start)));
    Tensor direction = deviatoric(random, 1);
    direction = direction * (1 / magnitude(direction));
    direction += n * (0.3 + std::max(-ddot(direction, n), 0.0));  // outward: no elastic part
    const auto gap = [&](double size) {
      State<double> one = start, two = start;
      in_parts(mixed, one, direction * size, 1);
      in_parts(mixed, two, direction * size, 2);
      return magnitude(s_of(one) - s_of(two)) / 120e6;
    };
    const double coarse = gap(2e-4), fine = gap(5e-5);
    INFO("gaps " << coarse << " and " << fine);
    CHECK(std::log(coarse / fine) / std::log(4) > 2.7);
  }
}

TEST_CASE("exponential map: without back stress both policies are one, on a radial path radial return too") {
  Random random;
  const VonMisesMixedExponential same{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
  State<double> one = rest(), other = rest();
  for (int step = 0; step < 100; ++step) {
    const Matrix a = random.matrix(random.size());
    const double work = move(aluminium, one, a);
    REQUIRE(move(same, other, a) == Approx(work).epsilon(1e-12).margin(1e-8));
    REQUIRE(magnitude(s_of(one) - s_of(other)) < 1e-12 * 120e6);
  }
  CHECK(magnitude(get<field::BackStress>(other)) == 0);
  const VonMisesMixed radial{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 5e9, .kinematic_hardening = 5e9};
  State<double> a = rest(), b = rest();
  const Tensor e = deviatoric(random, 1e-3);
  for (int step = 0; step < 20; ++step) {
    REQUIRE(in_parts(mixed, a, e, 1) == Approx(in_parts(radial, b, e, 1)).epsilon(1e-11));
    REQUIRE(magnitude(s_of(a) - s_of(b)) < 1e-11 * 120e6);
    REQUIRE(magnitude(get<field::BackStress>(a) - get<field::BackStress>(b)) < 1e-11 * 120e6);
  }
}

TEST_CASE("exponential map: enormous increments, nothing and reversals do not overflow") {
  for (const double size : {1e-300, 1e-20, 1e-3, 1.0, 100.0}) {
    State<double> state = rest();
    for (const double sign : {1.0, -1.0, 0.0, -1.0, 1.0}) {
      // not through Kinematics: strains of 100 have no mid-point
      const auto flow = strength::exponential_map(s_of(state), Tensor{0, 0, 0, sign * size, 0, 0}, strain_of(state),
                                                  25.94e9, {120e6, 384e6, 0});
      s_of(state) = flow.relative;
      get<field::PlasticStrain>(state) += flow.rise;
      REQUIRE(std::isfinite(magnitude(s_of(state))));
      REQUIRE(std::isfinite(flow.dissipated));
      REQUIRE(std::isfinite(magnitude(flow.plastic_strain)));
    }
  }
  State<float> state = rest<float>();
  const auto flow = strength::exponential_map(get<field::DeviatoricStress>(state), SymTensor<float>{0, 0, 0, 10, 0, 0},
                                              0.0f, 25.94e9, {120e6, 384e6, 1e9});
  CHECK(std::isfinite(flow.relative(0, 1)));
  // the increment points along n: linear in it
  CHECK(double(flow.rise) == Approx((std::sqrt(3) * 2 * 25.94e9 * 10 - 120e6) / (3 * 25.94e9 + 1.384e9)).epsilon(1e-5));
}

TEST_CASE("exponential map: 100 turns of a stressed body leave its stresses, turned, and nothing else") {
  const double strain = GENERATE(1e-4, 6e-3);
  large_spin(mixed, strain);
  large_spin(aluminium, strain);
}
TEST_CASE("exponential map: objective") {
  objectivity(mixed);
  objectivity(aluminium);
}

TEST_CASE("exponential map: packs give what numbers give, single precision nearly so") {
  const auto all = [](const auto& state) {
    using T = typename std::remove_cvref_t<decltype(state)>::number;
    std::array<T, 14> r;
    for (int i = 0; i < 6; ++i) r[std::size_t(i)] = get<field::DeviatoricStress>(state).c[i] * T(1 / 120e6);
    for (int i = 0; i < 6; ++i) r[std::size_t(6 + i)] = get<field::BackStress>(state).c[i] * T(1 / 120e6);
    r[12] = get<field::PlasticStrain>(state);
    r[13] = mixed.elastic_energy(state) * T(1 / 120e6);
    return r;
  };
  packs(mixed, all, 1e-2, 1e-12, 1e-4);
  packs(aluminium, all, 1e-2, 1e-12, 1e-4);
}

TEST_CASE("exponential map: impossible parameters are refused in a sentence") {
  CHECK_NOTHROW(mixed.validate());
  CHECK_THROWS_WITH((VonMisesExponential{.shear_modulus = 1, .yield = 0}.validate()),
                    "mote: the yield stress is 0 Pa; it must be > 0 (strength::Elastic has none)");
  CHECK_THROWS_WITH((VonMisesMixedExponential{.shear_modulus = 1, .yield = 1, .kinematic_hardening = -3}.validate()),
                    "mote: the kinematic hardening modulus is -3 Pa; it must be >= 0");
}
