#include <mote/eigen.hpp>
#include <mote/mote.hpp>

#include "catch.hpp"

using namespace mote;

TEST_CASE("Eigen: vectors and matrices go there and back unchanged") {
  const Vec<double, 3> v{1, 2, 3};
  CHECK(eigen::to_vec(eigen::to_eigen(v)) == v);
  const Mat<double, 3> a{{1, 2, 3, 4, 5, 6, 7, 8, 10}};
  const auto e = eigen::to_eigen(a);
  CHECK(e(0, 1) == 2);
  CHECK(e.determinant() == Approx(det(a)));
  CHECK(eigen::to_mat(e)(2, 1) == 8);
}

TEST_CASE("Eigen: principal values of a rotated uniaxial stress") {
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Mat<double, 3> r{{c, -s, 0, s, c, 0, 0, 0, 1}};
  const auto p = eigen::principal_values(rotate(r, SymTensor<double>{{5, -2, 1, 0, 0, 0}}));
  CHECK(p[0] == Approx(-2));
  CHECK(p[1] == Approx(1));
  CHECK(p[2] == Approx(5));
}

TEST_CASE("Eigen: the rotation of a stretched and rotated frame") {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Mat<double, 3> r{{c, 0, s, 0, 1, 0, -s, 0, c}}, u{{2, 0.3, 0, 0.3, 1, 0, 0, 0, 0.5}};
  const auto found = eigen::rotation_of(r * u);
  for (int i = 0; i < 9; ++i) CHECK(found.c[i] == Approx(r.c[i]).margin(1e-12));
}

TEST_CASE("Eigen: a column is seen, and written, without a copy") {
  Particles<double, 3, fields<field::Mass>> particles;
  particles.resize(3);
  auto mass = eigen::as_vector(particles.column<field::Mass>());
  mass << 1, 2, 4;
  CHECK(particles.get<field::Mass>(2) == 4);
  const auto& constant = particles;
  CHECK(eigen::as_vector(constant.column<field::Mass>()).sum() == 7);
}
