// The size of a void, from clouds of particles whose void is known.
#include <catch2/catch.hpp>
#include <mote/observe/void_component.hpp>

#include <functional>
#include <random>

using namespace mote;
using namespace mote::observe;

namespace {

constexpr double um = 1e-6;

template <class T>
struct Cloud {
  std::vector<T> x, y, z, volume;
  ParticleColumns<T> columns() const { return {x, y, z, volume}; }
};

using Inside = std::function<bool(const Vec<double, 3>&)>;  // of the void, um

Inside ellipsoid(Vec<double, 3> c, Vec<double, 3> r) {
  return [=](const Vec<double, 3>& x) {
    double sum = 0;
    for (int a = 0; a < 3; ++a) sum += std::pow((x[a] - c[a]) / r[a], 2);
    return sum <= 1;
  };
}
Inside ball(Vec<double, 3> c, double r) { return ellipsoid(c, {r, r, r}); }

/// Particles d apart in the box, but for the void; volumes cut by `cut`^3 samples if cut > 1. Lengths in um.
template <class T = double>
Cloud<T> fill(Vec<double, 3> lower, Vec<double, 3> upper, double d, const Inside& is_void, int cut = 1,
              double shift = 0) {
  Cloud<T> cloud;
  IVec<3> n{};
  for (int a = 0; a < 3; ++a) n[a] = int(std::lround((upper[a] - lower[a]) / d));
  for_box({IVec<3>{}, n - IVec<3>::filled(1)}, [&](const IVec<3>& i) {
    Vec<double, 3> sum{};
    int full = 0;
    for_box({IVec<3>{}, IVec<3>::filled(cut - 1)}, [&](const IVec<3>& k) {
      Vec<double, 3> x{};
      for (int a = 0; a < 3; ++a) x[a] = lower[a] + d * (i[a] + (k[a] + 0.5) / cut);
      if (!is_void(x)) ++full, sum += x;
    });
    if (full == 0) return;
    cloud.x.push_back(T(sum[0] / full * um));
    cloud.y.push_back(T(sum[1] / full * um));
    cloud.z.push_back(T((sum[2] / full + shift) * um));
    cloud.volume.push_back(T(full * std::pow(d * um / cut, 3)));
  });
  return cloud;
}

const Extent half_free{0, 50 * um, Extent::plane, Extent::free_};
const Extent quarter{0, 20 * um, Extent::plane, Extent::plane};
Extent cyclic(double half) { return {-half * um, half * um, Extent::periodic, Extent::periodic}; }
Extent mirrored(double half) { return {0, half * um, Extent::plane, Extent::free_, true}; }

double um3(double v) { return v / (um * um * um); }

}  // namespace

TEST_CASE("void: the cavity of the scene, lattice fill", "[void]") {
  const double h = GENERATE(0.5, 1.0, 2.0);
  const bool cut = GENERATE(false, true);
  const auto cloud = fill({cut ? 0. : -20., cut ? 0. : -20., 0}, {20, 20, 50}, 0.5, ball({0, 0, 10}, 5));
  const Extent side = cut ? mirrored(20) : cyclic(20);
  VoidComponent cavity(h * um, {side, side, half_free}, {0, 0, 10 * um});
  for (int call = 0; call < 2; ++call) {
    const VoidSize size = cavity.measure(cloud.columns());
    CHECK_FALSE(size.open);
    CHECK(um3(size.volume) == Approx(528).epsilon(1e-10));
    CHECK(size.width / um == Approx(10).margin(h == 2 ? 0.15 : 0.1));
    CHECK(size.height / um == Approx(10).margin(h == 2 ? 0.15 : 0.1));
  }
}

TEST_CASE("void: particles in several chunks, single precision, a symmetry plane that mirrors nothing", "[void]") {
  const auto low = fill<float>({-20, -20, 0}, {20, 20, 8}, 0.5, ball({0, 0, 10}, 5));
  const auto high = fill<float>({-20, -20, 8}, {20, 20, 50}, 0.5, ball({0, 0, 10}, 5));
  VoidComponent cavity(um, {cyclic(20), cyclic(20), half_free}, {0, 0, 10 * um});
  const std::vector<ParticleColumns<float>> chunks{low.columns(), high.columns()};
  CHECK(um3(cavity.measure(std::span<const ParticleColumns<float>>(chunks)).volume) == Approx(528).epsilon(1e-5));

  const auto part = fill({0, 0, 0}, {20, 20, 30}, 0.5, ball({0, 0, 10}, 5));
  VoidComponent plain(um, {quarter, quarter, half_free}, {0, 0, 10 * um});
  const VoidSize size = plain.measure(part.columns());
  CHECK(um3(size.volume) == Approx(132).epsilon(1e-10));
  CHECK(size.width / um == Approx(5).margin(0.05));
}

