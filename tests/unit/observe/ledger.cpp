// The ledger against plain loops, and its balances.
#include "catch.hpp"

#include <mote/observe/ledger.hpp>

#include <mote/mote.hpp>

using namespace mote;

namespace {

constexpr double um = 1e-6;
const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                     strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6}};

template <class T>
auto scene(int threads) {
  return Solver{grid::Cartesian<3, T>{.spacing = um},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Cfl{},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                boundary::Symmetry{.side = side::x_max, .at = 8 * um},
                boundary::Periodic{.axis = axis::y, .from = 0, .to = 8 * um},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                load::BodyForce<3>{.acceleration = {0, 0, -1e9}},
                execution::Threads(threads),
                metal};
}
template <class S>
void fill(S& solver) {
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {8 * um, 8 * um, 12 * um}}, metal,
              {.velocity = [](const Vec<double, 3>& x) {
                return Vec<double, 3>{0, 5, 100 + 1e6 * x[0]};
              }});
}

}  // namespace

TEMPLATE_TEST_CASE("ledger: sums over particles", "[ledger]", double, float) {
  auto solver = scene<TestType>(2);
  fill(solver);
  for (int step = 0; step < 7; ++step) solver.step();
  const auto& p = solver.particles();
  double mass = 0, kinetic = 0, elastic = 0, plastic = 0, momentum[3] = {};
  for (std::size_t i = 0; i < p.size(); ++i) {
    Values<TestType, 3, particle_fields_of<std::remove_const_t<decltype(metal)>>> values;
    p.load(i, values);
    const double m = double(p.template get<field::Mass>(i));
    const auto v = cast<double>(p.template get<field::Velocity>(i));
    mass += m, kinetic += 0.5 * m * dot(v, v), elastic += m * double(metal.elastic_energy(values));
    plastic += m * double(get<field::PlasticWork>(values));
    for (int a = 0; a < 3; ++a) momentum[a] += m * v[a];
  }
  const auto found = observe::ledger(solver);
  const double eps = std::is_same_v<TestType, double> ? 1e-12 : 1e-5;
  CHECK(found.mass == Approx(mass).epsilon(1e-13));
  CHECK(found.kinetic == Approx(kinetic).epsilon(1e-13));
  CHECK(found.elastic == Approx(elastic).epsilon(eps));
  CHECK(found.plastic == Approx(plastic).epsilon(eps));
  CHECK(found.plastic > 0);
  CHECK(found.viscous == 0);
  for (int a = 0; a < 3; ++a) CHECK(found.momentum[a] == Approx(momentum[a]).epsilon(1e-12).margin(1e-25));
  CHECK(found.load_work == solver.ledger().load_work);
  CHECK(found.work == solver.ledger().work);

  const auto four = observe::ledger(solver, 4);
  CHECK(four.mass == Approx(4 * found.mass).epsilon(1e-15));
  CHECK(four.wall_impulse[2] == Approx(4 * found.wall_impulse[2]).epsilon(1e-15));
  CHECK(four.work == Approx(4 * found.work).epsilon(1e-15));
}

TEST_CASE("ledger: momentum is what wall and load gave, energies add up", "[ledger]") {
  auto solver = scene<double>(1);
  fill(solver);
  solver.refresh();
  const auto start = observe::ledger(solver);
  for (int step = 0; step < 20; ++step) solver.step();
  const auto now = observe::ledger(solver);
  const double given = now.wall_impulse[2] - 1e9 * solver.time() * now.mass;
  CHECK(now.momentum[2] - start.momentum[2] == Approx(given).epsilon(1e-9));
  CHECK(observe::transfer_loss(start, now) == start.kinetic - now.kinetic + now.work);
  CHECK(observe::transfer_loss(start, now) > 0);
  const double change = now.kinetic + now.elastic + now.plastic - now.load_work - start.kinetic;
  CHECK(observe::energy_error(start, now) == Approx(change / start.kinetic).epsilon(1e-12));
  CHECK(std::abs(observe::energy_error(start, now)) < 0.1);
  CHECK(std::isnan(observe::energy_error(observe::Ledger{}, now)));
}

TEST_CASE("ledger: the same bits for any number of threads", "[ledger]") {
  observe::Ledger found[2];
  for (int i = 0; i < 2; ++i) {
    auto solver = scene<double>(1 + 2 * i);
    fill(solver);
    for (int step = 0; step < 5; ++step) solver.step();
    found[i] = observe::ledger(solver);
  }
  CHECK(found[0].kinetic == found[1].kinetic);
  CHECK(found[0].elastic == found[1].elastic);
  CHECK(found[0].plastic == found[1].plastic);
  CHECK(found[0].momentum == found[1].momentum);
}

TEST_CASE("ledger: two dimensions, two materials, no strength", "[ledger]") {
  const Material water{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}};
  Solver solver{grid::Cartesian<2>{.spacing = 1}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, metal, water};
  solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {4, 4}}, metal, {.velocity = {3, 4}});
  solver.fill(geometry::Box<2>{.lower = {0, 4}, .upper = {4, 8}}, water, {.velocity = {3, -4}});
  const auto l = observe::ledger(solver);
  CHECK(l.mass == Approx(16 * 3700).epsilon(1e-12));
  CHECK(l.kinetic == Approx(12.5 * 16 * 3700).epsilon(1e-12));
  CHECK(l.momentum[1] == Approx(4 * 16 * 1700).epsilon(1e-12));
  CHECK(l.momentum[2] == 0);
  CHECK(l.plastic == 0);
}
