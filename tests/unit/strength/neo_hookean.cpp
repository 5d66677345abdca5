#include <mote/strength/neo_hookean.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <mote/eos/logarithmic_bulk.hpp>
#include <mote/mote.hpp>
#include <sstream>

#include "unit/strength/hyperelastic.hpp"

namespace {

using namespace checks;
using strength::NeoHookean;

const NeoHookean springs{.shear_modulus = 1e6};
const eos::LogarithmicBulk bulk{.rho0 = 1000, .bulk_modulus = 3e6};
const Material rubber{bulk, springs};

const Tensor& b_of(const State<double>& state) { return get<field::LeftCauchyGreen>(state); }

/// mu/J (b - I) + lambda ln(J)/J I, from the gradient.
Tensor cauchy(const Matrix& f) {
  const double j = det(f);
  return add_diagonal(add_diagonal(rotate(f, Tensor{1, 1, 1, 0, 0, 0}), -1.0) * (1e6 / j), 3e6 * std::log(j) / j);
}

}  // namespace

TEST_CASE("neo-Hookean: at rest nothing is stressed, and b is the identity") {
  const auto state = rubber.initial<double>();
  CHECK(magnitude(rubber.stress(state)) == 0);
  CHECK(rubber.elastic_energy(state) == 0);
  CHECK(trace(get<field::LeftCauchyGreen>(state)) == 3);
  CHECK(rubber.sound_speed2(state) == Approx((3e6 + 2e6) / 1000));  // (lambda + 2 mu)/rho
}

TEST_CASE("neo-Hookean: the stress of the gradient, however many increments led there") {
  Random random;
  for (int trial = 0; trial < 50; ++trial) {
    auto state = rubber.initial<double>();
    Matrix f = Matrix::identity();
    for (int n = 0; n < 10; ++n) {
      const Matrix a = random.matrix(0.2);
      rubber.update(state, a);
      f = (Matrix::identity() + a) * f;
    }
    REQUIRE(magnitude(rubber.stress(state) - cauchy(f)) < 1e-12 * (magnitude(cauchy(f)) + 1e6));
  }
}

TEST_CASE("neo-Hookean: in uniaxial strain without lambda it is the bar P = E/2 (F - 1/F)") {
  const double young = 1e4;
  const Material bar{eos::LogarithmicBulk{.rho0 = 1}, NeoHookean{.shear_modulus = young / 2}};
  for (const double f : {0.5, 0.9, 1.0, 1.1, 3.0}) {
    auto state = bar.initial<double, 1>();
    bar.update(state, Matrix{f - 1, 0, 0, 0, 0, 0, 0, 0, 0});
    // sigma_xx is the nominal stress: the cross-section stays
    CHECK(bar.stress(state)(0, 0) == Approx(young / 2 * (f - 1 / f)).margin(1e-9));
    // rho0 C^2 = dP/dF in the material, C F in space
    CHECK(bar.sound_speed2(state) == Approx(young / 2 * (1 + 1 / (f * f)) * f * f));
    CHECK(bar.elastic_energy(state) == Approx(young / 4 * (f * f - 1 - 2 * std::log(f))).margin(1e-9));
  }
}

TEST_CASE("neo-Hookean: stress is the derivative of the elastic energy") { stress_from_energy(rubber, 0.7, 1e6); }

TEST_CASE("neo-Hookean: no wave is faster than the time step thinks, at any stretch") {
  const auto [largest, smallest] = wave_ratios(rubber, 0.7);
  CHECK(largest < 1 + 1e-6);
  CHECK(smallest > 0.6);
  // in a plane the bound is sharp for every stretch: by the waves along all directions in it
  for (const double f : {0.4, 1.0, 2.5}) {
    auto flat = rubber.initial<double, 2>();
    const Matrix gradient{f, 0.7, 0, -0.3, 1.1, 0, 0, 0, 1};
    rubber.update(flat, gradient - Matrix::identity());
    double fastest = 0;
    for (int k = 0; k < 200; ++k) {
      const double angle = std::numbers::pi * k / 200;
      const auto s = spectral(acoustic_tensor(rubber, gradient, {std::cos(angle), std::sin(angle), 0}));
      fastest = std::max({fastest, s.values[0], s.values[1], s.values[2]});
    }
    CHECK(rubber.sound_speed2(flat) == Approx(fastest).epsilon(1e-3));
  }
  const auto [most, least] = wave_ratios(rubber, 1e-4);
  CHECK(most < 1 + 1e-6);
  CHECK(least > 1 - 1e-3);
}

