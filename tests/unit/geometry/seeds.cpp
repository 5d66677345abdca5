#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include <mote/geometry/ball.hpp>
#include <mote/geometry/boolean.hpp>
#include <mote/geometry/box.hpp>
#include <mote/geometry/halfspace.hpp>
#include <mote/geometry/seeds.hpp>

using namespace mote;
using namespace mote::geometry;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr SeedOptions fraction{.method = Method::fraction};

template <int D>
Seed<D> total(const std::vector<Seed<D>>& seeds) {
  Seed<D> sum{};
  for (const auto& seed : seeds) {
    sum.volume += seed.volume;
    sum.position += seed.volume * seed.position;
  }
  sum.position *= 1 / sum.volume;
  return sum;
}

/// Checks the volume and the centroid of a fill with sites of size d, relative to the volume and its root.
template <Region R>
void check_fill(const R& region, double d, double volume, const Vec<double, R::dimension>& centroid, double tolerance) {
  const auto sum = total(seeds(region, {.spacing = d, .per_axis = 1}, fraction));
  CHECK(sum.volume == Approx(volume).epsilon(tolerance));
  CHECK(norm(sum.position - centroid) < tolerance * std::pow(volume, 1.0 / R::dimension));
}

template <int D>
bool same(const std::vector<Seed<D>>& a, const std::vector<Seed<D>>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.position == other.position && one.volume == other.volume;
  });
}

/// The cavity scene of DESIGN.md section 4, in metres.
const auto scene = Box<3>{.lower = {-20e-6, -20e-6, 0}, .upper = {20e-6, 20e-6, 50e-6}} -
                   Ball<3>{.centre = {0, 0, 10e-6}, .radius = 5e-6};
const Lattice<3> paper{.spacing = 1e-6, .per_axis = 2};

}  // namespace

TEST_CASE("the lattice fill of the cavity scene has the paper's particles", "[geometry]") {
  const auto particles = seeds(scene, paper);
  CHECK(particles.size() == 635776);
  CHECK((80000e-18 - total(particles).volume) == Approx(528e-18).epsilon(1e-9));
  CHECK(norm(particles.front().position - Vec<double, 3>{-19.75e-6, -19.75e-6, 0.25e-6}) < 1e-18);
  CHECK(norm(particles[1].position - Vec<double, 3>{-19.25e-6, -19.75e-6, 0.25e-6}) < 1e-18);
}

TEST_CASE("the fraction fill of the cavity scene misses the ball's volume", "[geometry]") {
  const auto particles = seeds(scene, paper, fraction);
  const double ball = 4.0 / 3 * pi * 125e-18;
  CHECK((80000e-18 - total(particles).volume) == Approx(ball).epsilon(1e-5));
  const auto sum = total(particles);
  CHECK(sum.position[2] == Approx((80000 * 25e-6 - ball * 1e18 * 10e-6) / (80000 - ball * 1e18)).epsilon(1e-7));
  double least = 1;
  for (const auto& seed : particles) least = std::min(least, seed.volume / 0.125e-18);
  CHECK(least >= 1e-3);
}

TEST_CASE("a region on the lattice's planes is filled with whole sites by both methods", "[geometry]") {
  const Box<3> block{.lower = {-20e-6, 0, 5e-6}, .upper = {-10e-6, 7e-6, 25e-6}};
  const auto whole = seeds(block, paper), cut = seeds(block, paper, fraction);
  CHECK(whole.size() == 20 * 14 * 40);
  CHECK(same(whole, cut));
}

