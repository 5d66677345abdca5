// The profile on the axis against plain loops.
#include "catch.hpp"

#include <mote/observe/axis_profile.hpp>

#include <unistd.h>
#include <mote/mote.hpp>

#include <fstream>

using namespace mote;

namespace {

constexpr double um = 1e-6;
const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                     strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                     heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

}  // namespace

TEST_CASE("axis profile: means of the column, periods and gaps", "[axis_profile]") {
  const double centre = GENERATE(0., 4.) * um;  // at the period's edge the column is on both sides
  Solver solver{grid::Cartesian<3>{.spacing = um},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Cfl{},
                boundary::Periodic{.axis = axis::x, .from = -4 * um, .to = 4 * um},
                boundary::Periodic{.axis = axis::y, .from = -4 * um, .to = 4 * um},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                execution::Threads(2),
                metal};
  const geometry::Box<3> block{.lower = {-4 * um, -4 * um, 0}, .upper = {4 * um, 4 * um, 12 * um}};
  solver.fill(block - geometry::Ball<3>{.centre = {0, 0, 6 * um}, .radius = 3 * um}, metal, {.velocity = {50, 0, 100}});
  for (int step = 0; step < 8; ++step) solver.step();

  const auto found = observe::axis_profile(solver, {centre, 0, 123}, 0.5 * um);
  const auto& p = solver.particles();
  std::size_t matched = 0;
  for (int bin = -2; bin < 40; ++bin) {
    double mass = 0, v = 0, heat = 0, volume = 0, push = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto x = p.get<field::Position>(i);
      const auto near = [](double d) {
        return std::min({std::abs(d), std::abs(d - 8 * um), std::abs(d + 8 * um)}) < um;
      };
      if (!near(x[0] - centre) || !near(x[1]) || std::floor(x[2] / (0.5 * um)) != bin) continue;
      Values<double, 3, particle_fields_of<std::remove_const_t<decltype(metal)>>> values;
      p.load(i, values);
      const double m = p.get<field::Mass>(i), vol = m * get<field::VolumeRatio>(values) / 2700;
      mass += m, v += m * p.get<field::Velocity>(i)[2], heat += m * get<field::Temperature>(values);
      volume += vol, push += vol * metal.pressure(values);
    }
    if (mass == 0) continue;
    REQUIRE(matched < found.size());
    const auto& b = found[matched++];
    CHECK(b.position == Approx((bin + 0.5) * 0.5 * um));
    CHECK(b.velocity == Approx(v / mass).epsilon(1e-12));
    CHECK(b.temperature == Approx(heat / mass).epsilon(1e-12));
    CHECK(b.pressure == Approx(push / volume).epsilon(1e-9).margin(1e-3));
    CHECK(b.density == Approx(mass / volume).epsilon(1e-12));
  }
  CHECK(matched == found.size());
  CHECK(found.size() == (centre == 0 ? 12 : 24));  // the cavity leaves a gap in the column through it
}

TEST_CASE("axis profile: rows of a file at frame times, one dimension, no temperature", "[axis_profile]") {
  const Material water{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}};
  Solver solver{grid::Cartesian<1>{.spacing = um}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, water};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {2 * um}}, water, {.per_axis = 2, .velocity = {0.5}});
  const auto file = std::filesystem::temp_directory_path() / ("mote_axis_" + std::to_string(::getpid()) + ".csv");
  solver.run({.until = 1e-9}, observe::AxisProfile{.file = file, .frames = 3});
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::filesystem::remove(file);
  REQUIRE(lines.size() == 13);
  CHECK(lines[0] == "time_ns,z_um,vz_m_s,p_mpa,t_k,rho_kg_m3");
  CHECK(lines[1].substr(0, 7) == "0,0.25,");
  CHECK(lines[5].substr(0, 9) == "0.5,0.25,");
  CHECK(lines[12].substr(0, 7) == "1,1.75,");
  CHECK(lines[1].find(",nan,") != std::string::npos);
}
