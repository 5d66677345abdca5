#include <mote/strength/von_mises_logarithmic.hpp>

#include <array>
#include <mote/eos/logarithmic_bulk.hpp>
#include <mote/strength/elastic.hpp>
#include <mote/strength/von_mises.hpp>

#include "unit/strength/hyperelastic.hpp"

namespace {

using namespace checks;
using strength::VonMises;
using strength::VonMisesLogarithmic;

const VonMisesLogarithmic aluminium{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
const VonMisesLogarithmic strong{.shear_modulus = 1e6, .yield = 1e12};  // never yields
const Material hencky{eos::LogarithmicBulk{.rho0 = 1000, .bulk_modulus = 3e6}, strong};

}  // namespace

TEST_CASE("logarithmic strain: the return ends on the yield surface and dissipates") {
  yield_surface([](Random& random, unsigned seed) {
    return VonMisesLogarithmic{.shear_modulus = 1e9 * (30 + random(29)),
                               .yield = 1e8 * (2 + random(1.9)),
                               .hardening = seed % 4 ? 1e9 * (1 + random(1)) : 0};
  });
}

TEST_CASE("logarithmic strain: simple shear is exact, in any number of steps") {
  const double gamma = 3;
  for (const int steps : {1, 2, 7, 100, 1000}) {
    State<double> state = rest();
    Matrix a{};
    a(0, 1) = gamma / steps;
    for (int n = 0; n < steps; ++n) move(strong, state, a);
    // b has the eigenvalues exp(+-2 l), l = arsinh(gamma/2), and tan(2 theta) = 2/gamma
    const double l = std::asinh(gamma / 2), root = std::sqrt(4 + gamma * gamma);
    INFO(steps << " steps");
    CHECK(s_of(state)(0, 1) == Approx(2e6 * l * 2 / root).epsilon(1e-11));
    CHECK(s_of(state)(0, 0) == Approx(2e6 * l * gamma / root).epsilon(1e-11));
    CHECK(s_of(state)(1, 1) == Approx(-2e6 * l * gamma / root).epsilon(1e-11));
    CHECK(std::abs(s_of(state)(2, 2)) < 1e-5);
  }
}

TEST_CASE("logarithmic strain: J s = 2 G dev(ln V) whatever the path, and a closed path leaves nothing") {
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    State<double> state = rest();
    Matrix f = Matrix::identity();
    for (int n = 0; n < 10; ++n) {
      const Matrix a = random.matrix(0.2);
      f = (Matrix::identity() + a) * f;
      move(strong, state, a);
    }
    Tensor b = rotate(f, Tensor{1, 1, 1, 0, 0, 0});
    const Tensor expected = deviator(log1p(add_diagonal(b, -1.0))) * (1e6 / det(f));
    REQUIRE(magnitude(s_of(state) - expected) < 1e-11 * magnitude(expected));
    move(strong, state, inverse(f) - Matrix::identity());
    REQUIRE(magnitude(s_of(state)) < 1e-9 * magnitude(expected));
  }
}

TEST_CASE("logarithmic strain: stress is the derivative of the elastic energy") {
  stress_from_energy(hencky, 0.7, 1e6);
}

TEST_CASE("logarithmic strain: no wave is faster than the time step thinks") {
  const auto [largest, smallest] = wave_ratios(hencky, 0.4);
  CHECK(largest < 1 + 1e-6);
  CHECK(smallest > 0.5);
  // at rest exactly c_bulk^2 + 4 G/(3 rho)
  CHECK(hencky.sound_speed2(hencky.initial<double>()) == Approx((3e6 + 4e6 / 3) / 1000));
  const auto [most, least] = wave_ratios(hencky, 1e-4);
  CHECK(most < 1 + 1e-6);
  CHECK(least > 1 - 1e-3);
}

TEST_CASE("logarithmic strain: the Jaumann rate agrees with it to second order in the strain") {
  const strength::Elastic jaumann{.shear_modulus = 1e6};
  const auto gap = [&](double size) {
    State<double> one = rest(), other = rest();
    Matrix last = Matrix::identity();
    for (int n = 1; n <= 400; ++n) {
      // stretch and shear with turning axes, ends stressed
      const double t = n / 400.0, u = size * std::sin(1.5 * t), v = size * t * t, w = size * std::sin(3 * t);
      const Matrix f{1 + u, v, 0, 0.3 * w, 1 - 0.5 * w, 0.2 * v, 0, 0.4 * u, 1 - 0.7 * v};
      const Matrix a = f * inverse(last) - Matrix::identity();
      move(strong, one, a);
      move(jaumann, other, a);
      last = f;
    }
    return magnitude(s_of(one) - s_of(other)) / 1e6;
  };
  const double coarse = gap(4e-3), fine = gap(1e-3);
  CHECK(std::log(coarse / fine) / std::log(4) == Approx(2).margin(0.1));
  CHECK(fine < 10 * 1e-3 * 1e-3);
}

