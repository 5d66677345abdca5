#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <mote/geometry/ball.hpp>
#include <mote/geometry/boolean.hpp>
#include <mote/geometry/box.hpp>
#include <mote/geometry/halfspace.hpp>

using namespace mote;
using namespace mote::geometry;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A region of a user's own, with the required members only: the band |x| <= 1.
struct Band {
  static constexpr int dimension = 2;
  bool contains(const Vec<double, 2>& x) const { return std::abs(x[0]) <= 1; }
  double level(const Vec<double, 2>& x) const { return std::abs(x[0]) - 1; }
  Bounds<2> bounds() const { return {{-1, -infinity}, {1, infinity}}; }
};

struct NoLevel {
  static constexpr int dimension = 2;
  bool contains(const Vec<double, 2>&) const { return true; }
  Bounds<2> bounds() const { return Bounds<2>::everything(); }
};

static_assert(Region<Box<1>> && Region<Ball<2>> && Region<HalfSpace<3>> && Region<Band>);
static_assert(Region<decltype(Box<2>{} - Ball<2>{})> && Region<decltype((Band{} & ~Ball<2>{}) | Box<2>{})>);
static_assert(!Region<int> && !Region<Vec<double, 3>> && !Region<NoLevel>);
template <class A, class B>
constexpr bool composable = requires(A a, B b) {
  a - b;
};
static_assert(composable<Box<2>, Ball<2>> && !composable<Box<2>, Ball<3>> && !composable<Box<2>, int>);

template <int D>
Vec<double, D> random_point(std::mt19937& random, double size) {
  Vec<double, D> x{};
  for (int k = 0; k < D; ++k) x[k] = size * (random() / 2147483648.0 - 1);
  return x;
}

/// contains and level agree; the slope of the level is at most one; levels and bounds hold what they promise.
template <Region R>
void check_consistency(const R& region) {
  constexpr int D = R::dimension;
  std::mt19937 random(1);
  bool agrees = true, gentle = true, limited = true, bounded = true;
  for (int n = 0; n < 5000; ++n) {
    const auto x = random_point<D>(random, 4), y = random_point<D>(random, 4), shift = random_point<D>(random, 1);
    const auto half = Vec<double, D>::filled(1);
    const double level = region.level(x);
    const auto range = levels(region, x, half);
    const double nearby = region.level(x + shift);
    const auto box = region.bounds();
    agrees &= level == 0 || region.contains(x) == (level < 0);
    gentle &= std::abs(level - region.level(y)) <= norm(x - y) + 1e-14;
    limited &= range.lowest <= nearby + 1e-14 && nearby <= range.highest + 1e-14;
    for (int k = 0; k < D; ++k) bounded &= level > 0 || (box.lower[k] <= x[k] && x[k] <= box.upper[k]);
  }
  CHECK(agrees);
  CHECK(gentle);
  CHECK(limited);
  CHECK(bounded);
}

template <int D>
void check_all() {
  Vec<double, D> one = Vec<double, D>::filled(1), normal{};
  for (int k = 0; k < D; ++k) normal[k] = k - 0.7;
  const Box<D> box{.lower = -1.5 * one, .upper = 2.0 * one};
  const Ball<D> ball{.centre = 0.8 * one, .radius = 1.7};
  const HalfSpace<D> half{.point = 0.3 * one, .normal = normal};
  check_consistency(box);
  check_consistency(ball);
  check_consistency(half);
  check_consistency(box - ball);
  check_consistency(box & ball);
  check_consistency(box | ball);
  check_consistency(~ball);
  check_consistency((box & half) - ball);
}

}  // namespace

TEST_CASE("contains, level, levels and bounds of every region agree", "[geometry]") {
  check_all<1>();
  check_all<2>();
  check_all<3>();
  check_consistency(Band{});
  check_consistency(Band{} - Ball<2>{.centre = {1, 0}, .radius = 1});
}

