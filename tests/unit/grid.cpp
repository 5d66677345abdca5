/// \file
/// Blocks and their index, and the edges of the domain.
#include <mote/boundary/periodic.hpp>
#include <mote/boundary/rigid_wall.hpp>
#include <mote/boundary/symmetry.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/grid/cartesian.hpp>
#include <mote/grid/domain.hpp>

#include "catch.hpp"

namespace {

using namespace mote;
using Catch::Matchers::ContainsSubstring;

template <class... Boundaries>
grid::Domain<3> domain(const Boundaries&... boundaries) {
  return {1e-6, Vec<double, 3>{}, std::tuple(boundaries...)};
}

template <class... Boundaries>
std::string refusal(const Boundaries&... boundaries) {
  try {
    domain(boundaries...);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const boundary::RigidWall floor_at_0{.side = side::z_min, .at = 0};

}  // namespace

TEST_CASE("the block index counts new blocks up from zero and finds them", "[grid]") {
  grid::BlockIndex<3> index;
  CHECK(index.find({1, 2, 3}) == index.none);
  CHECK(index.insert({1, 2, 3}) == 0);
  CHECK(index.insert({-1, 2, 3}) == 1);
  CHECK(index.insert({1, 2, 3}) == 0);
  CHECK(index.find({-1, 2, 3}) == 1);
  CHECK(index.size() == 2);
  CHECK(index[1] == IVec<3>{-1, 2, 3});
}

TEST_CASE("the block index keeps thousands of blocks apart", "[grid]") {
  grid::BlockIndex<3> index;
  std::uint32_t next = 0;
  for (int round = 0; round < 2; ++round, next = 0)
    for (int i = -10; i < 10; ++i)
      for (int j = -10; j < 10; ++j)
        for (int k = -10; k < 10; ++k) REQUIRE(index.insert({i, j, k}) == next++);
  CHECK(index.size() == 8000);
}

TEST_CASE("the block index reaches to its limits", "[grid]") {
  constexpr auto far = grid::BlockIndex<3>::limit;
  grid::BlockIndex<3> index;
  CHECK(index.insert({far - 1, far - 1, far - 1}) == 0);
  CHECK(index.insert({-far, -far, -far}) == 1);
  CHECK(index.insert({far - 1, -far, 0}) == 2);
  CHECK(index.find({far - 1, far - 1, far - 1}) == 0);
}

TEST_CASE("a cleared block index is empty and counts anew", "[grid]") {
  grid::BlockIndex<2> index;
  for (int i = 0; i < 100; ++i) index.insert({i, -i});
  index.clear();
  CHECK(index.size() == 0);
  CHECK(index.find({5, -5}) == index.none);
  CHECK(index.insert({5, -5}) == 0);
}

TEST_CASE("nodes with negative indices lie in blocks as the others do", "[grid]") {
  CHECK(grid::block_of(3) == 0);
  CHECK(grid::block_of(-1) == -1);
  CHECK(grid::block_of(-4) == -1);
  CHECK(grid::block_of(-5) == -2);
  CHECK(grid::within_block(-1) == 3);
  CHECK(grid::within_block(-4) == 0);
}

TEST_CASE("a node is found by its coordinates, and they by its number", "[grid]") {
  grid::Blocks<double, 3> blocks;
  blocks.index.insert({0, 0, 0});
  blocks.index.insert({-1, 2, 0});
  const IVec<3> node{-3, 9, 2};
  CHECK(blocks.find(node) == 64 + (1 * 4 + 1) * 4 + 2);
  CHECK(blocks.coordinates(blocks.find(node)) == node);
  CHECK(blocks.find({4, 0, 0}) == blocks.none);
}

TEST_CASE("the remapped velocity takes memory only when asked for", "[grid]") {
  grid::Blocks<double, 2> blocks;
  blocks.index.insert({0, 0});
  blocks.allocate(false, false, false);
  CHECK(blocks.mass.size() == 16);
  CHECK(blocks.velocity.size() == 64);
  CHECK(blocks.remapped.empty());
  blocks.allocate(true, false, false);
  CHECK(blocks.remapped.size() == 64);
  CHECK(blocks.sharp.empty());
  CHECK(blocks.residual.empty());
  blocks.allocate(false, true, true);
  CHECK(blocks.sharp.size() == 64);
  CHECK(blocks.residual.size() == 64);
}

TEST_CASE("a grid refuses a spacing that is not positive", "[grid]") {
  CHECK_THROWS_AS((grid::Cartesian<2>{.spacing = 0}.validate()), InputError);
  CHECK_THROWS_AS((grid::Cartesian<2>{.spacing = -1}.validate()), InputError);
}

TEST_CASE("node indices wrap into the period, negative ones too", "[grid]") {
  const auto d = domain(boundary::Periodic{.axis = axis::x, .from = -2e-6, .to = 5e-6});
  CHECK(d.wrapped(0, -2) == -2);
  CHECK(d.wrapped(0, 4) == 4);
  CHECK(d.wrapped(0, 5) == -2);
  CHECK(d.wrapped(0, -3) == 4);
  CHECK(d.wrapped(0, -2 - 7 * 5 - 1) == 4);
  CHECK(d.wrapped(1, 100) == 100);  // another axis
}

TEST_CASE("positions wrap into the period", "[grid]") {
  const auto d = domain(boundary::Periodic{.axis = axis::y, .from = -2e-6, .to = 5e-6});
  CHECK(d.wrapped_position(1, 6e-6) == Approx(-1e-6));
  CHECK(d.wrapped_position(1, -2.5e-6) == Approx(4.5e-6));
  CHECK(d.wrapped_position(1, 5e-6) == Approx(-2e-6));
  CHECK(d.wrapped_position(1, 3e-6) == 3e-6);
  const double just_below = std::nextafter(-2e-6, -1.0);
  CHECK(d.wrapped_position(1, just_below) < 5e-6);
  CHECK(d.wrapped_position(0, 6e-6) == 6e-6);
  CHECK(d.period(1) == Approx(7e-6));
  CHECK(d.period(0) == 0);
}

TEST_CASE("a domain knows where its planes are and what they flip", "[grid]") {
  const auto d = domain(boundary::Symmetry{.side = side::x_max, .at = 3e-6}, floor_at_0);
  REQUIRE(d.plane(0, 1));
  CHECK(d.plane(0, 1)->node == 3);
  CHECK(d.plane(0, 1)->odd == std::array{true, false, false});
  CHECK(d.plane(0, 1)->body_beyond);
  REQUIRE(d.plane(2, 0));
  CHECK(d.plane(2, 0)->odd == std::array{true, true, true});
  CHECK(!d.plane(2, 0)->body_beyond);
  CHECK(d.plane(2, 0)->part == 1);
  CHECK(!d.plane(0, 0));
}

TEST_CASE("a boundary that is empty is none, and has no number", "[grid]") {
  const boundary::Symmetry mirror{.side = side::x_min, .at = 2e-6};
  const boundary::Periodic around{.axis = axis::y, .from = 0, .to = 3e-6};
  const auto d = domain(std::optional<boundary::Symmetry>{}, std::optional(around), std::optional(mirror),
                        std::optional<boundary::Periodic>{}, boundary::RigidWall{.side = side::z_min, .at = 0});
  REQUIRE(d.plane(0, 0));
  CHECK(d.plane(0, 0)->node == 2);
  CHECK(d.plane(0, 0)->part == 1);
  CHECK(d.periodic(1));
  CHECK(!d.periodic(0));
  CHECK(!d.plane(0, 1));
  REQUIRE(d.plane(2, 0));
  CHECK(d.plane(2, 0)->part == 2);
}

TEST_CASE("a domain contains what lies between its planes and in its periods", "[grid]") {
  const auto d = domain(floor_at_0, boundary::RigidWall{.side = side::z_max, .at = 2e-6},
                        boundary::Periodic{.axis = axis::x, .from = 0, .to = 4e-6});
  CHECK(d.contains(2, 0));
  CHECK(d.contains(2, 2e-6));
  CHECK(!d.contains(2, -1e-8));
  CHECK(!d.contains(2, 2.01e-6));
  CHECK(!d.contains(0, 4.1e-6));
  CHECK(d.contains(1, 1));
}

TEST_CASE("planes count their nodes from the grid's origin", "[grid]") {
  const grid::Domain<1> d(0.5, {0.25}, std::tuple(boundary::Symmetry{.side = side::x_min, .at = 1.25}));
  CHECK(d.plane(0, 0)->node == 2);
}

TEST_CASE("a plane off the nodes is refused, and the nearest node named", "[grid]") {
  CHECK_THAT(refusal(boundary::RigidWall{.side = side::z_min, .at = 1.4e-6}),
             ContainsSubstring("the plane z_min lies at 1.4e-06 m; it must lie on a grid node, e.g. at 1e-06 m"));
  CHECK_THAT(refusal(boundary::Symmetry{.side = side::x_max, .at = 0.5e-6}), ContainsSubstring("x_max"));
  CHECK_THAT(refusal(boundary::Periodic{.axis = axis::y, .from = 0, .to = 2.2e-6}), ContainsSubstring("grid node"));
  CHECK_THAT(refusal(boundary::RigidWall{.side = side::z_min, .at = std::nan("")}), ContainsSubstring("grid node"));
}

TEST_CASE("boundaries that contradict each other are refused", "[grid]") {
  const boundary::Periodic along_z{.axis = axis::z, .from = 0, .to = 4e-6};
  CHECK_THAT(refusal(along_z, floor_at_0), ContainsSubstring("axis z is periodic and has a plane too"));
  CHECK_THAT(refusal(floor_at_0, floor_at_0), ContainsSubstring("side z_min has two boundaries"));
  CHECK_THAT(refusal(along_z, along_z), ContainsSubstring("axis z has two periodic boundaries"));
  CHECK_THAT(refusal(floor_at_0, boundary::RigidWall{.side = side::z_max, .at = 0}),
             ContainsSubstring("leave no room between them"));
  CHECK_THAT(refusal(boundary::Periodic{.axis = axis::x, .from = 1e-6, .to = 1e-6}),
             ContainsSubstring("`to` must lie above `from`"));
}

TEST_CASE("a boundary along an axis that the grid lacks is refused", "[grid]") {
  CHECK_THROWS_AS((grid::Domain<2>(1, {}, std::tuple(floor_at_0))), InputError);
  CHECK_THAT(refusal(boundary::Periodic{.axis = 3, .from = 0, .to = 1e-6}), ContainsSubstring("axis 3"));
}
