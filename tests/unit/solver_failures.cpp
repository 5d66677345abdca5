/// \file
/// How a solver fails: the kind of error, what its message names, and what is left.
#include "catch.hpp"
#include "passes/schemes.hpp"

namespace {

using namespace schemes;
using Catch::Matchers::ContainsSubstring;

/// A block of aluminium on a wall at z = `wall` cells, 512 particles.
template <class Executor = execution::Serial, class Step = timestep::Cfl, class... More>
auto on_a_wall(int wall, const Executor& executor = {}, const Step& step = {}, const More&... more) {
  using S = decltype(Solver{grid::Cartesian<3>{.spacing = h}, shape::QuadraticBSpline{}, transfer::Apic{}, step,
                            executor, boundary::RigidWall{.side = side::z_min, .at = wall * h}, aluminium, more...});
  auto solver =
      std::make_unique<S>(grid::Cartesian<3>{.spacing = h}, shape::QuadraticBSpline{}, transfer::Apic{}, step, executor,
                          boundary::RigidWall{.side = side::z_min, .at = wall * h}, aluminium, more...);
  solver->fill(geometry::Box<3>{.lower = {0, 0, wall * h}, .upper = {4 * h, 4 * h, (wall + 4) * h}}, aluminium, {});
  solver->refresh();
  return solver;
}

template <class F>
std::string message(F f) {
  try {
    f();
  } catch (const NumericalError& error) {
    return error.what();
  }
  return "no NumericalError";
}

/// The words that name particle p.
template <class P>
std::string name(const P& particles, std::size_t p) {
  const auto x = particles.template get<field::Position>(p);
  return text("particle ", particles.template column<field::Id>()[p], " at (", x[0], ", ", x[1], ", ", x[2], ") m");
}

}  // namespace

TEST_CASE("a step without particles is a usage error", "[solver][failure]") {
  Solver solver{grid::Cartesian<1>{.spacing = h}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, aluminium};
  CHECK_THROWS_AS(solver.step(), UsageError);
  CHECK_THROWS_AS(solver.run({.until = 1}), UsageError);
}

TEST_CASE("a velocity that is not a number is found and named", "[solver][failure]") {
  const auto solver = on_a_wall(0);
  auto& particles = solver->particles();
  particles.column<field::Velocity>(1)[300] = std::numeric_limits<double>::quiet_NaN();
  const std::string expected = name(particles, 300) + ", in step 0, has the velocity (0, nan, 0) m/s";
  CHECK_THAT(message([&] { solver->refresh(); }), ContainsSubstring(expected));
  CHECK_THROWS_AS(solver->step(), UsageError);
}

TEST_CASE("a particle beyond a wall is found and named, wherever the wall lies in its block", "[solver][failure]") {
  const int wall = GENERATE(0, 1, 2, 3);
  const auto solver = on_a_wall(wall);
  auto& particles = solver->particles();
  particles.column<field::Position>(2)[7] = (wall - 0.7) * h;
  const std::string expected = name(particles, 7) + ", in step 0, has left the domain through a wall";
  CHECK_THAT(message([&] { solver->refresh(); }), ContainsSubstring(expected));
}

TEST_CASE("compression beyond the equation of state names V/V0", "[solver][failure]") {
  const auto solver = on_a_wall(0);
  solver->particles().column<field::VolumeRatio>()[20] = 0.21;
  const std::string expected = name(solver->particles(), 20) + ", in step 0, has V/V0 = 0.21";
  CHECK_THAT(message([&] { solver->refresh(); }), ContainsSubstring(expected));
}

TEST_CASE("a step that compresses too far fails, its columns stay readable, and there is no further step",
          "[solver][failure]") {
  const auto solver = on_a_wall(0, execution::Threads(2), timestep::Fixed{.dt = 1e-11});
  auto& particles = solver->particles();
  for (int a = 0; a < 3; ++a)
    for (std::size_t p = 0; p < solver->size(); ++p)
      particles.column<field::Velocity>(a)[p] = -0.6 / 1e-11 * (particles.column<field::Position>(a)[p] - 2 * h);
  solver->refresh();
  CHECK_THAT(message([&] { solver->step(); }), ContainsSubstring("V/V0"));
  CHECK(particles.size() == 512);
  CHECK(particles.column<field::VolumeRatio>().size() == 512);
  CHECK(*std::min_element(particles.column<field::VolumeRatio>().begin(),
                          particles.column<field::VolumeRatio>().end()) < 0.25);
  CHECK_THROWS_AS(solver->step(), UsageError);
}

TEST_CASE("what a worker throws arrives, and there is no further step", "[solver][failure]") {
  const int threads = GENERATE(1, 3);
  const load::BodyForce<3> trap{[](const Vec<double, 3>&, double time) -> Vec<double, 3> {
    if (time > 0) throw std::range_error("trapped");
    return {};
  }};
  const auto solver = on_a_wall(0, execution::Threads(threads), timestep::Cfl{}, trap);
  solver->step();
  CHECK_THROWS_WITH(solver->step(), "trapped");
  CHECK(solver->particles().size() == 512);
  CHECK_THROWS_AS(solver->step(), UsageError);
}

TEST_CASE("a collapsed time step is found and its cause named", "[solver][failure]") {
  const auto solver = on_a_wall(0);
  solver->step();
  solver->particles().column<field::Velocity>(0)[99] = 1e12;
  solver->refresh();
  const std::string said = message([&] { solver->step(); });
  CHECK_THAT(said, ContainsSubstring("time step has collapsed"));
  CHECK_THAT(said, ContainsSubstring("moves at 1e+12 m/s"));
}
