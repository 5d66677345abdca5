/// \file
/// What the default survives in two dimensions: spin and oblique flight.
#include "plane.hpp"

#include "catch.hpp"

using namespace stability;

TEST_CASE("a disc spins five turns, and loses less than with FLIP", "[stability][spin]") {
  const auto m = spin<Default>(5), flip = spin<Scheme<shape::QuadraticBSpline, transfer::Flip, update::Usl>>(5);
  CAPTURE(m.kinetic, m.angular_momentum, m.size, m.turns, flip.kinetic, flip.angular_momentum);
  CHECK_FALSE(m.end.failed());
  CHECK(m.kinetic < 1.001);
  CHECK(m.kinetic > flip.kinetic);
  CHECK(m.angular_momentum > flip.angular_momentum);
}

TEST_CASE("a disc that spins five turns keeps its energy and angular momentum", "[stability][spin]") {
  const auto m = spin<Default>(5);
  CHECK(m.kinetic == Approx(1).epsilon(0.01));
  CHECK(m.angular_momentum == Approx(1).epsilon(0.005));
}

TEST_CASE("a disc that spins five turns keeps them with MUSL, too", "[stability][spin]") {
  const auto m = spin<Scheme<shape::QuadraticBSpline, transfer::AffineFlip, update::Musl>>(5);
  CAPTURE(m.kinetic, m.angular_momentum, m.turns);
  CHECK(m.kinetic == Approx(1).epsilon(0.01));
  CHECK(m.angular_momentum == Approx(1).epsilon(0.005));
}

TEST_CASE("a disc spins 100 turns", "[stability][spin][slow]") {
  const auto m = spin<Default>(100);
  CAPTURE(m.kinetic, m.angular_momentum, m.size, m.turns);
  CHECK_FALSE(m.end.failed());
  CHECK(m.kinetic <= 1.001);
  CHECK(m.kinetic > 0.95);
}

TEST_CASE("a jittered square flies obliquely over many cells and stays as it was", "[stability][flight]") {
  const auto m = fly<Default>(100);
  CHECK_FALSE(m.end.failed());
  CHECK(m.kinetic == Approx(1).epsilon(1e-12));
  CHECK(m.size == Approx(1).epsilon(1e-9));
  CHECK(m.stress < 1e3);  // Pa
}

TEST_CASE("a jittered square flies obliquely over 1000 cells", "[stability][flight][slow]") {
  const auto m = fly<Default>(1000);
  CHECK_FALSE(m.end.failed());
  CHECK(m.kinetic == Approx(1).epsilon(1e-11));
  CHECK(m.stress < 1e4);
}
