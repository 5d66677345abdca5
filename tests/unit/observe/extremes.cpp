// Extremes against plain loops over particles and nodes.
#include "catch.hpp"

#include <mote/observe/extremes.hpp>

#include <mote/mote.hpp>

using namespace mote;

namespace {

const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                     strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                     heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

constexpr double um = 1e-6;

/// 8 x 8 x 12 cells, periodic sides, launched off a wall with a velocity that varies.
template <class T>
auto scene(int threads) {
  return Solver{grid::Cartesian<3, T>{.spacing = um},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Cfl{},
                boundary::Periodic{.axis = axis::x, .from = -4 * um, .to = 4 * um},
                boundary::Periodic{.axis = axis::y, .from = -4 * um, .to = 4 * um},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                execution::Threads(threads),
                metal};
}
template <class S>
void fill(S& solver) {
  const geometry::Box<3> block{.lower = {-4 * um, -4 * um, 0}, .upper = {4 * um, 4 * um, 12 * um}};
  solver.fill(block - geometry::Ball<3>{.centre = {0, 0, 5 * um}, .radius = 2 * um}, metal,
              {.velocity = [](const Vec<double, 3>& x) {
                return Vec<double, 3>{20 * std::sin(x[2] / um), 10, 100 + 30 * std::cos(x[0] / um)};
              }});
}

/// Mean of the smallest (sign 1) or largest (-1) values, by sorting all particles.
template <class S>
double plain_mean(const S& solver, int axis, double volume, double sign) {
  const auto& p = solver.particles();
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < p.size(); ++i)
    all.emplace_back(sign * double(p.template get<field::Velocity>(i)[axis]),
                     double(p.template get<field::Mass>(i)) * double(p.template get<field::VolumeRatio>(i)) / 2700);
  std::sort(all.begin(), all.end());
  double sum = 0, left = volume, used = 0;
  for (const auto& [v, size] : all) {
    const double part = std::min(left, size);
    sum += part * v, left -= part, used += part;
  }
  return sign * sum / used;
}

}  // namespace

TEMPLATE_TEST_CASE("extremes: particles", "[extremes]", double, float) {
  auto solver = scene<TestType>(2);
  fill(solver);
  for (int step = 0; step < 6; ++step) solver.step();
  const auto& p = solver.particles();
  observe::Range v, pressure, temperature;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<TestType, 3, particle_fields_of<std::remove_const_t<decltype(metal)>>> values;
    p.load(i, values);
    for (auto& [range, x] : {std::pair<observe::Range*, TestType>{&v, p.template get<field::Velocity>(i)[2]},
                             {&pressure, metal.pressure(values)},
                             {&temperature, get<field::Temperature>(values)}})
      *range += observe::Range{double(x), double(x)};
  }
  const double volume = GENERATE(0.01, 0.3, 12.5, 200., 1e4) * um * um * um;
  const auto found = observe::velocity_extremes(solver, 2, volume);
  CHECK(found.min == v.min);
  CHECK(found.max == v.max);
  CHECK(found.low == Approx(plain_mean(solver, 2, volume, 1)).epsilon(1e-12));
  CHECK(found.high == Approx(plain_mean(solver, 2, volume, -1)).epsilon(1e-12));

  const double exact = std::is_same_v<TestType, double> ? 1e-12 : 1e-6;  // packs may contract differently
  const double scale = std::max(-pressure.min, pressure.max);
  CHECK(observe::pressure_range(solver).min == Approx(pressure.min).margin(scale * exact * 10));
  CHECK(observe::pressure_range(solver).max == Approx(pressure.max).margin(scale * exact * 10));
  CHECK(observe::temperature_range(solver).min == temperature.min);
  CHECK(observe::temperature_range(solver).max == temperature.max);
}

TEST_CASE("extremes: all particles alike, and a body without temperature", "[extremes]") {
  const Material cold{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}};
  Solver solver{grid::Cartesian<1>{.spacing = 1}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, cold};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1000}}, cold, {.per_axis = 3, .velocity = {-7}});
  const auto v = observe::velocity_extremes(solver, 0, 12.5);
  CHECK(v.min == -7);
  CHECK(v.max == -7);
  CHECK(v.low == Approx(-7).epsilon(1e-14));
  CHECK(v.high == Approx(-7).epsilon(1e-14));
  CHECK(std::isnan(observe::temperature_range(solver).max));
  CHECK(observe::pressure_range(solver).min == 0);
  CHECK(std::isnan(observe::grid_velocity_range(solver, 0).min));  // no step yet
  CHECK_THROWS_AS(observe::velocity_extremes(solver, 0, 0), InputError);
}

TEST_CASE("extremes: nodes with a tenth of their full mass, not beyond planes", "[extremes]") {
  auto solver = scene<double>(3);
  fill(solver);
  solver.step();
  solver.step();
  observe::Range plain;
  const auto& nodes = solver.nodes();
  for (int i = -4; i < 4; ++i)
    for (int j = -4; j < 4; ++j)
      for (int k = 0; k <= 16; ++k) {
        const auto n = nodes.find({i, j, k});
        const double full = 2700 * um * um * um * (k == 0 ? 0.5 : 1);
        if (n == nodes.none || nodes.mass[n] < 0.1 * full) continue;
        plain += observe::Range{nodes.velocity[4 * n + 2], nodes.velocity[4 * n + 2]};
      }
  const auto found = observe::grid_velocity_range(solver, 2);
  CHECK(found.min == plain.min);
  CHECK(found.max == plain.max);
  CHECK(found.min >= 0);  // the images below the wall have v < 0
  CHECK(found.max > 100);
}