TEST_CASE("void: a quarter between symmetry planes is measured as the whole", "[void]") {
  const auto part = fill({0, 0, 0}, {20, 20, 30}, 0.5, ball({0, 0, 10}, 5));
  Extent cut = quarter;
  cut.mirrored = true;
  VoidComponent cavity(um, {cut, cut, half_free}, {0, 0, 10 * um});
  const VoidSize size = cavity.measure(part.columns());
  CHECK(um3(size.volume) == Approx(528).epsilon(1e-10));
  CHECK(size.width / um == Approx(10).margin(0.1));
  CHECK(size.height / um == Approx(10).margin(0.1));

  Extent upper_only{-20 * um, 0, Extent::free_, Extent::plane, true};
  CHECK_THROWS_AS(VoidComponent(um, {upper_only, cut, half_free}, {0, 0, 10 * um}), InputError);
}

TEST_CASE("void: volumes as mass, ratio and density", "[void]") {
  const auto cloud = fill({-12, -12, 0}, {12, 12, 26}, 0.5, ball({0, 0, 12}, 5));
  std::vector<double> mass(cloud.volume.size()), ratio(cloud.volume.size());
  for (std::size_t i = 0; i < mass.size(); ++i) {
    ratio[i] = 1 + 0.1 * double(i % 3);
    mass[i] = 2700 * cloud.volume[i] / ratio[i];
  }
  const ParticleColumns<double> columns{cloud.x, cloud.y, cloud.z, mass, ratio, 1. / 2700};
  VoidComponent plain(um, {cyclic(12), cyclic(12), half_free}, {0, 0, 12 * um}), made = plain;
  CHECK(made.measure(columns).volume == Approx(plain.measure(cloud.columns()).volume).epsilon(1e-12));
}

TEST_CASE("void: particles up to two cells beyond a periodic side count in the period", "[void]") {
  const double at = GENERATE(-20., -11., -10., -9., 0., 9., 10., 11., 19.5);  // of the cavity, over the period
  const Inside one = ball({at, 0, 12}, 3), left = ball({at - 40, 0, 12}, 3), right = ball({at + 40, 0, 12}, 3);
  auto cloud = fill({-20, -12, 0}, {20, 12, 26}, 0.5, [&](const auto& x) { return one(x) || left(x) || right(x); });
  const std::array<Extent, 3> domain{cyclic(20), cyclic(12), half_free};
  VoidComponent before(um, domain, {at * um, 0, 12 * um}), after = before;
  const VoidSize size = before.measure(cloud.columns());
  for (std::size_t i = 0; i < cloud.x.size(); i += 2) {
    double &x = cloud.x[i], &y = cloud.y[i];
    if (std::abs(x) > 18 * um) x -= std::copysign(40 * um, x);
    if (std::abs(y) > 10 * um) y -= std::copysign(24 * um, y);
  }
  const VoidSize moved = after.measure(cloud.columns());
  CHECK(moved.volume == Approx(size.volume).epsilon(1e-10));
  CHECK(moved.width == Approx(size.width).epsilon(1e-9));
  CHECK(moved.height == Approx(size.height).epsilon(1e-9));
}

TEST_CASE("void: ellipsoids anywhere in the cell", "[void]") {
  const Vec<double, 3> r = GENERATE(Vec<double, 3>{5, 5, 5}, Vec<double, 3>{7, 5, 4}, Vec<double, 3>{4, 4, 8});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for (int trial = 0; trial < 3; ++trial) {
    const Vec<double, 3> c{offset(random), offset(random), 15 + offset(random)};
    const auto cloud = fill({-12, -12, 0}, {12, 12, 30}, 0.5, ellipsoid(c, r), 4);
    VoidComponent cavity(um, {cyclic(12), cyclic(12), half_free}, um * c);
    const VoidSize size = cavity.measure(cloud.columns());
    CHECK(um3(size.volume) == Approx(4 * M_PI / 3 * r[0] * r[1] * r[2]).epsilon(1e-3));
    CHECK(size.width / um == Approx(2 * r[0]).margin(0.08));
    CHECK(size.height / um == Approx(2 * r[2]).margin(0.08));
  }
}

