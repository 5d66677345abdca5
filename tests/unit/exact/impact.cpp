// The exact plate impact against symmetry, conservation laws, the acoustic limit and a calculation of its own that
// knows only the library's material update and the jump conditions.
#include <mote/exact/impact.hpp>

#include <cmath>
#include <limits>

#include "catch.hpp"

namespace {

using namespace mote;
using exact::Impact;
using exact::PlaneState;
using exact::Stretch;

const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                         strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6},
                         heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
const Material copper{eos::MieGruneisen{.rho0 = 8930, .c0 = 3940, .lambda = 1.489, .gamma0 = 2.02},
                      strength::VonMises{.shear_modulus = 47.7e9, .yield = 120e6},
                      heat::Adiabatic{.specific_heat = 383, .initial_temperature = 300}};
const Material cold_copper{copper.eos, copper.strength};

Approx near(double value, double relative) { return Approx(value).epsilon(relative); }

/// The metal stepped along uniaxial compression, n steps: its states x and their stress.
template <class M>
std::vector<std::pair<double, double>> compressed(const M& metal, double to, int n) {
  auto state = metal.template initial<double, 3>();
  std::vector<std::pair<double, double>> path{{1, 0}};
  for (int i = 0; i < n; ++i) {
    Mat<double, 3> a{};
    a(2, 2) = std::pow(to, 1.0 / n) - 1;
    metal.update(state, a);
    path.emplace_back(get<field::VolumeRatio>(state), metal.stress(state)(2, 2));
  }
  return path;
}

/// Velocity jump of the shocks that bring the metal to a stress: the jump conditions along the stepped path. Of all
/// ways to split one shock in two of which the first is the faster, the one that brings the least velocity is at the
/// knee.
double velocity_jump(const std::vector<std::pair<double, double>>& path, double rho0, double stress) {
  std::size_t end = 1;
  while (path.at(end).second > stress) ++end;
  const auto [xa, sa] = path[end - 1];
  const auto [xb, sb] = path[end];
  const double x = xa + (xb - xa) * (stress - sa) / (sb - sa);
  double least = std::sqrt(-stress * (1 - x) / rho0);  // one shock
  for (std::size_t k = 1; k < end; ++k) {
    const auto [xk, sk] = path[k];
    if (sk * (xk - x) >= (stress - sk) * (1 - xk)) continue;  // the second would overtake
    least = std::min(least, std::sqrt(-sk * (1 - xk) / rho0) + std::sqrt((sk - stress) * (xk - x) / rho0));
  }
  return least;
}

/// Jumps of mass and momentum over a front between two states, at the Lagrangian speed u (with its sign along z).
void check_jump(const PlaneState& behind, const PlaneState& ahead, double u, double rho0) {
  CHECK(-(behind.velocity - ahead.velocity) == near(u * (behind.x - ahead.x), 1e-9));
  CHECK(-rho0 * u * (behind.velocity - ahead.velocity) == near(behind.stress - ahead.stress, 1e-9));
}

}  // namespace

TEST_CASE("impact of equals: the interface moves at half the speed, exactly", "[impact]") {
  for (const double speed : {1e-3, 1.0, 17.3, 100.0, 500.0, 1000.0, 3456.789, 20000.0}) {
    INFO("speed " << speed);
    const Impact i = exact::impact(aluminium, aluminium, speed);
    CHECK(i.velocity == speed / 2);
    CHECK(i.stress == exact::plane_wave(aluminium, -speed / 2).behind.stress);
    CHECK(i.stress == i.flyer.behind.stress);
  }
  // the design's table, compression at 500 m/s
  const Impact i = exact::impact(aluminium, aluminium, 1000);
  CHECK(i.stress == near(-8175.682e6, 1e-6));
  CHECK(i.flyer.behind.temperature == near(366.925, 1e-5));
}

TEST_CASE("impact: one stress on both sides, and the same seen from the other plate", "[impact]") {
  for (const double speed : {1.0, 30.0, 100.0, 500.0, 2000.0}) {
    INFO("speed " << speed);
    const Impact onto = exact::impact(aluminium, copper, speed), back = exact::impact(copper, aluminium, speed);
    CHECK(onto.flyer.behind.stress == near(onto.stress, 1e-11));
    CHECK(onto.velocity < 0.5 * speed);  // copper is the stiffer
    CHECK(back.stress == near(onto.stress, 1e-11));
    CHECK(onto.velocity + back.velocity == near(speed, 1e-12));
    CHECK(std::isnan(exact::impact(aluminium, cold_copper, speed).target.behind.temperature));
    CHECK(exact::impact(aluminium, cold_copper, speed).velocity == onto.velocity);
  }
}

TEST_CASE("a weak impact is that of two acoustic impedances", "[impact]") {
  const auto impedance = [](const auto& m) {
    return m.eos.rho0 * std::sqrt(m.eos.c0 * m.eos.c0 + 4.0 / 3 * m.strength.shear_modulus / m.eos.rho0);
  };
  const double a = impedance(aluminium), b = impedance(copper);
  for (const double speed : {1e-4, 1e-2}) {
    const Impact i = exact::impact(aluminium, copper, speed);
    CHECK(i.velocity == near(speed * a / (a + b), 1e-5));
    CHECK(i.stress == near(-speed * a * b / (a + b), 1e-5));
    CHECK(exact::profile(i, 1e-6).size() == 4);  // elastic waves only
  }
}

