#include <mote/strength/kinematics.hpp>

#include <cmath>
#include <mote/core/pack.hpp>
#include <random>

#include "catch.hpp"

namespace {

using namespace mote;
using Matrix = Mat<double, 3>;

/// The rotation by `angle` about `axis` (Rodrigues).
Matrix rotation(Vec<double, 3> axis, double angle) {
  axis *= 1 / norm(axis);
  const double c = std::cos(angle), s = std::sin(angle);
  const Matrix cross{0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0};
  Matrix q{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) q(i, j) = c * (i == j) + s * cross(i, j) + (1 - c) * axis[i] * axis[j];
  return q;
}

double distance(const Matrix& a, const Matrix& b) {
  double sum = 0;
  for (int i = 0; i < 9; ++i) sum += (a.c[i] - b.c[i]) * (a.c[i] - b.c[i]);
  return std::sqrt(sum);
}

const Matrix eye = Matrix::identity();

struct Random {
  std::mt19937 engine{1};
  double operator()(double size) { return std::uniform_real_distribution(-size, size)(engine); }
  Matrix matrix(double size) {
    Matrix m{};
    for (double& c : m.c) c = (*this)(size);
    return m;
  }
};

}  // namespace

TEST_CASE("kinematics: no motion is no rotation and no strain") {
  const Kinematics<double> k(Matrix{});
  CHECK(distance(k.rotation, eye) == 0);
  CHECK(ddot(k.strain, k.strain) == 0);
  CHECK(k.volume_factor == 1);
}

TEST_CASE("kinematics: a rigid rotation has no strain, whatever its angle") {
  for (const double angle : {1e-6, 0.01, 0.3, 1.5, 2.5, -0.3}) {
    const Matrix q = rotation({1, -2, 0.5}, angle);
    const Kinematics<double> k(q - eye);
    CHECK(distance(k.rotation, q) < 1e-14);
    // (I + A/2)^-1 magnifies round-off as the angle nears half a turn
    CHECK(std::sqrt(ddot(k.strain, k.strain)) < 1e-15 / std::pow(std::cos(angle / 2), 2));
    CHECK(std::abs(k.volume_factor - 1) < 1e-15);
  }
}

TEST_CASE("kinematics: a pure stretch does not rotate, and its strain is the logarithm to second order") {
  double last = 0;
  for (const double e : {0.2, 0.1, 0.05}) {
    const Kinematics<double> k(Matrix{e, 0, 0, 0, -e, 0, 0, 0, 0.5 * e});
    CHECK(distance(k.rotation, eye) == 0);
    CHECK(k.volume_factor == Approx((1 + e) * (1 - e) * (1 + 0.5 * e)).epsilon(1e-15));
    CHECK(k.strain(0, 1) == 0);
    const double error = std::abs(k.strain(0, 0) - std::log(1 + e));  // e^3 / 12
    if (last > 0) CHECK(std::log2(last / error) == Approx(3).margin(0.25));
    last = error;
  }
}

TEST_CASE("kinematics: the rotation is orthogonal and the volume factor is det(I + A)") {
  Random random;
  for (int n = 0; n < 2000; ++n) {
    const Matrix a = random.matrix(std::pow(10, -4 + 3.5 * (n % 8) / 7));
    const Kinematics<double> k(a);
    REQUIRE(distance(k.rotation * transpose(k.rotation), eye) < 1e-14);
    REQUIRE(det(k.rotation) == Approx(1).epsilon(1e-14));
    REQUIRE(k.volume_factor == Approx(det(eye + a)).epsilon(1e-14));
  }
}

TEST_CASE("kinematics: an observer who turns sees the same strain, turned") {
  Random random;
  const Matrix q = rotation({0.3, 1, -2}, 0.7);
  for (int n = 0; n < 200; ++n) {
    const Matrix a = random.matrix(0.1);
    const Kinematics<double> k(a), turned(q * a * transpose(q));
    const auto difference = turned.strain - rotate(q, k.strain);
    REQUIRE(std::sqrt(ddot(difference, difference)) < 1e-15);
    REQUIRE(distance(turned.rotation, q * k.rotation * transpose(q)) < 1e-14);
  }
}

TEST_CASE("kinematics: packs give what numbers give, single precision nearly so") {
  Random random;
  Matrix one[lanes];
  Mat<Pack<double>, 3> all{};
  for (auto& a : one) a = random.matrix(0.1);
  for (int c = 0; c < 9; ++c) all.c[c] = Pack<double>([&](int l) { return one[l].c[c]; });
  const Kinematics<Pack<double>> k(all);
  for (int l = 0; l < lanes; ++l) {
    const Kinematics<double> expected(one[l]);
    Mat<float, 3> single{};
    for (int c = 0; c < 9; ++c) single.c[c] = float(one[l].c[c]);
    const Kinematics<float> rough(single);
    CHECK(lane(k.volume_factor, l) == Approx(expected.volume_factor).epsilon(1e-15));
    for (int c = 0; c < 9; ++c) {
      CHECK(lane(k.rotation.c[c], l) == Approx(expected.rotation.c[c]).margin(1e-15));
      CHECK(double(rough.rotation.c[c]) == Approx(expected.rotation.c[c]).margin(1e-6));
    }
    for (int c = 0; c < 6; ++c) {
      CHECK(lane(k.strain.c[c], l) == Approx(expected.strain.c[c]).margin(1e-15));
      CHECK(double(rough.strain.c[c]) == Approx(expected.strain.c[c]).margin(1e-7));
    }
  }
}