TEST_CASE("void: noise of jittered particles moves the size by little", "[void]") {
  auto cloud = fill({-12, -12, 0}, {12, 12, 30}, 0.5, ball({0.2, 0.3, 15.4}, 5), 4);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.125 * um, 0.125 * um);
  for (auto* column : {&cloud.x, &cloud.y, &cloud.z})
    for (double& x : *column) x += jitter(random);
  VoidComponent cavity(um, {cyclic(12), cyclic(12), half_free}, {0.2 * um, 0.3 * um, 15.4 * um});
  const VoidSize size = cavity.measure(cloud.columns());
  CHECK(um3(size.volume) == Approx(523.6).epsilon(0.004));
  CHECK(size.width / um == Approx(10).margin(0.15));
  CHECK(size.height / um == Approx(10).margin(0.15));
}

TEST_CASE("void: followed while it moves far from its initial place", "[void]") {
  const auto cloud = fill({-12, -12, 0}, {12, 12, 26}, 0.5, ball({0, 0, 12}, 5), 4);
  auto moved = cloud;
  VoidComponent cavity(um, {cyclic(12), cyclic(12), Extent{0, 26 * um}}, {0, 0, 12 * um});
  for (int call = 0; call <= 60; ++call) {  // up by 42 um, sideways by more than a period
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      double x = cloud.x[i] + 0.5 * call * um;
      while (x >= 12 * um) x -= 24 * um;
      moved.x[i] = x;
      moved.z[i] = cloud.z[i] + 0.7 * call * um;
    }
    const VoidSize size = cavity.measure(moved.columns());
    INFO("call " << call);
    REQUIRE_FALSE(size.open);
    REQUIRE(um3(size.volume) == Approx(523.6).epsilon(2e-3));
    REQUIRE(size.width / um == Approx(10).margin(0.1));
  }
}

TEST_CASE("void: neighbours, free surfaces and images count for themselves", "[void]") {
  const double gap = GENERATE(3.0, 4.0, 6.0);
  const Inside one = ball({0, 0, 8}, 4), two = ball({0, 0, 16 + gap}, 4);
  const Inside both = [&](const Vec<double, 3>& x) { return one(x) || two(x); };
  const double top = std::ceil(20 + 2 * gap);   // a gap above the upper one too
  const double half = 4 + std::floor(gap) / 2;  // and to its images
  const auto cloud = fill({-half, -half, 0}, {half, half, top}, 0.5, both, 4);
  const std::array<Extent, 3> domain{cyclic(half), cyclic(half), half_free};
  VoidComponent lower(um, domain, {0, 0, 8 * um}), upper(um, domain, {0, 0, (16 + gap) * um});
  const double exact = 4 * M_PI / 3 * 64;
  const double a = um3(lower.measure(cloud.columns()).volume), b = um3(upper.measure(cloud.columns()).volume);
  CHECK(a == Approx(exact).epsilon(2e-3));
  CHECK(b == Approx(exact).epsilon(gap < 4 ? 0.01 : 2e-3));
}

TEST_CASE("void: a rim between two voids, or under the free surface, is counted once", "[void]") {
  const Inside two = [](const Vec<double, 3>& x) {
    const bool column = std::abs(x[0]) < 4.5 && std::abs(x[1]) < 4.5;
    return column && ((x[2] > 3.5 && x[2] < 9.5) || (x[2] > 11.5 && x[2] < 17.5));
  };
  const auto cloud = fill({-12, -12, 0}, {12, 12, 19.5}, 0.5, two);
  for (const double z : {6 * um, 14 * um}) {
    VoidComponent cavity(um, {cyclic(12), cyclic(12), half_free}, {0, 0, z});
    const VoidSize size = cavity.measure(cloud.columns());
    CHECK(um3(size.volume) == Approx(9 * 9 * 6).epsilon(1e-10));
    CHECK(size.width / um == Approx(9).margin(0.1));
    CHECK(size.height / um == Approx(6).margin(0.1));
  }
}

