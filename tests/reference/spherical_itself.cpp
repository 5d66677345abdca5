// The spherical reference solver by itself, against closed forms: a hollow sphere that breathes, Hill's static sphere,
// the plane wave at a large radius, the incompressible cavity, energy. None of it is the library's solver.
#include "reference/spherical.hpp"

#include <cmath>
#include <limits>

#include <mote/exact/dynamic_cavity.hpp>
#include <mote/exact/thick_sphere.hpp>

#include "catch.hpp"

namespace {

using reference::Ball, reference::Metal, reference::Shells;
constexpr double pi = std::numbers::pi, never = 1e300;
constexpr double shear = 69e9 / (2 * 1.33);
constexpr Metal aluminium{2700, 5350, 1.34, 1.96, shear, 120e6, 384e6};

/// Radial vibration of a hollow elastic sphere: u = d/dr [(A sin kr + B cos kr)/r], free at both radii.
struct Breathing {
  double inner = 5e-6, outer = 20e-6, fast, ratio;  // c_L; (4 G/rho) / c_L^2
  double k = 0, b = 0;                              // wave number, B/A

  explicit Breathing(const Metal& m) : fast(m.sound(1)), ratio(4 * m.shear / (m.rho0 * fast * fast)) {
    double low = 0.5 / outer, high = low;
    while (misfit(low) * misfit(high) > 0) high *= 1.01;
    for (int i = 0; i < 200; ++i) (misfit(low) * misfit(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    k = low;
    b = -pull(false, inner) / pull(true, inner);
  }
  double omega() const { return k * fast; }
  double shape(double r) const { return slope(false, r) + b * slope(true, r); }

 private:
  double wave(bool cosine, double r) const { return (cosine ? std::cos(k * r) : std::sin(k * r)) / r; }
  double slope(bool cosine, double r) const {
    return k * (cosine ? -std::sin(k * r) : std::cos(k * r)) / r - wave(cosine, r) / r;
  }
  // sigma_r/(rho c_L^2) = u' + (1 - ratio/2) 2 u/r with u' + 2 u/r = -k^2 wave
  double pull(bool cosine, double r) const { return -k * k * wave(cosine, r) - ratio * slope(cosine, r) / r; }
  double misfit(double wave_number) {
    k = wave_number;
    return (pull(false, inner) * pull(true, outer) - pull(true, inner) * pull(false, outer)) * inner * outer / (k * k);
  }
};

TEST_CASE("the spherical reference breathes as an elastic sphere does, to order 2") {
  Metal elastic = aluminium;
  elastic.yield = never;
  const Breathing mode{elastic};
  CHECK(mode.shape(mode.inner) / mode.shape(mode.outer) > 0);  // the first mode
  std::vector<double> errors;
  for (const int n : {25, 50, 100}) {
    Ball ball{.metal = elastic, .inner = mode.inner, .outer = mode.outer, .shells = n};
    const double speed = 1e-3 / mode.shape(mode.inner);  // strains of 1e-7: linear
    ball.velocity = [&](double r) { return speed * mode.shape(r); };
    Shells shells{ball};
    double worst = 0;
    for (int i = 1; i <= 16; ++i) {  // three periods and a bit
      shells.advance(1.3 * i / mode.omega());
      for (std::size_t j = 0; j <= shells.size(); ++j) {
        const double u = speed / mode.omega() * mode.shape(shells.start(j)) * std::sin(1.3 * i);
        worst = std::max(worst, std::abs(shells.radius(j) - shells.start(j) - u));
      }
    }
    errors.push_back(worst * mode.omega() / 1e-3);
  }
  INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
  CHECK(errors[2] < 1e-2);
  CHECK(std::log2(errors[0] / errors[1]) == Approx(2).margin(0.15));
  CHECK(std::log2(errors[1] / errors[2]) == Approx(2).margin(0.15));
}

TEST_CASE("the spherical reference comes to rest as Hill's sphere") {
  Metal ideal = aluminium;
  ideal.hardening = ideal.gamma0 = ideal.lambda = 0;
  // weak enough for small strains, by which the two differ
  ideal.yield = 1e6;
  const double bulk = ideal.bulk(), young = 9 * bulk * shear / (3 * bulk + shear);
  const double poisson = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  for (const double part : {0.5, 0.9, 1.6, 2.4}) {  // of 2 Y/3: elastic, elastic, plastic, plastic
    const double load = part * 2 * ideal.yield / 3;
    const mote::exact::ThickSphere hill{{.inner = 5e-6,
                                         .outer = 20e-6,
                                         .young = young,
                                         .poisson = poisson,
                                         .yield = ideal.yield,
                                         .pressure = 0.25 * load,
                                         .tension = 0.75 * load}};
    Ball ball{.metal = ideal, .inner = 5e-6, .outer = 20e-6, .shells = 60};
    // slow and smooth: an overshoot would leave plastic strain
    const auto ramp = [](double t) { return 0.5 - 0.5 * std::cos(pi * std::min(t / 300e-9, 1.0)); };
    ball.pressure = [&](double t) { return 0.25 * load * ramp(t); };
    ball.pull = [&](double t) { return 0.75 * load * ramp(t); };
    ball.damping = 1e8;
    Shells shells{ball};
    shells.advance(400e-9);
    INFO("part " << part << " plastic to " << hill.plastic_radius());
    CHECK(shells.radius() - 5e-6 == Approx(hill.displacement(5e-6)).epsilon(2e-3));
    CHECK(shells.radius(shells.size()) - 20e-6 == Approx(hill.displacement(20e-6)).epsilon(2e-3));
    for (std::size_t j = 0; j < shells.size(); j += 7) {
      const double r = 0.5 * (shells.start(j) + shells.start(j + 1));
      CHECK(shells.radial_stress(j) == Approx(hill.radial_stress(r)).margin(3e-3 * load));
      CHECK(1.5 * shells.deviator(j) == Approx(hill.radial_stress(r) - hill.hoop_stress(r)).margin(5e-3 * ideal.yield));
    }
  }
}

TEST_CASE("the spherical reference sends out plane waves at a large radius") {
  // the table of exact plane states in the design: launched off a wall at 100 m/s, and into it at 100 and 500 m/s
  struct State {
    double launch, stress, pressure, strain, density;
  };
  for (const State& exact : {State{100, 1488.260e6, -1405.586e6, 0.010444, 2651.685},
                             State{-100, -1525.221e6, 1442.571e6, 0.010352, 2748.815},
                             State{-500, -8175.682e6, 8081.439e6, 0.055638, 2943.011}}) {
    const double far = 0.1;  // m: 50 um are flat to 5e-4, of which the rounding of lengths takes 1e-10
    Ball ball{.metal = aluminium, .inner = far, .outer = far + 50e-6, .shells = 800, .held = true};
    ball.velocity = [&](double) { return exact.launch; };
    ball.linear_viscosity = 0.3, ball.quadratic_viscosity = 1.2;
    Shells shells{ball};
    shells.advance(6e-9);
    double stress = 0, pressure = 0, strain = 0, density = 0;
    const std::size_t from = 80, to = 380;  // 5 to 24 um; the slower front is at 32 um
    for (std::size_t j = from; j < to; ++j) {
      stress += shells.radial_stress(j) / double(to - from);
      pressure += shells.pressure(j) / double(to - from);
      strain += shells.plastic_strain(j) / double(to - from);
      density += aluminium.rho0 / shells.ratio(j) / double(to - from);
    }
    INFO("launch " << exact.launch);
    CHECK(stress == Approx(exact.stress).epsilon(2e-3));
    CHECK(pressure == Approx(exact.pressure).epsilon(2e-3));
    CHECK(strain == Approx(exact.strain).epsilon(5e-3));
    CHECK(density - 2700 == Approx(exact.density - 2700).epsilon(2e-3));
  }
}

TEST_CASE("the spherical reference becomes the incompressible cavity as its bulk modulus grows") {
  Metal stiff = aluminium;
  stiff.hardening = stiff.gamma0 = stiff.lambda = 0;
  const double speed = 250;
  std::vector<double> errors;
  for (const double times : {4.0, 8.0}) {
    stiff.c0 = times * 5350;
    Ball ball{.metal = stiff, .inner = 5e-6, .outer = 20e-6, .shells = 100};
    ball.velocity = [&](double r) { return speed * 25e-12 / (r * r); };
    Shells shells{ball};
    mote::exact::DynamicCavity cavity{{.radius = 5e-6,
                                       .outer = 20e-6,
                                       .density = stiff.rho0,
                                       .shear_modulus = stiff.shear,
                                       .yield = stiff.yield,
                                       .speed = speed}};
    double worst = 0;
    for (int i = 1; i <= 20; ++i) {  // it grows, stops and rebounds
      shells.advance(i * 0.5e-9);
      cavity.advance(i * 0.5e-9);
      worst = std::max(worst, std::abs(shells.radius() / cavity.radius() - 1));
    }
    CHECK(cavity.radius() > 1.1 * 5e-6);
    errors.push_back(worst);
  }
  INFO("errors " << errors[0] << " " << errors[1]);
  CHECK(errors[1] < 2e-3);
  CHECK(errors[1] < 0.6 * errors[0]);
}

/// The ball of spherical.cpp.
Ball torn(int shells, double courant) {
  Ball ball{.metal = aluminium, .inner = 5e-6, .outer = 20e-6, .shells = shells, .courant = courant};
  ball.velocity = [](double r) {
    const double t = std::clamp(r / 10e-6 - 1, 0.0, 1.0);
    return 400 * t * t * (3 - 2 * t);
  };
  return ball;
}

TEST_CASE("the spherical reference keeps energy, to order 2 in its steps") {
  std::vector<double> errors;
  for (const double courant : {0.4, 0.2, 0.1}) {
    Shells shells{torn(100, courant)};
    shells.advance(10e-9);
    const auto e = shells.energies();
    CHECK(e.plastic > 0.3 * e.work);
    errors.push_back(std::abs(e.missing()) / e.work);
  }
  INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
  CHECK(errors[0] < 1e-4);
  CHECK(errors[2] < 0.35 * errors[1]);
}

TEST_CASE("the spherical reference has converged on the ball that the library is compared with") {
  std::vector<double> radii[3];
  for (int level = 0; level < 3; ++level) {
    Shells shells{torn(100 << level, 0.5)};
    for (int i = 1; i <= 20; ++i) {
      shells.advance(i * 0.5e-9);
      radii[level].push_back(shells.radius());
    }
  }
  double coarse = 0, fine = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    coarse = std::max(coarse, std::abs(radii[0][i] / radii[1][i] - 1));
    fine = std::max(fine, std::abs(radii[1][i] / radii[2][i] - 1));
  }
  INFO("changes of the radius: " << coarse << " " << fine);
  CHECK(fine < 1e-4);  // a hundredth of what the comparison asks for
  CHECK(fine < 0.5 * coarse);
}

}  // namespace
