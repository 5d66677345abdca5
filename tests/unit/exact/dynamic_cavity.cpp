// The dynamic cavity against shells that are stepped one by one, Rayleigh's solution, its linear oscillation, the
// static sphere, the local balance of momentum and that of energy.
#include <mote/exact/dynamic_cavity.hpp>
#include <mote/exact/thick_sphere.hpp>
#include <numbers>

#include "catch.hpp"
#include "unit/exact/momentum.hpp"

namespace {

using namespace mote;
using exact::CavityStrength;
using exact::DynamicCavity;
constexpr double pi = std::numbers::pi, infinity = std::numeric_limits<double>::infinity();

/// Five-point Gauss on n equal panels.
template <class F>
double gauss(const F& f, double a, double b, int n) {
  const double node[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
  const double weight[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                           0.2369268850561891};
  double sum = 0;
  const double half = 0.5 * (b - a) / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 5; ++j) sum += half * weight[j] * f(a + (2 * i + 1 + node[j]) * half);
  return sum;
}

TEST_CASE("the dilogarithm is its integral") {
  using exact::detail::dilogarithm;
  const auto integrand = [](double t) { return t == 0 ? 1 : -std::log1p(-t) / t; };
  for (const double x : {-30.0, -1.0001, -1.0, -0.4, -1e-9, 0.0, 1e-12, 0.3, 0.5, 0.5001, 0.9})
    CHECK(dilogarithm(x) == Approx(gauss(integrand, 0, x, 200)).epsilon(2e-14).margin(1e-300));
  CHECK(dilogarithm(-1) == Approx(-pi * pi / 12).epsilon(1e-15));
  CHECK(dilogarithm(0.5) == Approx(pi * pi / 12 - std::log(2.0) * std::log(2.0) / 2).epsilon(1e-15));
  CHECK(dilogarithm(1 - 1e-12) == Approx(pi * pi / 6 - 1e-12 * (1 + 12 * std::log(10))).epsilon(1e-15));
}

/// The same medium as many shells, each with its own stress, stepped through the motion.
struct Shells {
  double g, y, inner, outer;
  std::vector<double> xi, stress;
  double w = 0;

