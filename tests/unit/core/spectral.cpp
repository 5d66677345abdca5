// Eigenvalues, logarithm and exponential of symmetric tensors.
#include <mote/core/spectral.hpp>

#include <algorithm>
#include <cmath>
#include <mote/strength/kinematics.hpp>
#include <random>

#include "catch.hpp"

namespace {

using namespace mote;
using Tensor = SymTensor<double>;
using Matrix = Mat<double, 3>;

double magnitude(const Tensor& s) { return std::sqrt(ddot(s, s)); }

struct Random {
  std::mt19937 engine{1};
  double operator()(double size) { return std::uniform_real_distribution(-size, size)(engine); }
  Matrix rotation() {
    Matrix m{};
    for (double& c : m.c) c = (*this)(3);
    return Kinematics<double>(m).rotation;
  }
};

/// Eigenvalues that are apart, equal, nearly equal, of very different size, zero.
Vec<double, 3> some_values(Random& random, int kind) {
  const double a = random(1), b = random(1), c = random(1);
  switch (kind % 6) {
    case 0:
      return {a, b, c};
    case 1:
      return {a, a, c};
    case 2:
      return {a, a * (1 + 1e-9), c};
    case 3:
      return {a, 1e-8 * b, 1e-15 * c};
    case 4:
      return {a, a, a};
    default:
      return {0, 0, c};
  }
}

}  // namespace

TEST_CASE("spectral: eigenvalues and a rotation that put the tensor together again, to round-off") {
  Random random;
  for (int n = 0; n < 3000; ++n) {
    Vec<double, 3> values = some_values(random, n);
    const Tensor a = rotate(random.rotation(), Tensor{values[0], values[1], values[2], 0, 0, 0});
    auto s = spectral(a);
    const Matrix error = transpose(s.vectors) * s.vectors - Matrix::identity();
    for (const double c : error.c) REQUIRE(std::abs(c) < 4e-15);
    REQUIRE(det(s.vectors) == Approx(1));
    REQUIRE(magnitude(compose(s) - a) < 4e-15 * magnitude(a));
    std::sort(values.c, values.c + 3);
    std::sort(s.values.c, s.values.c + 3);
    for (int k = 0; k < 3; ++k) REQUIRE(std::abs(s.values[k] - values[k]) < 4e-15 * magnitude(a));
  }
  const auto zero = spectral(Tensor{});
  CHECK(magnitude(compose(zero)) == 0);
}

TEST_CASE("log1p and expm1 of a tensor: those of its eigenvalues, relative to its size") {
  Random random;
  for (int n = 0; n < 3000; ++n) {
    // from 1e-8 to beyond the seam of the series, |a| = 0.2
    const double size = n % 5 == 0 ? 0.999 : std::pow(10, -4 + random(4));
    const Vec<double, 3> v = some_values(random, n) * size;
    const Matrix q = random.rotation();
    const Tensor a = rotate(q, Tensor{v[0], v[1], v[2], 0, 0, 0});
    const Tensor log = rotate(q, Tensor{std::log1p(v[0]), std::log1p(v[1]), std::log1p(v[2]), 0, 0, 0});
    const Tensor exp = rotate(q, Tensor{std::expm1(v[0]), std::expm1(v[1]), std::expm1(v[2]), 0, 0, 0});
    // ln(1 + v) magnifies an error of v by 1/(1 + v)
    const double condition = 1 / (1 + std::min({v[0], v[1], v[2], 0.0}));
    REQUIRE(magnitude(log1p(a) - log) < 1e-14 * condition * magnitude(a));
    REQUIRE(magnitude(expm1(a) - exp) < 1e-14 * magnitude(exp));
    REQUIRE(magnitude(log1p(expm1(a)) - a) < 1e-13 * magnitude(a));
  }
  for (const double large : {4.0, 8.0}) {
    const Tensor a{large, -large, 0.1, 0, 0, 0}, e = expm1(a);
    CHECK(e(0, 0) == Approx(std::expm1(large)).epsilon(large > 4 ? 1e-11 : 1e-14));
    CHECK(e(1, 1) == Approx(std::expm1(-large)).epsilon(large > 4 ? 1e-11 : 1e-14));
    CHECK(e(2, 2) == Approx(std::expm1(0.1)).epsilon(1e-14));
  }
  CHECK(magnitude(log1p(Tensor{})) == 0);
  CHECK(magnitude(expm1(Tensor{})) == 0);
}

TEST_CASE("log1p of packs: a lane's digits do not depend on the other lanes") {
  Random random;
  for (int n = 0; n < 100; ++n) {
    Tensor a[lanes];
    for (int l = 0; l < lanes; ++l)
      for (auto& c : a[l].c) c = random(n % 2 && l % 3 == 0 ? 0.3 : 0.05);
    SymTensor<Pack<double>> all{}, alike{};
    for (int c = 0; c < 6; ++c) {
      all.c[c] = Pack<double>([&](int l) { return a[l].c[c]; });
      alike.c[c] = Pack<double>([&](int) { return a[1].c[c]; });
    }
    const auto log = log1p(all), exp = expm1(all), of_alike = log1p(alike);
    for (int c = 0; c < 6; ++c) {
      REQUIRE(lane(of_alike.c[c], 1) == lane(log.c[c], 1));
      for (int l = 0; l < lanes; ++l) {
        REQUIRE(lane(log.c[c], l) == Approx(log1p(a[l]).c[c]).margin(1e-15));
        REQUIRE(lane(exp.c[c], l) == Approx(expm1(a[l]).c[c]).margin(1e-15));
      }
    }
  }
}

TEST_CASE("spectral functions in single precision") {
  const SymTensor<float> a{0.3f, -0.2f, 0.1f, 0.15f, -0.05f, 0.02f};
  const auto back = log1p(expm1(a));
  for (int c = 0; c < 6; ++c) CHECK(back.c[c] == Approx(a.c[c]).margin(1e-6));
}
