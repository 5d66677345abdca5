#include <mote/strength/elastic.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"

namespace {

using namespace mote;

const strength::Elastic elastic{.shear_modulus = 26e9};
using State = Values<double, 3, fields<field::DeviatoricStress>>;
using Matrix = Mat<double, 3>;

State unstressed() { return {}; }
const SymTensor<double>& s_of(const State& state) { return get<field::DeviatoricStress>(state); }
double magnitude(const SymTensor<double>& s) { return std::sqrt(ddot(s, s)); }

/// Q - I of the same rotation, without the round-off of cos - 1, which would be a strain in every step.
Matrix turning(double angle) {
  const double c = -2 * std::pow(std::sin(angle / 2), 2), s = std::sin(angle);
  return {c, -s, 0, s, c, 0, 0, 0, 0};
}

Matrix turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, -s, 0, s, c, 0, 0, 0, 1};
}

}  // namespace

TEST_CASE("elastic: s = 2 G dev(strain) in one small increment") {
  State state = unstressed();
  const double e = 1e-6;
  elastic.update(state, Kinematics<double>(Matrix{3 * e, 2 * e, 0, 0, 0, 0, 0, 0, 0}));
  const SymTensor<double> expected{2 * e, -e, -e, e, 0, 0};
  CHECK(magnitude(s_of(state) - 52e9 * expected) < 1e-5 * magnitude(s_of(state)));
}

TEST_CASE("elastic: compression alone gives no deviatoric stress") {
  State state = unstressed();
  elastic.update(state, Kinematics<double>(Matrix::identity() * -0.1));
  CHECK(magnitude(s_of(state)) < 1e-5);
}

TEST_CASE("elastic: the trace of s stays zero") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> random(-0.05, 0.05);
  State state = unstressed();
  for (int n = 0; n < 1000; ++n) {
    Matrix a{};
    for (double& c : a.c) c = random(engine);
    elastic.update(state, Kinematics<double>(a));
    REQUIRE(std::abs(trace(s_of(state))) < 1e-12 * magnitude(s_of(state)));
  }
}

TEST_CASE("elastic: uniaxial strain gives s_zz = (4/3) G ln(z)") {
  State state = unstressed();
  const double z = 0.98;
  const int steps = 100;
  Matrix a{};
  a(2, 2) = std::pow(z, 1.0 / steps) - 1;
  for (int i = 0; i < steps; ++i) elastic.update(state, Kinematics<double>(a));
  CHECK(s_of(state)(2, 2) == Approx(4.0 / 3 * 26e9 * std::log(z)).epsilon(1e-8));
  CHECK(s_of(state)(0, 0) == Approx(-0.5 * s_of(state)(2, 2)).epsilon(1e-12));
}

TEST_CASE("elastic: 100 turns of a stressed body leave its stress, turned") {
  const int per_turn = GENERATE(20, 360);
  State state = unstressed();
  elastic.update(state, Kinematics<double>(Matrix{1e-3, 2e-3, 0, 0, -1e-3, 5e-4, 0, 0, 3e-4}));
  const SymTensor<double> start = s_of(state);
  const Kinematics<double> spin(turning(2 * std::numbers::pi / per_turn));
  for (int n = 1; n <= 100 * per_turn; ++n) {
    elastic.update(state, spin);
    if (n == per_turn / 4)
      REQUIRE(magnitude(s_of(state) - rotate(turn(std::numbers::pi / 2), start)) < 1e-10 * magnitude(start));
  }
  CHECK(magnitude(s_of(state) - start) < 1e-10 * magnitude(start));
}

TEST_CASE("elastic: packs give what numbers give") {
  Values<Pack<double>, 3, fields<field::DeviatoricStress>> pack{};
  State one[lanes]{};
  for (int step = 1; step < 4; ++step) {
    Mat<Pack<double>, 3> all{};
    for (int c = 0; c < 9; ++c) all.c[c] = Pack<double>([&](int l) { return 1e-3 * std::sin(step + 9 * l + c); });
    elastic.update(pack, Kinematics<Pack<double>>(all));
    for (int l = 0; l < lanes; ++l) {
      Matrix a{};
      for (int c = 0; c < 9; ++c) a.c[c] = lane(all.c[c], l);
      elastic.update(one[l], Kinematics<double>(a));
    }
  }
  for (int l = 0; l < lanes; ++l)
    for (int c = 0; c < 6; ++c)
      CHECK(lane(get<field::DeviatoricStress>(pack).c[c], l) ==
            Approx(s_of(one[l]).c[c]).margin(1e-13 * magnitude(s_of(one[l]))));
}

TEST_CASE("elastic: the shear modulus must be positive") {
  CHECK_NOTHROW(elastic.validate());
  CHECK_THROWS_WITH(strength::Elastic{.shear_modulus = 0}.validate(),
                    "mote: the shear modulus is 0 Pa; it must be > 0");
  CHECK_THROWS_AS(strength::Elastic{.shear_modulus = std::nan("")}.validate(), InputError);
}