  Shells(double g_, double y_, double inner_, double outer_, int n) : g(g_), y(y_), inner(inner_), outer(outer_) {
    for (int i = 0; i < n; ++i) xi.push_back(inner * std::pow(outer / inner, (i + 0.5) / n));
    stress.assign(xi.size(), 0);
  }
  void move(double to, int steps) {
    for (int k = 1; k <= steps; ++k) {
      const double next = w + (to - w) / (steps - k + 1);
      for (std::size_t i = 0; i < xi.size(); ++i)
        stress[i] = std::clamp(stress[i] + 2 * g * std::log((xi[i] + next) / (xi[i] + w)), -y, y);
      w = next;
    }
  }
  double resistance() const {  // (2/3) int s xi/(xi + w) d ln xi, mid-point rule
    double sum = 0;
    for (std::size_t i = 0; i < xi.size(); ++i) sum += stress[i] * xi[i] / (xi[i] + w);
    return 2.0 / 3 * sum * std::log(outer / inner) / double(xi.size());
  }
};

TEST_CASE("the resistance of the medium is that of shells stepped one by one") {
  // growing and dying swings, ones that repeat, pass and wipe out earlier turning points, and shrinking to half
  const std::vector<double> path{0.4, 0.1, 0.3, 0.15, 0.25, 0.2,  0.6, -0.3, 0.5, 0.1,
                                 0.5, 0.1, 3,   1,    2.9,  -0.5, 20,  19,   19.5};
  for (const double g : {1.0, 12.0, 300.0})
    for (const double outer : {1.5, 40.0, infinity}) {
      const double y = 1, inner = 0.9, far = std::isinf(outer) ? 1e7 : outer;
      CavityStrength strength{g, y, inner, outer};
      Shells shells{g, y, inner, far, 40000};
      for (const double w : path) {
        INFO("G " << g << " outer " << outer << " w " << w);
        for (const double part : {0.5, 1.0}) {  // also between turning points
          const double now = shells.w + part * (w - shells.w);
          shells.move(now, 2);
          // beyond the last shell it is elastic, 2 G w/xi
          const double tail = std::isinf(outer) ? 4.0 / 3 * g * now / far : 0;
          // mid-point rule over kinks of slope ~ 2 Y per e-fold: some step^2 = (16/40000)^2
          CHECK(strength.resistance(now) == Approx(shells.resistance() + tail).margin(1e-6 * y));
          for (std::size_t i = 0; i < shells.xi.size(); i += 1117)
            CHECK(strength.stress(shells.xi[i], now) == Approx(shells.stress[i]).margin(1e-9 * y));
        }
        strength.turn(w);
      }
      CHECK(strength.zones() <= 5);
    }
}

TEST_CASE("the resistance has its static limits") {
  const double g = 26e9, y = 120e6;
  const CavityStrength cavity{g, y, 1, infinity};
  // Hill's sphere with nu = 1/2 at small strain: w = 3 a^2 u
  for (const double part : {0.5, 1.0, 1.5, 2.5}) {
    const exact::ThickSphere sphere{
        {.inner = 1, .young = 3 * g, .poisson = 0.5, .yield = y, .pressure = part * 2 * y / 3}};
    const double w = 3 * sphere.displacement(1);
    INFO("part " << part << " w " << w);
    CHECK(cavity.resistance(w) == Approx(sphere.load()).epsilon(w));  // strains of w: relative error of that order
    CHECK(std::cbrt(cavity.yielding(w)) == Approx(sphere.plastic_radius()).epsilon(w));
  }
  // Y/G = 0.005: the limit's own next order is a quarter of that
  CHECK(cavity.resistance(1e12) == Approx(exact::cavitation_limit(3 * g, 0.5, y)).epsilon(y / g));
  CHECK(cavity.resistance(-0.01) == Approx(-cavity.resistance(0.01)).epsilon(0.01));
}

TEST_CASE("without strength the cavity is Rayleigh's") {
  // empty cavity in a liquid under pressure: a^3 a_t^2 = (2 P/(3 rho)) (A^3 - a^3)
  const double a0 = 2, rho = 3, p = 5;
  DynamicCavity cavity{
      {.radius = a0, .density = rho, .shear_modulus = 0, .tension = [](double) { return -5.0; }, .tolerance = 1e-12}};
  // time to come from A to a: with a = A s and s = 1 - z^2 the root at the start is gone
  const double to = 0.2;
  const auto integrand = [](double z) {
    const double s = 1 - z * z;
    return 2 * z / std::sqrt(1 / (s * s * s) - 1);
  };
  const double time = a0 * std::sqrt(3 * rho / (2 * p)) * gauss(integrand, 0, std::sqrt(1 - to), 100);
  cavity.advance(time);
  CHECK(cavity.radius() == Approx(to * a0).epsilon(1e-9));
  CHECK(cavity.speed() == Approx(-std::sqrt(2 * p / (3 * rho) * (1 / (to * to * to) - 1))).epsilon(1e-9));
  // Rayleigh's time of collapse, 0.914681 A sqrt(rho/P)
  try {
    cavity.advance(10 * time);
    CHECK(false);
  } catch (const NumericalError& e) {
    CHECK(std::string(e.what()).find("the cavity closes at") != std::string::npos);
  }
  CHECK(cavity.time() == Approx(0.914681 * a0 * std::sqrt(rho / p)).epsilon(1e-6));
  DynamicCavity grown{{.radius = a0, .density = rho, .shear_modulus = 0, .tension = [](double) { return 5.0; }}};
  grown.advance(20);
  CHECK(grown.radius() > 10 * a0);
  CHECK(grown.speed() == Approx(std::sqrt(2 * p / (3 * rho) * (1 - std::pow(a0 / grown.radius(), 3)))).epsilon(1e-9));
}

TEST_CASE("a gentle push makes the cavity oscillate at its linear frequency") {
  const double a = 2, rho = 3, g = 7;
  for (const double outer : {infinity, 5.0, 2.002}) {
    // omega^2 = 4 G (1 - A^3/B^3)/(rho A^2 (1 - A/B)): S = (4 G/A) u (1 - A^3/B^3)
    const double q = a / outer, omega = std::sqrt(4 * g * (1 + q + q * q) / rho) / a, speed = 1e-7 * omega * a;
    DynamicCavity cavity{{.radius = a, .outer = outer, .density = rho, .shear_modulus = g, .speed = speed}};
    for (const double turns : {0.3, 1.1, 10.4}) {
      INFO("outer " << outer << " turns " << turns);
      cavity.advance(2 * pi * turns / omega);
      // the next order is of the strain, 1e-7
      CHECK(cavity.radius() - a == Approx(1e-7 * a * std::sin(2 * pi * turns)).margin(1e-7 * 2e-6 * a));
      CHECK(cavity.speed() == Approx(speed * std::cos(2 * pi * turns)).margin(2e-6 * speed));
      CHECK(cavity.plastic_work() == 0);
    }
  }
}

/// int s^2/(6 G) dV, J, over the shells, in panels small enough for the kinks.
double elastic_energy(const DynamicCavity& c) {
  const double g = c.parameters().shear_modulus, a = c.radius();
  const double b = std::isinf(c.outer_radius()) ? 3000 * a : c.outer_radius();
  const auto density = [&](double z) {  // r = exp z
    const double r = std::exp(z), s = c.stress_difference(r);
    return s * s / (6 * g) * 4 * pi * r * r * r;
  };
  return gauss(density, std::log(a), std::log(b), 4000);
}

const DynamicCavity::Parameters ringing{.radius = 1, .density = 2, .shear_modulus = 5, .yield = 0.3, .speed = 1.2};
const DynamicCavity::Parameters shaken{
    .radius = 1, .outer = 2.5, .density = 2, .shear_modulus = 5, .yield = 0.3, .tension = [](double t) {
      return 0.45 * std::sin(2 * t);
    }};

TEST_CASE("the dynamic cavity balances energy through growth, rebound and yielding both ways") {
  for (const auto& p : {ringing, shaken}) {
    DynamicCavity cavity{p};
    const double start = cavity.kinetic_energy(), size = start > 0 ? start : 0.3;
    double widest = 1, narrowest = 1, before = 1, yields_inwards = 0;
    int turns = 0;
    for (int k = 1; k <= 60; ++k) {
      const double speed = cavity.speed();
      cavity.advance(0.1 * k);
      if (speed * cavity.speed() < 0) ++turns;
      widest = std::max(widest, cavity.radius());
      narrowest = std::min(narrowest, cavity.radius());
      if (cavity.plastic_radius() > cavity.radius() * (1 + 1e-9) && cavity.radius() < before) yields_inwards = 1;
      before = cavity.radius();
      const double sum = cavity.kinetic_energy() + elastic_energy(cavity) + cavity.plastic_work();
      INFO("t " << cavity.time() << " a " << cavity.radius());
      // the quadrature of the elastic energy over kinks leaves 1e-7, the infinite medium's tail (1/3000)^3
      CHECK(sum == Approx(start + cavity.tension_work()).margin(3e-7 * size));
    }
    CHECK(turns >= 2);
    CHECK(yields_inwards == 1);
    CHECK(cavity.plastic_work() > 0.3 * size);
    CHECK(widest - narrowest > 0.2);
  }
}

TEST_CASE("the dynamic cavity balances momentum at every place") {
  for (const auto& p : {ringing, shaken})
    for (const double t : {0.2, 1.1, 2.9, 5.3}) {
      DynamicCavity cavity{p};
      cavity.advance(t);
      const double a = cavity.radius(), b = cavity.outer_radius();
      INFO("outer " << p.outer << " t " << t << " a " << a);
      CHECK(cavity.radial_stress(a) == Approx(0).margin(1e-12));
      CHECK(cavity.radial_stress(b) == Approx(cavity.tension()).margin(1e-12));
      const double v = cavity.speed(), flow_rate = a * a * cavity.acceleration() + 2 * a * v * v;
      for (const double part : {0.2, 0.37, 0.7}) {
        const double r = a + part * ((std::isinf(b) ? 4 * a : b) - a), h = 1e-4;
        const auto speed = [&](double d) { return cavity.velocity(r + d); };
        const auto stress = [&](double d) { return cavity.radial_stress(r + d); };
        const double inertia = p.density * (flow_rate / (r * r) + cavity.velocity(r) * test::slope(speed, h));
        // noise 1e-16/1e-4; a kink of s within 3 h of r would spoil it, and none is
        CHECK(inertia == Approx(test::slope(stress, h) - 2 * cavity.stress_difference(r) / r).margin(1e-9));
      }
    }
}

TEST_CASE("the dynamic cavity keeps its tolerance, and does not care how it is stopped") {
  for (const auto& p : {ringing, shaken}) {
    auto sharp = p;
    sharp.tolerance = 1e-13;
    DynamicCavity reference{sharp};
    reference.advance(6);
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
      auto q = p;
      q.tolerance = tolerance;
      DynamicCavity once{q}, often{q};
      once.advance(6);
      for (int k = 1; k <= 97; ++k) often.advance(6.0 * k / 97);
      INFO("tolerance " << tolerance << " " << once.radius() - reference.radius());
      // errors of some hundred steps, each below the tolerance but of either sign
      const double work = reference.plastic_work();
      CHECK(std::abs(once.radius() - reference.radius()) < 3 * tolerance);
      CHECK(std::abs(often.radius() - reference.radius()) < 3 * tolerance);
      CHECK(std::abs(once.plastic_work() - work) < 50 * tolerance * work);
    }
  }
}

