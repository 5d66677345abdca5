// Exact plane waves in one dimension: states, front speeds and profiles of the schemes of both presets and of others.
//
// The bars of the project: P and sigma behind the plastic front within 0.5%, front speeds within 1%, h = 0.25 um.
// Measured (docs/verification.md): quadratic AffineFlip meets them all but behind the strong shock, where it rings into
// the precursor. Quadratic APIC keeps the speeds. Its stresses are off by up to 0.7%: without a
// viscosity the waves ring, the metal unloads elastically in each swing, and the mean deviator falls short of the
// yield surface. With a viscous pressure all bars hold, and also with quadratic FLIP that is a third PIC (blends from
// 0.62 to 0.65 do; 0.9 rings like APIC, 0.5 smears the precursor of the strong shock by 1.5%). Linear FLIP adds
// cell-crossing noise that does not fall with h, most of all in tension. Where a bar does not hold the bounds below are
// the measured errors, rounded up.
#include "convergence/bar.hpp"

#include <algorithm>
#include <cstdio>

#include "catch.hpp"

namespace {

using bar::Errors;

constexpr double launches[] = {-500, -100, 100, 400};

struct Bounds {
  double stress, pressure, elastic_speed, plastic_speed;
};
void check(const Errors& e, const Bounds& b) {
  CHECK(std::abs(e.stress) < b.stress);
  CHECK(std::abs(e.pressure) < b.pressure);
  CHECK(std::abs(e.elastic_speed) < b.elastic_speed);
  CHECK(std::abs(e.plastic_speed) < b.plastic_speed);
}

/// Order of the profile's L1 error from h = 1 um to 0.25 um.
template <class Scheme>
double order(const Scheme& scheme, double launch) {
  const double coarse = bar::run(scheme, 1e-6, launch).profile, middle = bar::run(scheme, 0.5e-6, launch).profile,
               fine = bar::run(scheme, 0.25e-6, launch).profile;
  CHECK(middle < coarse);
  CHECK(fine < middle);
  return 0.5 * std::log2(coarse / fine);
}

TEST_CASE("plane waves, quadratic AffineFlip USL: all bars but behind the strong shock") {
  for (const double launch : {-100.0, 100.0, 400.0}) {
    INFO("launch " << launch);
    check(bar::run(bar::QuadraticAffineFlipUsl{}, 0.25e-6, launch), {0.005, 0.005, 0.01, 0.01});
  }
  check(bar::run(bar::QuadraticAffineFlipUsl{}, 0.25e-6, -500), {0.005, 0.006, 0.07, 0.01});
}

TEST_CASE("plane waves, quadratic APIC USL: front speeds within 1%, stresses within 0.75%") {
  for (const double launch : launches) {
    INFO("launch " << launch);
    check(bar::run(bar::QuadraticApicUsl{}, 0.25e-6, launch), {0.0075, 0.0075, 0.01, 0.01});
  }
}

TEST_CASE("plane waves, quadratic FLIP with a third of PIC: stresses within 0.5%, front speeds within 1%") {
  for (const double launch : launches) {
    INFO("launch " << launch);
    check(bar::run(bar::BlendedQuadraticFlipUsl{}, 0.25e-6, launch), {0.005, 0.005, 0.01, 0.01});
    CHECK(order(bar::BlendedQuadraticFlipUsl{}, launch) > 0.4);
  }
}

TEST_CASE("plane waves, quadratic APIC USL with viscosity: stresses within 0.5%, front speeds within 1%") {
  for (const double launch : launches) {
    INFO("launch " << launch);
    const Errors e = bar::run(bar::DampedQuadraticApicUsl{}, 0.25e-6, launch);
    const Errors ringing = bar::run(bar::QuadraticApicUsl{}, 0.25e-6, launch);
    check(e, {0.005, 0.005, 0.01, 0.01});
    CHECK(std::abs(e.plastic_strain) < 0.012);
    // what ringing does: elastic unloading, and plastic strain to and fro
    CHECK(ringing.deviator < std::min(e.deviator, -0.1));
    CHECK(ringing.plastic_strain > e.plastic_strain);
  }
}

TEST_CASE("plane waves, linear FLIP MUSL: elastic front within 1%, the rest within what cell-crossing noise leaves") {
  for (const double launch : {-500.0, -100.0}) {
    INFO("launch " << launch);
    check(bar::run(bar::LinearFlipMusl{}, 0.25e-6, launch), {0.02, 0.01, 0.01, 0.02});
  }
  // in tension the plastic front itself is lost in the noise
  for (const double launch : {100.0, 400.0}) {
    INFO("launch " << launch);
    const Errors e = bar::run(bar::LinearFlipMusl{}, 0.25e-6, launch);
    CHECK(std::abs(e.stress) < 0.07);
    CHECK(std::abs(e.pressure) < 0.05);
    CHECK(std::abs(e.elastic_speed) < 0.01);
  }
}

// In L1 a dissipative scheme of order p carries a jump of a linear wave with the order p/(p + 1), so 1/2 for p = 1. All
// waves here but the strong shock are nearly linear; the shock steepens itself and comes nearer to order 1.
TEST_CASE("plane waves: the velocity profile's error falls with h") {
  for (const double launch : launches) {
    INFO("launch " << launch);
    CHECK(order(bar::QuadraticApicUsl{}, launch) > (launch < -400 ? 0.75 : 0.5));
    CHECK(order(bar::QuadraticAffineFlipUsl{}, launch) > (launch < -400 ? 0.7 : 0.5));
  }
  // linear FLIP: in compression only
  for (const double launch : {-500.0, -100.0}) CHECK(order(bar::LinearFlipMusl{}, launch) > 0.35);
}

template <class Scheme>
void print_rows(const Scheme& scheme) {
  for (const double launch : launches)
    for (const double h : {1e-6, 0.5e-6, 0.25e-6}) {
      const Errors e = bar::run(scheme, h, launch);
      std::printf("| %s | %g | %g | %+.2f%% | %+.2f%% | %+.2f%% | %+.2f%% | %+.0f%% | %+.1f%% | %.4f |\n", scheme.name,
                  launch, h * 1e6, 100 * e.stress, 100 * e.pressure, 100 * e.elastic_speed, 100 * e.plastic_speed,
                  100 * e.deviator, 100 * e.plastic_strain, e.profile);
    }
}

// mote_studies "[table]" prints the table of docs/verification.md
TEST_CASE("plane waves: table of errors", "[.][table]") {
  std::printf("| scheme | launch, m/s | h, um | sigma | P | elastic front | plastic front | s | eps_p | L1 of v |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  print_rows(bar::LinearFlipMusl{});
  print_rows(bar::QuadraticAffineFlipUsl{});
  print_rows(bar::QuadraticApicUsl{});
  print_rows(bar::BlendedQuadraticFlipUsl{});
  print_rows(bar::DampedQuadraticApicUsl{});
}

}  // namespace
