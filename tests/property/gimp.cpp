/// \file
/// GIMP's kernel against what defines it: the mean of a hat over the particle's domain; its limits; and how the half
/// size follows the motion. Properties that every kernel shares are in shape.cpp.
#include <algorithm>
#include <cmath>

#include <mote/mote.hpp>

#include "catch.hpp"
#include "holds.hpp"

namespace {

using namespace mote;

/// A number in [0, 1], ends included.
double unit() { return *rc::gen::inRange(0, (1 << 20) + 1) / double(1 << 20); }

struct Kernel {
  double w[3], d[3];
  Kernel(double f, double half) {
    shape::Gimp::values(f, half, w);
    shape::Gimp::slopes(f, half, d);
  }
};

double hat(double r) { return std::max(0.0, 1 - std::abs(r)); }

/// The mean of the hat of node i over [f - l, f + l], by the midpoint rule: off by at most 1/2 (2 l/n)^2 / (2 l) for a
/// kink in a piece.
double mean_of_hat(int i, double f, double l) {
  constexpr int n = 20000;
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += hat(f - l + (k + 0.5) * 2 * l / n - i);
  return sum / n;
}

}  // namespace

TEST_CASE("gimp: weights are means of hats, slopes their differences over the domain", "[shape][gimp][property]") {
  CHECK(holds([] {
    const double f = 0.5 + unit(), l = 1e-3 + 0.499 * unit();
    const Kernel kernel(f, l);
    for (int i = 0; i < 3; ++i) {
      RC_ASSERT(std::abs(kernel.w[i] - mean_of_hat(i, f, l)) < 1e-8);
      // d/df of (1/2l) int hat is the difference of the hat at the ends over 2 l
      RC_ASSERT(std::abs(kernel.d[i] - (hat(f + l - i) - hat(f - l - i)) / (2 * l)) < 1e-12);
    }
  }));
}

TEST_CASE("gimp: half a cell makes it the quadratic B-spline, and more too", "[shape][gimp][property]") {
  CHECK(holds([] {
    const double f = 0.5 + unit(), half = 0.5 + 3 * unit();
    const Kernel kernel(f, half);
    double w[3], d[3];
    shape::QuadraticBSpline::values(f, w);
    shape::QuadraticBSpline::slopes(f, d);
    for (int i = 0; i < 3; ++i) {
      RC_ASSERT(std::abs(kernel.w[i] - w[i]) < 1e-15);
      RC_ASSERT(std::abs(kernel.d[i] - d[i]) < 1e-15);
    }
  }));
}

TEST_CASE("gimp: no size makes it the linear hat, and less too", "[shape][gimp][property]") {
  CHECK(holds([] {
    const double f = 0.5 + unit(), half = unit() - 1;
    const Kernel kernel(f, half);
    for (int i = 0; i < 3; ++i) {
      RC_ASSERT(std::abs(kernel.w[i] - hat(f - i)) < 0.51e-6);
      if (std::abs(f - 1) > 1e-6)
        RC_ASSERT(std::abs(kernel.d[i] - (i == (f < 1 ? 0 : 1) ? -1 : i == (f < 1 ? 1 : 2))) < 1e-12);
    }
  }));
}

TEST_CASE("gimp: in motion along the axes the box follows the volume, sheared or spun it stays", "[shape][gimp]") {
  Values<double, 3, fields<field::HalfSize, field::VolumeRatio>> p{};
  get<field::HalfSize>(p) = {1, 2, 3};
  Mat<double, 3> a{};
  a(0, 0) = 0.25, a(1, 1) = -0.5, a(2, 2) = 1;
  shape::ContiguousGimp::deform(p, a);
  CHECK(get<field::HalfSize>(p) == Vec<double, 3>{1.25, 1, 6});
  Mat<double, 3> b{};
  b(0, 1) = 0.3, b(1, 0) = -0.3, b(1, 2) = 0.7;
  shape::ContiguousGimp::deform(p, b);
  CHECK(get<field::HalfSize>(p) == Vec<double, 3>{1.25, 1, 6});
}