TEST_CASE("volumes and centroids of cut regions, coarse to fine", "[geometry]") {
  struct Row {
    double size, tolerance;
  };
  for (const auto& [d, tolerance] : {Row{1, 1e-3}, Row{0.5, 4e-4}, Row{0.2, 6e-5}, Row{0.1, 2e-5}}) {
    CAPTURE(d);
    check_fill(Ball<1>{.centre = {0.13}, .radius = 0.87}, d, 1.74, {0.13}, 1e-9);
    check_fill(Ball<2>{.centre = {0.13, -0.2}, .radius = 1}, d, pi, {0.13, -0.2}, tolerance);
    check_fill(Ball<3>{.centre = {0.13, -0.2, 0.3}, .radius = 1}, d, 4 * pi / 3, {0.13, -0.2, 0.3}, tolerance);
    check_fill(Box<1>{.lower = {-0.33}, .upper = {1.04}}, d, 1.37, {0.355}, 1e-3);
    check_fill(Box<2>{.lower = {-0.33, 0.1}, .upper = {1.87, 2.3}}, d, 4.84, {0.77, 1.2}, tolerance);
    check_fill(Box<3>{.lower = {-0.33, 0.1, 0.2}, .upper = {1.87, 2.3, 2.4}}, d, 10.648, {0.77, 1.2, 1.3}, tolerance);
  }
}

TEST_CASE("volumes of cut booleans", "[geometry]") {
  const Box<2> square{.lower = {-1, -1}, .upper = {1, 1}};
  const Ball<2> left{.centre = {-0.5, 0}, .radius = 1}, right{.centre = {0.5, 0}, .radius = 1};
  const double lens = 2 * std::acos(0.5) - 0.5 * std::sqrt(3.0);
  check_fill(left & right, 0.13, lens, {0, 0}, 2e-4);
  check_fill(left | right, 0.13, 2 * pi - lens, {0, 0}, 2e-4);
  const HalfSpace<2> lower_half{.point = {0, 0}, .normal = {0, 3}};
  check_fill((left - right) & lower_half, 0.05, (pi - lens) / 2, {-0.5 * pi / (pi - lens), -11.0 / 12 / (pi - lens)},
             2e-4);
  const HalfSpace<2> slanted{.point = {0, 0}, .normal = {1, 1}};
  check_fill(square & slanted, 0.13, 2, {-1.0 / 3, -1.0 / 3}, 2e-4);
  check_fill(square - slanted, 0.13, 2, {1.0 / 3, 1.0 / 3}, 2e-4);
  const HalfSpace<3> below{.point = {0, 0, 0.1}, .normal = {0, 0, 1}};
  const Ball<3> ball{.centre = {0, 0, 0.1}, .radius = 1};
  check_fill(ball & below, 0.13, 2 * pi / 3, {0, 0, 0.1 - 3.0 / 8}, 2e-4);
  const auto bored = Box<3>{.lower = {0, 0, 0}, .upper = {2, 2, 2}} - Ball<3>{.centre = {0, 0, 0}, .radius = 1};
  const double rest = 8 - pi / 6, moment = (8 - pi / 16) / rest;
  check_fill(bored, 0.13, rest, {moment, moment, moment}, 2e-4);
}

TEST_CASE("a cut plane is exact at any slope", "[geometry]") {
  for (const double slope : {0.0, 1e-9, 1e-4, 0.3, 1.0, 17.0}) {
    CAPTURE(slope);
    const HalfSpace<3> plane{.point = {0.5, 0.5, 0.5}, .normal = {1, slope, slope / 3}};
    const Vec<double, 3> centre{0.5, 0.5, 0.5};
    geometry::detail::Piece<3> below, above;
    const auto outside = ~plane;
    geometry::detail::Cut<HalfSpace<3>>{plane, centre}.add_inside({}, 0.5, 0, below);
    geometry::detail::Cut<Complement<HalfSpace<3>>>{outside, centre}.add_inside({}, 0.5, 0, above);
    CHECK(below.volume == Approx(0.5).epsilon(1e-12));
    CHECK(above.volume == Approx(0.5).epsilon(1e-12));
    CHECK(norm(below.moment + above.moment) < 1e-14);
  }
  // The corner tetrahedron x + 2y + 4z < 1/2: volume abc/6 with a = 1/2, b = 1/4, c = 1/8, centroid a quarter of each.
  const HalfSpace<3> corner{.point = {0.5, 0, 0}, .normal = {1, 2, 4}};
  geometry::detail::Piece<3> piece;
  geometry::detail::Cut<HalfSpace<3>>{corner, {0.5, 0.5, 0.5}}.add_inside({}, 0.5, 0, piece);
  CHECK(piece.volume == Approx(1.0 / 384).epsilon(1e-12));
  CHECK(piece.moment[2] == Approx((1.0 / 32 - 0.5) / 384).epsilon(1e-12));
}

