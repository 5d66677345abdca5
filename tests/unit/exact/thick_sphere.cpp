// The thick sphere against equilibrium, Hooke's law and the yield condition by differences, and Hill's limit of growth
// against the integrated velocity field.
#include <mote/exact/thick_sphere.hpp>

#include "catch.hpp"
#include "unit/exact/momentum.hpp"

namespace {

using namespace mote;
using exact::cavitation_limit;
using exact::ThickSphere;

constexpr double young = 69e9, poisson = 0.33, yield = 120e6;
Approx near(double value, double relative, double size) {
  return Approx(value).epsilon(relative).margin(relative * size);
}

/// The equations at r; `e` is the half width of the differences' reach, within one zone.
void check_at(const ThickSphere& s, double r, double e) {
  INFO("r " << r);
  const auto& p = s.parameters();
  const double h = e / 3, size = s.load() + std::abs(p.tension);
  const auto radial = [&](double d) { return s.radial_stress(r + d); };
  const auto outward = [&](double d) { return s.displacement(r + d); };
  const double sr = s.radial_stress(r), st = s.hoop_stress(r), u = s.displacement(r);
  // differences of sixth order over h = 0.003 r: truncation some 1e-13, noise 1e-16/0.003 of the stress
  CHECK(test::slope(radial, h) == near(2 * (st - sr) / r, 1e-10, size / r));
  const double er = test::slope(outward, h), et = u / r;
  const double strain = size / p.young;
  CHECK(er + 2 * et == near((1 - 2 * p.poisson) / p.young * (sr + 2 * st), 1e-9, strain));
  if (s.plastic(r)) {
    CHECK(st - sr == near(p.yield, 1e-12, p.yield));
    CHECK(et > ((1 - p.poisson) * st - p.poisson * sr) / p.young);  // plastic hoop strain is positive
  } else {
    CHECK(et == near(((1 - p.poisson) * st - p.poisson * sr) / p.young, 1e-12, strain));
    CHECK(st - sr <= p.yield * (1 + 1e-12));
  }
}

void check(const ThickSphere& s) {
  const auto& p = s.parameters();
  const double c = s.plastic_radius(), b = std::isinf(p.outer) ? 10 * c : p.outer;
  INFO("load " << s.load() << " c " << c);
  CHECK(s.radial_stress(p.inner) == near(-p.pressure, 1e-12, s.load()));
  CHECK(s.radial_stress(p.outer) == near(p.tension, 1e-12, s.load()));
  for (const double part : {0.05, 0.4, 0.9}) {
    if (c > p.inner) check_at(s, p.inner + part * (c - p.inner), 0.01 * (c - p.inner));
    if (b > c) check_at(s, c + part * (b - c), 0.01 * std::min(b - c, c));
  }
  if (c > p.inner && c < b) {  // continuous at c: displacements and both stresses
    const double in = c * (1 - 1e-12);
    CHECK(s.plastic(in));
    CHECK_FALSE(s.plastic(c));
    CHECK(s.displacement(in) == near(s.displacement(c), 1e-10, 0));
    CHECK(s.radial_stress(in) == near(s.radial_stress(c), 1e-10, s.load()));
    CHECK(s.hoop_stress(in) == near(s.hoop_stress(c), 1e-10, s.load()));
  }
}

TEST_CASE("thick spheres are in equilibrium, elastic outside and yielding inside") {
  for (const double outer : {1.2, 3.0, 20.0, std::numeric_limits<double>::infinity()}) {
    const ThickSphere empty{{.inner = 1, .outer = outer, .young = young, .poisson = poisson, .yield = yield}};
    CHECK(empty.plastic_radius() == 1);
    for (const double part : {0.3, 0.99, 1.3, 1.6, 2.0, 3.0})
      for (const double share : {0.0, 0.4, 1.0}) {
        const double q = std::min(part * empty.yield_load(), empty.limit_load());
        INFO("outer " << outer << " part " << part << " share " << share);
        check(ThickSphere{{.inner = 1,
                           .outer = outer,
                           .young = young,
                           .poisson = poisson,
                           .yield = yield,
                           .pressure = share * q,
                           .tension = (1 - share) * q}});
      }
  }
  check(ThickSphere{{.inner = 2, .outer = 3, .young = 5, .poisson = 0.5, .pressure = 0.1}});  // never yields
  check(
      ThickSphere{{.inner = 2, .outer = 3, .young = 5, .poisson = 0, .yield = 0.1, .pressure = 0.05, .tension = 0.02}});
}

TEST_CASE("thick spheres yield and collapse at the published loads") {
  const ThickSphere cavity{{.inner = 5e-6, .young = young, .poisson = poisson, .yield = yield}};
  CHECK(cavity.yield_load() == Approx(2 * yield / 3).epsilon(1e-15));
  CHECK(cavity.limit_load() == Approx(532.5e6).epsilon(1e-4));
  const ThickSphere shell{{.inner = 1, .outer = 2, .young = young, .poisson = poisson, .yield = yield}};
  CHECK(shell.yield_load() == Approx(2 * yield / 3 * 7 / 8).epsilon(1e-15));
  CHECK(shell.limit_load() == Approx(2 * yield * std::log(2.0)).epsilon(1e-15));
  // just at the limit all of it is plastic; c is a double root there: q falls short by 3 Y (1 - c/b)^2
  const ThickSphere full{
      {.inner = 1, .outer = 2, .young = young, .poisson = poisson, .yield = yield, .pressure = shell.limit_load()}};
  CHECK(full.plastic_radius() == 2);
  auto almost = full.parameters();
  almost.pressure -= 3e-8 * yield;
  CHECK(1 - ThickSphere(almost).plastic_radius() / 2 == Approx(1e-4).epsilon(1e-3));
  // a cavity in a body without yielding: hoop stress 3/2 of the tension
  const ThickSphere elastic{{.inner = 1, .young = young, .poisson = poisson, .tension = 1e6}};
  CHECK(elastic.hoop_stress(1) == Approx(1.5e6).epsilon(1e-15));
}

/// Hill's load of steady growth, integrated: velocity v(r) per growth of the plastic radius c = 1, from the elastic
/// boundary inwards to where v = r (dr/dc), with dilatation rate (1 - 2 nu)/E times the stress rate of the moving
/// metal.
double growth_limit(double e, double nu, double y) {
  const double boundary = (1 + nu) * y / e, k = 6 * (1 - 2 * nu) * y / e;
  double r = 1, v = boundary / (1 + 2 * boundary / 3), before_r = r, before = v - r;
  const auto rate = [&](double s, double w) { return -2 * w / s + k * (w / s - 1); };
  while (v < r) {
    const double h = -1e-4 * r, a = rate(r, v), b = rate(r + h / 2, v + h / 2 * a), c = rate(r + h / 2, v + h / 2 * b),
                 d = rate(r + h, v + h * c);
    before_r = r, before = v - r;
    v += h / 6 * (a + 2 * b + 2 * c + d);
    r += h;
  }
  const double inner = before_r + (r - before_r) * before / (before - (v - r));
  return 2 * y * (1.0 / 3 - std::log(inner));
}

TEST_CASE("the limit of unlimited growth is that of the steady velocity field, to first order in Y/E") {
  double last = 0;
  for (const double y : {yield, yield / 10, yield / 100}) {
    const double error = std::abs(cavitation_limit(young, poisson, y) / growth_limit(young, poisson, y) - 1);
    INFO("Y " << y << " error " << error);
    CHECK(error < y / young);
    if (last > 0) CHECK(error < last / 8);  // first order, times a logarithm that grows
    last = error;
  }
}

TEST_CASE("the thick sphere refuses impossible input in one sentence") {
  using Catch::Matchers::Contains;
  const ThickSphere::Parameters good{.inner = 1, .outer = 2, .young = 10, .poisson = 0.3, .yield = 1, .pressure = 0.5};
  CHECK_NOTHROW(ThickSphere(good));
  const auto with = [&](double ThickSphere::Parameters::*member, double value) {
    auto p = good;
    p.*member = value;
    return ThickSphere(p);
  };
  using P = ThickSphere::Parameters;
  CHECK_THROWS_WITH(with(&P::inner, -1), Contains("-1 m"));
  CHECK_THROWS_WITH(with(&P::outer, 0.5), Contains("0.5 m"));
  CHECK_THROWS_WITH(with(&P::young, 0), Contains("0 Pa"));
  CHECK_THROWS_WITH(with(&P::poisson, 0.6), Contains("0.6"));
  CHECK_THROWS_WITH(with(&P::yield, 9), Contains("9 Pa") && Contains("4.7619"));
  CHECK_THROWS_WITH(with(&P::pressure, -0.1), Contains("-0.1 Pa"));
  CHECK_THROWS_WITH(with(&P::pressure, 1.4), Contains("1.4 Pa") && Contains("1.38629"));
  CHECK_THROWS_AS(with(&P::pressure, std::nan("")), InputError);
  CHECK_THROWS_WITH(ThickSphere(good).radial_stress(0.9), Contains("0.9 m"));
  CHECK_THROWS_AS(ThickSphere(good).hoop_stress(2.1), InputError);
}

}  // namespace