TEST_CASE("a cavity in aluminium grows without limit under more tension than Hill's, and comes to rest under less") {
  const double g = 25.94e9, y = 120e6, limit = exact::cavitation_limit(3 * g, 0.5, y), a = 5e-6;
  const auto pulled = [&](double part) {
    // the load grows over 200 periods of the cavity, so that it hardly overshoots
    const double rise = 400 * a * std::sqrt(2700 / g);
    DynamicCavity cavity{{.radius = a, .density = 2700, .shear_modulus = g, .yield = y, .tension = [=](double t) {
                            return part * limit * std::min(1.0, t / rise);
                          }}};
    cavity.advance(rise);
    cavity.advance(4 * rise);
    return cavity.radius() / a;
  };
  // at rest: S = (4 G/3) y (1 + y/4) + (2 Y/3) ln(c^3/a^3) with y = w/c^3 = 1 - exp(-Y/2G) at the elastic boundary
  const double strain = -std::expm1(-y / (2 * g)), elastic = 4 * g / 3 * strain * (1 + strain / 4);
  const double at_rest = std::cbrt(1 / (1 - strain * std::exp(1.5 / y * (0.8 * limit - elastic))));
  CHECK(at_rest > 1.09);
  const double found = pulled(0.8);
  CHECK(found > at_rest * (1 - 1e-4));
  CHECK(found < at_rest * 1.02);  // it overshoots by a little and rings elastically
  CHECK(pulled(1.1) > 10);
}