TEST_CASE("logarithmic strain: a flowing metal is that of the Jaumann rate, up to its elastic strain") {
  const VonMises jaumann{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6};
  State<double> one = rest(), other = rest();
  double work = 0, expected = 0;
  for (int n = 0; n < 2000; ++n) {
    const double t = n / 2000.0;
    Matrix a{};
    a(0, 0) = 1e-4 * std::cos(5 * t), a(1, 1) = -0.5 * a(0, 0), a(0, 1) = 1e-4 * std::sin(9 * t),
         a(1, 0) = 0.3 * a(0, 1);
    work += move(aluminium, one, a);
    expected += move(jaumann, other, a);
  }
  CHECK(strain_of(one) > 0.05);
  CHECK(strain_of(one) == Approx(strain_of(other)).epsilon(5e-3));
  CHECK(work == Approx(expected).epsilon(5e-3));
  CHECK(magnitude(s_of(one) - s_of(other)) < 5e-3 * magnitude(s_of(other)));
}

TEST_CASE("logarithmic strain: 100 turns of a stressed body leave its stress, turned, and nothing else") {
  large_spin(aluminium, GENERATE(1e-4, 6e-3));
}
TEST_CASE("logarithmic strain: objective") { objectivity(aluminium); }

TEST_CASE("logarithmic strain: a particle at rest stays so, a stressed one too, in single precision too") {
  State<double> nothing = rest();
  CHECK(move(aluminium, nothing, Matrix{}) == 0);
  CHECK(magnitude(s_of(nothing)) == 0);
  State<double> state = rest();
  State<float> single = rest<float>();
  move(aluminium, state, Matrix{1e-3, 5e-4, 0, 0, -4e-4, 2e-4, 0, 0, -5e-4});
  move(aluminium, single, Mat<float, 3>{1e-3f, 5e-4f, 0, 0, -4e-4f, 2e-4f, 0, 0, -5e-4f});
  const Tensor before = s_of(state);
  const auto rough = get<field::DeviatoricStress>(single);
  for (int n = 0; n < 10000; ++n) {
    move(aluminium, state, Matrix{});
    move(aluminium, single, Mat<float, 3>{});
  }
  const auto drift = get<field::DeviatoricStress>(single) - rough;
  INFO("drift in 10000 steps: " << magnitude(s_of(state) - before) / magnitude(before) << ", single "
                                << std::sqrt(ddot(drift, drift) / ddot(rough, rough)));
  CHECK(magnitude(s_of(state) - before) < 1e-11 * magnitude(before));
  CHECK(std::sqrt(ddot(drift, drift) / ddot(rough, rough)) < 1e-3);
}

TEST_CASE("logarithmic strain: packs give what numbers give, single precision nearly so") {
  const auto all = [](const auto& state) {
    using T = typename std::remove_cvref_t<decltype(state)>::number;
    std::array<T, 9> r;
    for (int i = 0; i < 6; ++i) r[std::size_t(i)] = get<field::DeviatoricStress>(state).c[i] * T(1 / 120e6);
    r[6] = get<field::PlasticStrain>(state);
    r[7] = aluminium.elastic_energy(state) * T(1 / 120e6);
    r[8] = aluminium.wave_modulus(state, T(1e6)) * T(1 / 25.94e9);
    return r;
  };
  packs(aluminium, all, 1e-2, 1e-11, 1e-3);
  packs(aluminium, all, 0.2, 1e-11, 1e-2);  // some lanes beyond the series of the logarithm
}

TEST_CASE("logarithmic strain: impossible parameters are refused in a sentence") {
  CHECK_NOTHROW(aluminium.validate());
  CHECK_THROWS_WITH((VonMisesLogarithmic{.shear_modulus = -1, .yield = 1}.validate()),
                    "mote: the shear modulus is -1 Pa; it must be > 0");
}
