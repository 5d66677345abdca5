// History: times, columns, the cavity, quarters, threads; and the schedule and progress lines it shares a run with.
#include "catch.hpp"

#include <mote/observe/history.hpp>

#include <unistd.h>
#include <mote/mote.hpp>
#include <mote/observe/progress.hpp>

#include <fstream>
#include <sstream>

using namespace mote;

namespace {

namespace fs = std::filesystem;
constexpr double um = 1e-6, ns = 1e-9;

struct Scratch {
  fs::path path = fs::temp_directory_path() / ("mote_history_" + std::to_string(::getpid()));
  Scratch() { fs::remove_all(path); }
  ~Scratch() { fs::remove_all(path); }
};

std::vector<std::string> lines(const fs::path& file) {
  std::vector<std::string> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                     strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                     heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

/// A body of 8 x 8 x 12 cells with a cavity, or its quarter, between symmetry planes on a wall.
auto scene(int threads, double from) {
  return Solver{grid::Cartesian<3>{.spacing = um},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Cfl{},
                boundary::Symmetry{.side = side::x_min, .at = from},
                boundary::Symmetry{.side = side::x_max, .at = 4 * um},
                boundary::Symmetry{.side = side::y_min, .at = from},
                boundary::Symmetry{.side = side::y_max, .at = 4 * um},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                execution::Threads(threads),
                metal};
}
template <class S>
void fill(S& solver, double cavity_z = 5 * um) {
  const geometry::Box<3> block{.lower = {-4 * um, -4 * um, 0}, .upper = {4 * um, 4 * um, 12 * um}};
  solver.fill(block - geometry::Ball<3>{.centre = {0, 0, cavity_z}, .radius = 2.5 * um}, metal,
              {.velocity = {0, 0, 100}});
}

}  // namespace

TEST_CASE("schedule: exact multiples, first and last included", "[history]") {
  const auto times = [](observe::Schedule s) {
    std::vector<double> t;
    for (; s.due() < 1e9 && t.size() < 1000; s.done(t.back())) t.push_back(s.due());
    return t;
  };
  using observe::Schedule;
  CHECK(times(Schedule::periodic(0.1, 0, 0.35)) == std::vector<double>{0, 0.1, 0.2, 3 * 0.1, 0.35});
  CHECK(times(Schedule::periodic(0.1, 0, 1)).size() == 11);
  CHECK(times(Schedule::periodic(0.1, 0, 1)).back() == 1);
  CHECK(times(Schedule::periodic(5, 1, 2)) == std::vector<double>{1, 2});
  CHECK(times(Schedule::periodic(std::numeric_limits<double>::infinity(), 1, 2)) == std::vector<double>{1, 2});
  CHECK(times(Schedule::counted(0, 1, 2)).empty());
  CHECK(times(Schedule::counted(1, 1, 2)) == std::vector<double>{1});
  CHECK(times(Schedule::counted(2, 1, 2)) == std::vector<double>{1, 2});
  CHECK(times(Schedule::counted(5, 1, 2)) == std::vector<double>{1, 1.25, 1.5, 1.75, 2});
  for (int n = 3; n < 60; ++n) CHECK(int(times(Schedule::counted(n, 0.3, 12.7)).size()) == n);
  CHECK_THROWS_AS(Schedule::periodic(0, 0, 1), InputError);
  CHECK_THROWS_AS(Schedule::counted(-1, 0, 1), InputError);
}

TEST_CASE("history: a row per sample, in the paper's units", "[history]") {
  const Scratch scratch;
  auto solver = scene(2, -4 * um);
  fill(solver);
  const auto file = scratch.path / "out" / "history.csv";
  observe::History history{.file = file, .every = 0.1 * ns, .cavity = observe::Cavity{.centre = {0, 0, 5 * um}}};
  solver.run({.until = 0.55 * ns}, history);
  const auto rows = lines(file);
  REQUIRE(history.samples.size() == 7);
  REQUIRE(rows.size() == 8);
  CHECK(rows[0] ==
        "time_ns,step,vz_min_m_s,vz_max_m_s,vz_low_m_s,vz_high_m_s,vz_min_grid_m_s,vz_max_grid_m_s,p_min_mpa,p_max_mpa,"
        "t_max_k,cavity_volume_um3,cavity_width_um,cavity_height_um,kinetic_j,elastic_j,plastic_j,viscous_j,"
        "transfer_loss_j,energy_error,mass_kg,momentum_z_kg_m_s,wall_impulse_z_n_s,active_fraction");
  for (std::size_t i = 0; i < 7; ++i) CHECK(history.samples[i].time == std::min(double(i) * (0.1 * ns), 0.55 * ns));

  const observe::Sample& last = history.samples.back();
  std::vector<double> numbers;
  std::stringstream cells(rows.back());
  for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
  const observe::Ledger l = observe::ledger(solver);
  const auto v = observe::velocity_extremes(solver, 2, 12.5e-18);
  const std::vector<double> expected{0.55,
                                     double(solver.steps()),
                                     v.min,
                                     v.max,
                                     v.low,
                                     v.high,
                                     last.v_grid.min,
                                     last.v_grid.max,
                                     1e-6 * observe::pressure_range(solver).min,
                                     1e-6 * observe::pressure_range(solver).max,
                                     observe::temperature_range(solver).max,
                                     1e18 * last.cavity.volume,
                                     1e6 * last.cavity.width,
                                     1e6 * last.cavity.height,
                                     l.kinetic,
                                     l.elastic,
                                     l.plastic,
                                     0,
                                     history.samples[0].kinetic - l.kinetic + l.work,
                                     (l.kinetic + l.elastic + l.plastic) / history.samples[0].kinetic - 1,
                                     l.mass,
                                     l.momentum[2],
                                     l.wall_impulse[2],
                                     1};
  REQUIRE(numbers.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("column " << i);
    CHECK(numbers[i] == Approx(expected[i]).epsilon(1e-11).margin(1e-30));
  }
  CHECK(last.v_grid.max > 90);
  CHECK(history.samples[0].cavity.volume == Approx(4. / 3 * M_PI * std::pow(2.5 * um, 3)).epsilon(0.1));
  CHECK(last.cavity.volume != history.samples[0].cavity.volume);
}

TEST_CASE("history: a quarter tells of the whole, and threads change nothing", "[history]") {
  std::vector<observe::Sample> whole, quarter, threaded;
  const auto run = [](double from, int threads, int copies, bool mirrored) {
    auto solver = scene(threads, from);
    fill(solver);
    observe::History history{.every = 0.1 * ns,
                             .copies = copies,
                             .volume = 12.5e-18,
                             .cavity = observe::Cavity{.centre = {0, 0, 5 * um}, .mirrored = {mirrored, mirrored}}};
    solver.run({.until = 0.4 * ns}, history);
    return history.samples;
  };
  whole = run(-4 * um, 1, 1, false);
  quarter = run(0, 1, 4, true);
  threaded = run(-4 * um, 3, 1, false);
  REQUIRE(whole.size() == 5);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const auto &w = whole[i], &q = quarter[i], &t = threaded[i];
    const auto same = [](double a, double b) { CHECK(a == Approx(b).epsilon(1e-7).margin(1e-30)); };
    same(q.v.low, w.v.low), same(q.v.high, w.v.high), same(q.v.min, w.v.min), same(q.pressure.min, w.pressure.min);
    same(q.kinetic, w.kinetic), same(q.elastic, w.elastic), same(q.plastic, w.plastic), same(q.mass, w.mass);
    same(q.momentum, w.momentum), same(q.wall_impulse, w.wall_impulse), same(q.transfer_loss, w.transfer_loss);
    same(q.energy_error, w.energy_error), same(q.wall_loss, w.wall_loss);
    same(q.cavity.volume, w.cavity.volume), same(q.cavity.width, w.cavity.width),
        same(q.cavity.height, w.cavity.height);
    CHECK(t.v.low == w.v.low);
    CHECK(t.kinetic == w.kinetic);
    CHECK(t.transfer_loss == w.transfer_loss);
    CHECK(t.pressure.min == w.pressure.min);
    CHECK(t.cavity.volume == w.cavity.volume);
    CHECK((i == 0 || t.v_grid.max == w.v_grid.max));
  }
}