TEST_CASE("boolean operators combine what their operands contain", "[geometry]") {
  const Box<2> box{.lower = {0, 0}, .upper = {2, 2}};
  const Ball<2> ball{.centre = {2, 1}, .radius = 0.5};
  const Vec<double, 2> both{1.75, 1}, box_only{0.5, 0.5}, ball_only{2.25, 1}, neither{3, 3};
  CHECK(((box - ball).contains(box_only) && !(box - ball).contains(both) && !(box - ball).contains(ball_only)));
  CHECK(((box & ball).contains(both) && !(box & ball).contains(box_only) && !(box & ball).contains(ball_only)));
  CHECK(((box | ball).contains(both) && (box | ball).contains(ball_only) && !(box | ball).contains(neither)));
  CHECK(((~box).contains(neither) && !(~box).contains(both)));
  CHECK((box | ball).bounds().upper == Vec<double, 2>{2.5, 2});
  CHECK((box & ball).bounds().lower == Vec<double, 2>{1.5, 0.5});
  CHECK((box - ball).bounds().upper == box.upper);
}

TEST_CASE("levels are distances where they can be", "[geometry]") {
  CHECK(Ball<3>{.centre = {0, 0, 10}, .radius = 5}.level({3, 4, 10}) == Approx(0).margin(1e-15));
  CHECK(Ball<1>{.centre = {1}, .radius = 2}.level({1}) == -2);
  CHECK(Box<2>{.lower = {0, 0}, .upper = {4, 2}}.level({1, 1.5}) == -0.5);
  CHECK(HalfSpace<2>{.point = {0, 1}, .normal = {0, 7}}.level({5, 3}) == Approx(2));
}

TEST_CASE("a half space lies behind its normal and is bounded only along an axis", "[geometry]") {
  const HalfSpace<3> below{.point = {1, 2, 3}, .normal = {0, 0, 2}};
  CHECK(below.contains({100, -100, 2.9}));
  CHECK(below.contains({0, 0, 3}));
  CHECK_FALSE(below.contains({1, 2, 3.1}));
  CHECK(below.bounds().upper == Vec<double, 3>{infinity, infinity, 3});
  CHECK(below.bounds().lower == Vec<double, 3>::filled(-infinity));
  const HalfSpace<2> slanted{.point = {0, 0}, .normal = {1, 1}};
  CHECK(slanted.contains({-2, 1}));
  CHECK(slanted.bounds().upper == Vec<double, 2>::filled(infinity));
  const HalfSpace<2> right{.point = {0, 5}, .normal = {-1, 0}};
  CHECK(right.bounds().lower == Vec<double, 2>{0, -infinity});
}

TEST_CASE("regions refuse what is no region, with the value and the range", "[geometry]") {
  const double nan = std::nan("");
  CHECK_THROWS_WITH((Ball<3>{.centre = {0, 0, 0}, .radius = -1}.validate()),
                    "mote: Ball: radius = -1 m must be positive and finite");
  CHECK_THROWS_AS((Ball<2>{.centre = {nan, 0}, .radius = 1}.validate()), InputError);
  CHECK_THROWS_AS((Ball<2>{.centre = {0, 0}, .radius = infinity}.validate()), InputError);
  CHECK_THROWS_WITH((Box<2>{.lower = {0, 3}, .upper = {1, 2}}.validate()), Catch::Contains("axis 1 lower = 3 m"));
  CHECK_THROWS_AS((Box<1>{.lower = {nan}, .upper = {2}}.validate()), InputError);
  CHECK_THROWS_AS((HalfSpace<2>{.point = {0, 0}, .normal = {0, 0}}.validate()), InputError);
  CHECK_THROWS_AS((HalfSpace<2>{.point = {infinity, 0}, .normal = {1, 0}}.validate()), InputError);
  const Box<2> good{.lower = {0, 0}, .upper = {1, 1}};
  const Ball<2> bad{.centre = {0, 0}, .radius = 0};
  CHECK_NOTHROW(validate(good | Band{}));
  CHECK_THROWS_AS(validate(good - bad), InputError);
  CHECK_THROWS_AS(validate(bad | good), InputError);
  CHECK_THROWS_AS(validate(~bad), InputError);
}
