/// \file
/// What the default survives in three dimensions; all of it slow.
#include "scene.hpp"

#include "catch.hpp"

using namespace stability;

namespace {

struct Seen {
  End end;
  double low = 0, high = 0;
  int broken = 0;
  Extremes last;
};

Seen see(const Block& block, double until) {
  const auto solver = make_block<Default>(block);
  Seen seen;
  int n = 0;
  seen.end = march(*solver, until, [&] {
    if (n++ % 10 == 0) {
      seen.last = extremes(*solver, block.per_axis);
      seen.low = std::min(seen.low, seen.last.low.pressure), seen.high = std::max(seen.high, seen.last.high.pressure);
      seen.broken += seen.last.broken;
    }
    return seen.broken == 0;
  });
  seen.last = extremes(*solver, block.per_axis);
  seen.broken += seen.last.broken;
  return seen;
}

}  // namespace

TEST_CASE("no noise in the pressures of the paper's scene at 7.2 ns: none above 0.3 GPa or below -1.5 GPa",
          "[stability][scene][slow]") {
  const auto seen = see({.speed = 100}, 7.2e-9);
  CAPTURE(seen.last.low.pressure, seen.last.high.pressure, seen.last.high.at[2]);
  CHECK_FALSE(seen.end.failed());
  CHECK(seen.broken == 0);
  CHECK(seen.last.above == 0);
  CHECK(seen.last.below == 0);
}

TEST_CASE("the paper's scene at 1000 m/s to 12 ns", "[stability][scene][slow]") {
  const auto seen = see({.speed = 1000}, 12e-9);
  CAPTURE(seen.end.error, seen.low, seen.high);
  CHECK_FALSE(seen.end.failed());
  CHECK(seen.broken == 0);
}

TEST_CASE("launched at up to 5 km/s, off the wall and into it", "[stability][scene][slow]") {
  const double speed = GENERATE(2000.0, 5000.0, -1000.0, -5000.0);
  const auto seen = see({.half_width = 10, .height = 24, .radius = 3, .centre = 8, .speed = speed}, 2e-9);
  CAPTURE(speed, seen.end.error, seen.low, seen.high);
  CHECK_FALSE(seen.end.failed());
  CHECK(seen.broken == 0);
}

TEST_CASE("cavities that touch the wall, lie under the surface, and merge", "[stability][scene][slow]") {
  Block b{.half_width = 10, .height = 24, .radius = 3};
  SECTION("touches the wall") { b.centre = 3; }
  SECTION("half a cell from the wall") { b.centre = 3.5; }
  SECTION("half a cell from the surface") { b.centre = 20.5; }
  SECTION("two, a cell apart") { b.centre = 8, b.second_centre = 15, b.speed = 400; }
  const auto seen = see(b, 8e-9);
  CAPTURE(seen.end.error, seen.low, seen.high);
  CHECK_FALSE(seen.end.failed());
  CHECK(seen.broken == 0);
}