TEST_CASE("neo-Hookean: Hooke's law at small strain, with Lame's constants") {
  Random random;
  for (int n = 0; n < 20; ++n) {
    const Matrix d = random.matrix(1e-6);
    const Tensor e = sym(d), hooke = add_diagonal(e * 2e6, 3e6 * trace(e));
    CHECK(magnitude(rubber.stress(at(rubber, Matrix::identity() + d)) - hooke) < 1e-5 * magnitude(hooke));
  }
}

TEST_CASE("neo-Hookean: 100 turns and superposed rotations turn the stress, and nothing else") {
  const int per_turn = GENERATE(20, 360);
  State<double> state = rest();
  move(springs, state, Matrix{0.3, 0.5, 0, 0, -0.2, 0.1, 0, 0, 0.1});
  const Tensor start = b_of(state);
  const Matrix spin = turning(2 * std::numbers::pi / per_turn);
  for (int n = 0; n < 100 * per_turn; ++n) move(springs, state, spin);
  CHECK(magnitude(b_of(state) - start) < 1e-10 * magnitude(start));
  CHECK(get<field::VolumeRatio>(state) == Approx(1.3 * 0.8 * 1.1).epsilon(1e-10));
  Random random;
  const Matrix q = Kinematics<double>(random.matrix(2)).rotation;
  State<double> one = rest(), turned = rest();
  for (int n = 0; n < 20; ++n) {
    const Matrix a = random.matrix(0.1);
    move(springs, one, a);
    move(springs, turned, q * a * transpose(q));
    REQUIRE(magnitude(springs.stress(turned) - rotate(q, springs.stress(one))) < 1e-12 * 1e6 * trace(b_of(one)));
  }
}

TEST_CASE("neo-Hookean: packs give what numbers give, single precision nearly so") {
  const auto all = [](const auto& state) {
    using T = typename std::remove_cvref_t<decltype(state)>::number;
    std::array<T, 8> r;
    const auto s = springs.stress(state);
    for (int i = 0; i < 6; ++i) r[std::size_t(i)] = s.c[i] * T(1e-6);
    r[6] = springs.elastic_energy(state) * T(1e-6);
    r[7] = springs.wave_modulus(state, T(1e6)) * T(1e-6);
    return r;
  };
  packs(springs, all, 0.05, 1e-12, 1e-4);
}

TEST_CASE("neo-Hookean: a bar between symmetry planes swings at its own frequency, and frames show its stress") {
  // c = sqrt(E/rho) = 100 m/s and half a wave in 1 m: after half a period, 1/100 s, the velocity is reversed
  const Material bar{eos::LogarithmicBulk{.rho0 = 1}, NeoHookean{.shear_modulus = 5e3}};
  Solver solver{grid::Cartesian<1>{.spacing = 1.0 / 64},
                shape::QuadraticBSpline{},
                transfer::Flip{},
                timestep::Cfl{.courant = 0.2},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                boundary::Symmetry{.side = side::x_max, .at = 1},
                bar};
  const auto wave = [](const Vec<double, 1>& x) { return Vec<double, 1>{0.01 * std::sin(std::numbers::pi * x[0])}; };
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1}}, bar, {.per_axis = 2, .velocity = wave});
  const auto amplitude = [&] {
    double sum = 0, norm = 0;
    for (std::size_t p = 0; p < solver.size(); ++p) {
      const double s = std::sin(std::numbers::pi * solver.particles().get<field::Position>(p)[0]);
      sum += s * solver.particles().get<field::Velocity>(p)[0], norm += s * s;
    }
    return sum / norm / 0.01;
  };
  CHECK(amplitude() == Approx(1));
  solver.run({.until = 0.005});
  CHECK(std::abs(amplitude()) < 0.02);
  solver.run({.until = 0.01});
  CHECK(amplitude() == Approx(-1).epsilon(0.005));
  const auto directory = std::filesystem::temp_directory_path() / "mote_neo_hookean";
  std::filesystem::remove_all(directory);
  solver.run({.until = 0.011}, observe::Vtp{.stem = directory / "bar", .every = 1});
  std::ostringstream text;
  text << std::ifstream(directory / "bar_0000.vtp").rdbuf();
  CHECK(text.str().find("\"von_mises_stress\"") != std::string::npos);
  CHECK(text.str().find("\"left_cauchy_green\"") != std::string::npos);
  std::filesystem::remove_all(directory);
}

TEST_CASE("neo-Hookean: impossible parameters are refused in a sentence") {
  CHECK_NOTHROW(springs.validate());
  CHECK_THROWS_WITH((NeoHookean{.shear_modulus = 0}.validate()), "mote: the shear modulus is 0 Pa; it must be > 0");
}