TEST_CASE("void: periodic neighbours across the edge of the domain", "[void]") {
  const Inside split = [](const Vec<double, 3>& x) { return ball({-20, 0, 10}, 5)(x) || ball({20, 0, 10}, 5)(x); };
  const auto cloud = fill({-20, -20, 0}, {20, 20, 30}, 0.5, split);
  VoidComponent cavity(um, {cyclic(20), cyclic(20), half_free}, {20 * um, 0, 10 * um});
  for (int call = 0; call < 2; ++call) {
    const VoidSize size = cavity.measure(cloud.columns());
    CHECK(um3(size.volume) == Approx(528).epsilon(1e-10));
    CHECK(size.width / um == Approx(10).margin(0.1));
    CHECK(size.height / um == Approx(10).margin(0.1));
  }
}

TEST_CASE("void: close to the wall", "[void]") {
  const auto cloud = fill({-12, -12, 0}, {12, 12, 20}, 0.5, ball({0, 0, 6}, 5));
  VoidComponent cavity(um, {cyclic(12), cyclic(12), half_free}, {0, 0, 6 * um});
  const VoidSize size = cavity.measure(cloud.columns());
  CHECK(um3(size.volume) == Approx(528).epsilon(1e-10));
  CHECK(size.height / um == Approx(10).margin(0.1));
}

TEST_CASE("void: open to the outside is nan, and stays so until reset", "[void]") {
  const auto closed = fill({-12, -12, 0}, {12, 12, 20}, 0.5, ball({0, 0, 10}, 4));
  const Inside pierced = [](const Vec<double, 3>& x) {
    return ball({0, 0, 10}, 4)(x) || (x[2] > 10 && std::hypot(x[0], x[1]) < 2);
  };
  const auto open = fill({-12, -12, 0}, {12, 12, 20}, 0.5, pierced);
  VoidComponent cavity(um, {cyclic(12), cyclic(12), half_free}, {0, 0, 10 * um});
  CHECK_FALSE(cavity.measure(closed.columns()).open);
  for (const auto* cloud : {&open, &closed}) {
    const VoidSize size = cavity.measure(cloud->columns());
    CHECK(size.open);
    CHECK(std::isnan(size.volume));
    CHECK(std::isnan(size.width));
    CHECK(std::isnan(size.height));
  }
  cavity.reset();
  CHECK_FALSE(cavity.measure(closed.columns()).open);
  CHECK(VoidComponent(um, {cyclic(12), cyclic(12), half_free}, {}).measure(ParticleColumns<double>{}).open);
}

TEST_CASE("void: none is zero, not open", "[void]") {
  const auto cloud = fill({-12, -12, 0}, {12, 12, 20}, 0.5, [](const auto&) { return false; });
  VoidComponent cavity(um, {cyclic(12), cyclic(12), half_free}, {0, 0, 10 * um});
  for (int call = 0; call < 2; ++call) {
    const VoidSize size = cavity.measure(cloud.columns());
    CHECK_FALSE(size.open);
    CHECK(size.volume == 0);
    CHECK(size.width == 0);
    CHECK(size.height == 0);
  }
}

TEST_CASE("void: impossible arguments are refused", "[void]") {
  const Extent axis = cyclic(20), bad{0, 20.5 * um, Extent::plane, Extent::plane};
  const Extent one_sided{0, 20 * um, Extent::periodic, Extent::plane};
  const Extent no_plane{0, 20 * um, Extent::free_, Extent::free_, true};
  CHECK_THROWS_AS(VoidComponent(0, {axis, axis, axis}, {}), InputError);
  for (const Extent& e : {bad, one_sided, no_plane})
    CHECK_THROWS_AS(VoidComponent(um, {axis, axis, e}, {}), InputError);
  std::vector<double> three(3), two(2);
  VoidComponent cavity(um, {axis, axis, axis}, {});
  CHECK_THROWS_AS(cavity.measure(ParticleColumns<double>{three, three, two, three}), InputError);
  three[1] = 1e9;
  VoidComponent free_cavity(um, {axis, axis, Extent{0, um}}, {});
  CHECK_THROWS_AS(free_cavity.measure(ParticleColumns<double>{two, two, std::span(three).first(2), two}),
                  NumericalError);
}