TEST_CASE("cut seeds are mirror symmetric where the lattice is", "[geometry]") {
  const auto region = Box<3>{.lower = {-3.3, -3.3, 0}, .upper = {3.3, 3.3, 4.1}} -
                      Ball<3>{.centre = {0, 0, 2}, .radius = 1.77} - Ball<3>{.centre = {0, 0, 4}, .radius = 0.6};
  const auto all = seeds(region, {.spacing = 0.5, .per_axis = 2}, fraction);
  std::map<std::array<long, 3>, Seed<3>> by_site;  // a site has one seed, within its box or next to it
  const auto key = [](const Vec<double, 3>& x, double sx, double sy) {
    return std::array{std::lround(sx * x[0] * 1e6), std::lround(sy * x[1] * 1e6), std::lround(x[2] * 1e6)};
  };
  for (const auto& seed : all) by_site[key(seed.position, 1, 1)] = seed;
  CHECK(by_site.size() == all.size());
  double worst_volume = 0, worst_place = 0;
  for (const auto& seed : all)
    for (const auto& [sx, sy] : {std::pair{-1, 1}, std::pair{1, -1}, std::pair{-1, -1}}) {
      const auto image = by_site.find(key(seed.position, sx, sy));
      REQUIRE(image != by_site.end());
      const auto& there = image->second;
      const Vec<double, 3> mirrored{sx * there.position[0], sy * there.position[1], there.position[2]};
      worst_volume = std::max(worst_volume, std::abs(there.volume / seed.volume - 1));
      worst_place = std::max(worst_place, norm(mirrored - seed.position));
    }
  CHECK(worst_volume < 1e-12);
  CHECK(worst_place < 1e-12);
}

TEST_CASE("slivers join their neighbours, with volume and moments kept", "[geometry]") {
  // The segment reaches 2e-4 of a site into the last one.
  const auto filled = seeds(Box<1>{.lower = {0}, .upper = {3.0002}}, {.spacing = 1, .per_axis = 1}, fraction);
  CHECK(filled.size() == 3);
  CHECK(total(filled).volume == Approx(3.0002).epsilon(1e-12));
  CHECK(total(filled).position[0] == Approx(1.5001).epsilon(1e-12));
  const Box<2> box{.lower = {0, 0}, .upper = {3.0002, 2}};
  CHECK(seeds(box, {.spacing = 1, .per_axis = 1}, fraction).size() == 6);

  // Smaller than a sliver, but with nobody to join.
  const Box<3> speck{.lower = {0.4, 0.4, 0.4}, .upper = {0.48, 0.48, 0.48}};
  const auto alone = seeds(speck, {.spacing = 1, .per_axis = 1}, fraction);
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].volume < 1e-3);
  CHECK(norm(alone[0].position - Vec<double, 3>{0.44, 0.44, 0.44}) < 0.02);

  const Ball<3> ball{.centre = {0.13, 0.21, 0.37}, .radius = 7.7};
  const geometry::detail::Sites<3> sites(ball.bounds(), {.spacing = 1, .per_axis = 1});
  auto placed = geometry::detail::fill_fraction(ball, sites);
  const auto seeds_of = [](const auto& from) {
    std::vector<Seed<3>> result;
    for (const auto& one : from) result.push_back(one.seed);
    return result;
  };
  const auto before = seeds_of(placed);
  geometry::detail::merge_slivers(placed, sites);
  const auto after = seeds_of(placed);
  CHECK(after.size() < before.size());
  CHECK(total(after).volume == Approx(total(before).volume).epsilon(1e-13));
  CHECK(norm(total(after).position - total(before).position) < 1e-12);
}