TEST_CASE("history: an open cavity is nan, and said once", "[history]") {
  auto solver = scene(1, -4 * um);
  fill(solver, 11 * um);
  int said = 0;
  observe::History history{.every = 0.05 * ns,
                           .cavity = observe::Cavity{.centre = {0, 0, 11 * um}},
                           .notice = [&](const std::string& what) { said += what.find("open") != what.npos; }};
  solver.run({.until = 0.2 * ns}, history);
  CHECK(history.samples.size() == 5);
  for (const auto& s : history.samples) CHECK(std::isnan(s.cavity.volume));
  CHECK(said == 1);
}

TEST_CASE("history: two dimensions, a run that ends early, progress lines", "[history]") {
  const Material water{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}};
  Solver solver{grid::Cartesian<2>{.spacing = 1}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, water};
  solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {4, 4}}, water, {.velocity = {3, -4}});
  std::vector<std::string> said;
  observe::History history{.every = 1, .axis = 0, .volume = 2, .cavity = observe::Cavity{}};
  solver.run({.until = 10, .max_steps = 3}, history,
             observe::Progress{.sink = [&](std::string line) { said.push_back(line); }, .seconds = 0});
  REQUIRE(history.samples.size() == 2);
  CHECK(history.samples[1].step == 3);
  CHECK(history.samples[1].v.max == Approx(3));
  CHECK(std::isnan(history.samples[1].cavity.volume));
  CHECK(std::isnan(history.samples[1].t_max));
  REQUIRE(said.size() == 4);
  CHECK(said.back().find("step 3") != std::string::npos);
  observe::History wrong{.axis = 2};
  CHECK_THROWS_AS(solver.run({.until = 11}, wrong), InputError);
  CHECK(observe::progress_line({0, 5.04 * ns, 12 * ns, 81, 61.3, 65}) ==
        " 42.0%  5.040 of 12.000 ns  step 81  61.3 ns per particle and step  1:05 left");
}