namespace {

const Material dust{eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1e-30}};

/// A free block of dust in the velocity field diag(rates) x; its particles' half sizes over the first ones, and J.
template <class Shape, class Update>
void stretch(int steps) {
  const double dt = 0.01;
  const Vec<double, 2> rates{0.5, -0.25};
  Solver solver{grid::Cartesian<2>{.spacing = 1}, Shape{}, transfer::Flip{}, Update{}, timestep::Fixed{.dt = dt}, dust};
  solver.fill(geometry::Box<2>{.lower = {-4, -4}, .upper = {4, 4}}, dust,
              {.per_axis = 3, .velocity = [&](const Vec<double, 2>& x) {
                 return Vec<double, 2>{rates[0] * x[0], rates[1] * x[1]};
               }});
  auto& p = solver.particles();
  for (int a = 0; a < 2; ++a)
    for (const double half : p.template column<field::HalfSize>(a)) CHECK(half == Approx(1.0 / 6).epsilon(1e-15));
  for (int i = 0; i < steps; ++i) solver.step();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto half = p.template get<field::HalfSize>(i);
    const double J = p.template column<field::VolumeRatio>()[i], moved = 36 * half[0] * half[1];
    if (std::is_same_v<Shape, shape::Gimp>)
      CHECK((half[0] == 0.5 / 3 && half[1] == 0.5 / 3));
    else
      CHECK(std::abs(moved / J - 1) < 1e-12);
  }
}

}  // namespace

TEST_CASE("gimp: a solver moves the half sizes of ContiguousGimp with the strain, those of Gimp never", "[gimp]") {
  stretch<shape::ContiguousGimp, update::Usl>(30);
  stretch<shape::ContiguousGimp, update::Musl>(30);
  stretch<shape::Gimp, update::Usl>(30);
}

TEST_CASE("gimp: a particle that was cut at the surface keeps the lattice's half size", "[gimp]") {
  Solver solver{grid::Cartesian<2>{.spacing = 2}, shape::Gimp{}, transfer::Flip{}, timestep::Fixed{.dt = 1}, dust};
  solver.fill(geometry::Ball<2>{.centre = {0, 0}, .radius = 5}, dust,
              {.per_axis = 2, .method = geometry::Method::fraction});
  const auto mass = solver.particles().column<field::Mass>();
  CHECK(*std::min_element(mass.begin(), mass.end()) < 0.5);  // of a whole one's 1
  for (int a = 0; a < 2; ++a)
    for (const double half : solver.particles().column<field::HalfSize>(a)) CHECK(half == 0.5);
}

TEST_CASE("gimp: beyond half a cell the column goes on with the stretch, out and back", "[gimp]") {
  Solver solver{grid::Cartesian<1>{.spacing = 1}, shape::ContiguousGimp{}, transfer::Flip{},
                timestep::Fixed{.dt = 0.01}, dust};
  solver.fill(geometry::Box<1>{.lower = {-3}, .upper = {3}}, dust,
              {.per_axis = 1, .velocity = [](const Vec<double, 1>& x) { return x; }});
  auto& p = solver.particles();
  const auto check = [&](double least, double most) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double J = p.column<field::VolumeRatio>()[i];
      CAPTURE(i, J);
      CHECK(J > least);
      CHECK(J < most);
      CHECK(p.column<field::HalfSize>()[i] == Approx(0.5 * J).epsilon(1e-14));
    }
  };
  for (int i = 0; i < 10; ++i) solver.step();
  check(1.05, 1.11);  // x = X (1 + t), but for the free ends
  for (auto& v : p.column<field::Velocity>()) v *= -1;
  solver.refresh();
  for (int i = 0; i < 10; ++i) solver.step();
  check(0.99, 1.01);
}