TEST_CASE("jitter is reproducible, bounded, and stays inside", "[geometry]") {
  const Ball<2> disc{.centre = {0.2, 0.1}, .radius = 5};
  const Lattice<2> lattice{.spacing = 1, .per_axis = 2};
  const SeedOptions options{.jitter = 0.4, .seed = 7};
  const auto still = seeds(disc, lattice), shaken = seeds(disc, lattice, options);
  CHECK(same(shaken, seeds(disc, lattice, options)));
  CHECK_FALSE(same(shaken, seeds(disc, lattice, {.jitter = 0.4, .seed = 8})));
  REQUIRE(still.size() == shaken.size());
  double furthest = 0;
  Vec<double, 2> mean{};
  bool inside = true;
  for (std::size_t p = 0; p < still.size(); ++p) {
    const auto shift = shaken[p].position - still[p].position;
    for (int k = 0; k < 2; ++k) furthest = std::max(furthest, std::abs(shift[k]));
    mean += (1.0 / double(still.size())) * shift;
    inside &= disc.contains(shaken[p].position);
  }
  CHECK(furthest <= 0.2);
  CHECK(furthest > 0.19);
  CHECK(norm(mean) < 0.02);  // 0.2 / sqrt(3 x 314) per axis is 0.0065
  CHECK(inside);
}

TEST_CASE("jitter hangs on the lattice site, not on the region, and is the same on every machine", "[geometry]") {
  const Box<2> all{.lower = {-4, -4}, .upper = {4, 4}}, part{.lower = {-1, 0}, .upper = {3, 2}};
  const Lattice<2> lattice{.spacing = 1, .per_axis = 1};
  const SeedOptions options{.jitter = 0.5, .seed = 42};
  const auto many = seeds(all, lattice, options);
  for (const auto& seed : seeds(part, lattice, options))
    CHECK(std::any_of(many.begin(), many.end(), [&](const auto& one) { return one.position == seed.position; }));
  CHECK(geometry::detail::mix(0) == 0xE220A8397B1DCDAFu);  // the first number of splitmix64 with seed 0 (Vigna's splitmix64.c)
  const auto shift = geometry::detail::jitter_at<2>({3, -5}, 42, 1);
  CHECK(shift[0] == -0.47956498702513195);
  CHECK(shift[1] == 0.58385458890966957);
}

TEST_CASE("seeds refuse what cannot be filled", "[geometry]") {
  const Box<2> box{.lower = {0, 0}, .upper = {1, 1}};
  CHECK_THROWS_AS(seeds(box, {.spacing = 0}), InputError);
  CHECK_THROWS_AS(seeds(box, {.spacing = infinity}), InputError);
  CHECK_THROWS_AS(seeds(box, {.spacing = 0.1, .per_axis = 0}), InputError);
  CHECK_THROWS_AS(seeds(box, {.spacing = 0.1, .origin = {infinity, 0}}), InputError);
  CHECK_THROWS_WITH(seeds(box, {.spacing = 0.1}, {.jitter = 0.6}), Catch::Contains("jitter = 0.6 must be from 0 to"));
  CHECK_THROWS_AS(seeds(box, {.spacing = 0.1}, {.jitter = std::nan("")}), InputError);
  CHECK_THROWS_WITH(seeds(box, {.spacing = 1e-6}), Catch::Contains("2^31 sites"));
  CHECK_THROWS_AS(seeds(Box<1>{.lower = {1e200}, .upper = {2e200}}, {.spacing = 1}), InputError);
  CHECK_THROWS_WITH(seeds(~box, {.spacing = 0.1}), Catch::Contains("take it together with a Box"));
  CHECK_THROWS_AS(seeds(HalfSpace<2>{.point = {0, 0}, .normal = {0, 1}}, {.spacing = 0.1}), InputError);
  CHECK_THROWS_WITH(seeds(Ball<2>{.centre = {1, 1}, .radius = 0.1}, {.spacing = 1, .per_axis = 1}),
                    Catch::Contains("holds no particle"));
  CHECK_THROWS_AS(seeds(box - box, {.spacing = 0.1}, fraction), InputError);
  CHECK_THROWS_AS(seeds(box & Ball<2>{.centre = {5, 5}, .radius = 1}, {.spacing = 0.1}), InputError);
  CHECK_THROWS_AS(seeds(Ball<2>{.centre = {1, 1}, .radius = -1}, {.spacing = 1}), InputError);
}