TEST_CASE("a cavity at rest stays at rest") {
  DynamicCavity cavity{{.radius = 1, .density = 1, .shear_modulus = 0}};
  cavity.advance(100);
  CHECK(cavity.radius() == 1);
  CHECK(cavity.speed() == 0);
  CHECK(cavity.plastic_radius() == 1);
}

TEST_CASE("the dynamic cavity refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  const DynamicCavity::Parameters good{.radius = 1, .density = 1, .shear_modulus = 1};
  using P = DynamicCavity::Parameters;
  const auto with = [&](double P::*member, double value) {
    auto p = good;
    p.*member = value;
    return DynamicCavity(p);
  };
  CHECK_THROWS_WITH(with(&P::radius, 0), Contains("0 m"));
  CHECK_THROWS_WITH(with(&P::outer, 0.5), Contains("0.5 m"));
  CHECK_THROWS_WITH(with(&P::density, -2), Contains("-2 kg/m^3"));
  CHECK_THROWS_WITH(with(&P::shear_modulus, -3), Contains("-3 Pa"));
  CHECK_THROWS_WITH(with(&P::yield, 0), Contains("0 Pa"));
  CHECK_THROWS_WITH(with(&P::tolerance, 1), Contains("tolerance is 1;"));
  CHECK_THROWS_AS(with(&P::speed, std::nan("")), InputError);
  DynamicCavity cavity{good};
  cavity.advance(1);
  CHECK_THROWS_WITH(cavity.advance(0.5), Contains("0.5 s"));
}

}  // namespace