TEST_CASE("impact against the stepped material and the jump conditions", "[impact]") {
  const auto flyer = compressed(aluminium, 0.75, 20000), target = compressed(copper, 0.8, 20000);
  for (const double speed : {100.0, 500.0, 2000.0}) {
    INFO("speed " << speed);
    double less = 0, more = std::max(flyer.back().second, target.back().second);  // brackets of the common stress
    for (int i = 0; i < 40; ++i) {
      const double stress = 0.5 * (less + more);
      const double sum = velocity_jump(flyer, 2700, stress) + velocity_jump(target, 8930, stress);
      (sum < speed ? less : more) = stress;
    }
    const Impact i = exact::impact(aluminium, copper, speed);
    CHECK(i.stress == near(less, 1e-5));
    CHECK(i.velocity == near(velocity_jump(target, 8930, less), 1e-5));
  }
}

TEST_CASE("impact conserves mass and momentum over each front and in the whole", "[impact]") {
  for (const double speed : {5.0, 100.0, 500.0, 3000.0}) {
    INFO("speed " << speed);
    const Impact i = exact::impact(aluminium, copper, speed);
    const double time = 0.5e-6;
    const auto all = exact::profile(i, time);
    // momentum and mass of what the waves have reached, with rho0 times the elastic fronts' way
    double momentum = 0, mass = 0, stretch = 0;
    for (std::size_t k = 1; k + 1 < all.size(); ++k) {
      const double m = all[k].state.density * (all[k].to - all[k].from);
      CHECK(all[k].to > all[k].from);
      CHECK(all[k].from == all[k - 1].to);
      mass += m, momentum += m * all[k].state.velocity, stretch += all[k].to - all[k].from;
    }
    const double reached_a = i.flyer.elastic_speed * time, reached_b = i.target.elastic_speed * time;
    CHECK(mass == near(2700 * reached_a + 8930 * reached_b, 1e-12));
    CHECK(momentum == near(2700 * reached_a * speed, 1e-9));
    CHECK(stretch == near(reached_a + reached_b - speed * time, 1e-12));

    if (!i.flyer.overdriven && i.flyer.plastic_speed > 0) {
      REQUIRE(all.size() >= 5);
      check_jump(all[1].state, all[0].state, -i.flyer.elastic_speed, 2700);
      check_jump(all[2].state, all[1].state, -i.flyer.plastic_speed, 2700);
    }
    const auto n = all.size() - 1;
    if (i.target.overdriven || i.target.plastic_speed == 0)
      check_jump(all[n - 1].state, all[n].state, i.target.elastic_speed, 8930);
    CHECK(all[0].state.velocity == near(speed, 1e-14));
    CHECK(all[n].state.velocity == 0);
    CHECK(all[0].from == -std::numeric_limits<double>::infinity());
    CHECK(all[n].to == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("impact: fronts lie where they have run in space, and at() tells the state there", "[impact]") {
  const Impact i = exact::impact(aluminium, copper, 500);
  const double t = 0.5e-6;
  const auto all = exact::profile(i, t);
  REQUIRE(all.size() == 6);
  CHECK(all[0].to == near((500 - i.flyer.elastic_speed) * t, 1e-12));  // through metal at 500 m/s
  CHECK(all[2].to == near(i.velocity * t, 1e-12));                     // the interface
  CHECK(all[5].from == near(i.target.elastic_speed * t, 1e-12));       // through metal at rest
  CHECK(all[4].to - all[3].to ==
        near((i.target.elastic_speed - i.target.plastic_speed) * i.target.elastic_limit.x * t, 1e-12));
  for (std::size_t k = 0; k < 6; ++k) CHECK(all[k].flyer == (k < 3));
  for (std::size_t k = 1; k < 5; ++k)
    CHECK(exact::at(i, 0.5 * (all[k].from + all[k].to), t).stress == all[k].state.stress);
  CHECK(exact::at(i, -1, t).velocity == 500);
  CHECK(exact::at(i, 1, t).velocity == 0);
  CHECK(exact::at(i, all[2].to, t).density > 8930);
}

TEST_CASE("impact refuses impossible input in one sentence", "[impact]") {
  using Catch::Matchers::ContainsSubstring;
  for (const double speed : {0.0, -100.0, std::nan(""), 1e6, std::numeric_limits<double>::infinity()}) {
    INFO("speed " << speed);
    CHECK_THROWS_WITH(exact::impact(aluminium, copper, speed), ContainsSubstring(text("speed is ", speed, " m/s")));
  }
  const Impact i = exact::impact(aluminium, copper, 100);
  CHECK_THROWS_AS(exact::profile(i, 0), InputError);
  CHECK_THROWS_AS(exact::at(i, 0, -1e-6), InputError);
}
