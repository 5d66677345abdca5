/// \file
/// The textbook loop is the reference of other tests, so it is tested itself, against conservation and exact motions.
#include "../../bench/textbook.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <mote/eos/mie_gruneisen.hpp>
#include <mote/heat/adiabatic.hpp>
#include <mote/material.hpp>
#include <mote/strength/von_mises.hpp>

namespace {

using textbook::Box, textbook::Loop, textbook::Plane, textbook::Shape, textbook::Transfer, textbook::Update;

constexpr double h = 1e-6, dt = 2e-11;
const mote::Material aluminium{mote::eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                               mote::strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                               mote::heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

template <Shape S, Transfer T, Update U>
struct Scheme {
  static constexpr Transfer transfer = T;
  static constexpr Update update = U;
  using Type = Loop<S, T, U>;
};
#define SCHEMES                                                                                                      \
  (Scheme<Shape::linear, Transfer::flip, Update::usl>), (Scheme<Shape::linear, Transfer::flip, Update::musl>),       \
      (Scheme<Shape::linear, Transfer::apic, Update::usl>), (Scheme<Shape::linear, Transfer::apic, Update::musl>),   \
      (Scheme<Shape::quadratic, Transfer::flip, Update::usl>),                                                       \
      (Scheme<Shape::quadratic, Transfer::flip, Update::musl>),                                                      \
      (Scheme<Shape::quadratic, Transfer::apic, Update::usl>),                                                       \
      (Scheme<Shape::quadratic, Transfer::apic, Update::musl>), (Scheme<Shape::cubic, Transfer::flip, Update::usl>), \
      (Scheme<Shape::cubic, Transfer::flip, Update::musl>), (Scheme<Shape::cubic, Transfer::apic, Update::usl>),     \
      (Scheme<Shape::cubic, Transfer::apic, Update::musl>)

struct Random {
  std::mt19937 generator{7};
  double operator()(double size) { return std::uniform_real_distribution<double>(-size, size)(generator); }
};

/// A block of jittered particles in nodes [lower, upper), eight to a cell, with random velocities about a mean.
template <class L>
void fill(L& loop, std::array<int, 3> lower, std::array<int, 3> upper, textbook::Vector mean, double scatter) {
  Random random;
  for (int i = 2 * lower[0]; i < 2 * upper[0]; ++i)
    for (int j = 2 * lower[1]; j < 2 * upper[1]; ++j)
      for (int k = 2 * lower[2]; k < 2 * upper[2]; ++k) {
        textbook::Vector x{i + 0.5, j + 0.5, k + 0.5}, v = mean;
        for (double& c : x) c = (c + random(0.2)) * 0.5 * h;
        for (double& c : v) c += random(scatter);
        loop.add(x, v, 2700 * h * h * h / 8 * (1 + random(0.1)));
      }
}

template <class L>
textbook::Vector momentum(const L& loop) {
  textbook::Vector sum{};
  for (int a = 0; a < 3; ++a)
    for (std::size_t p = 0; p < loop.particles.size(); ++p) sum[a] += loop.particles.m[p] * loop.particles.v[a][p];
  return sum;
}

template <class L>
double mass(const L& loop) {
  double sum = 0;
  for (double m : loop.particles.m) sum += m;
  return sum;
}

/// The state of the library's material beside the textbook's, both moved by the same increments.
struct Pair {
  textbook::Metal metal;
  textbook::State mine;
  decltype(aluminium.initial<double, 3>()) theirs = aluminium.initial<double, 3>();

  void update(const textbook::Matrix& A) {
    mote::Mat<double, 3> a{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a(i, j) = A[i][j];
    metal.update(mine, A);
    aluminium.update(theirs, a);
  }
  /// The largest difference, each over its own scale.
  double difference() const {
    using namespace mote;
    double d = std::abs(mine.J - get<field::VolumeRatio>(theirs));
    d = std::max(d, std::abs(mine.strain - get<field::PlasticStrain>(theirs)));
    d = std::max(d, std::abs(mine.work - get<field::PlasticWork>(theirs)) / std::max(mine.work, 1e3));
    d = std::max(d, std::abs(mine.temperature / get<field::Temperature>(theirs) - 1));
    d = std::max(d, std::abs(metal.pressure(mine.J, mine.work) - aluminium.pressure(theirs)) / 77.28e9);
    for (int c = 0; c < 6; ++c)
      d = std::max(d, std::abs(mine.s[c] - get<field::DeviatoricStress>(theirs).c[c]) / metal.yield);
    return d;
  }
};

}  // namespace

TEST_CASE("textbook: the material update is the library's", "[textbook]") {
  Random random;
  for (int chain = 0; chain < 200; ++chain) {
    Pair pair;
    const double size = std::pow(10, -4 + 2.5 * (chain % 5) / 4), bias = (chain % 3 - 1) * 0.5 * size,
                 spin = random(0.3);
    for (int step = 0; step < 10; ++step) {
      textbook::Matrix A;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) A[i][j] = random(size) + (i == j ? bias : 0);
      A[0][1] -= spin, A[1][0] += spin;
      pair.update(A);
      REQUIRE(pair.difference() < 1e-13);
    }
    if (chain % 5 == 4) REQUIRE(pair.mine.strain > 0);
  }
}

TEST_CASE("textbook: the material update in pure tension, compression, rotation and shear", "[textbook]") {
  const double e = GENERATE(-0.2, -1e-3, 1e-3, 0.2);
  Pair tension, rotation, shear, turned;
  tension.update({{{0, 0, 0}, {0, 0, 0}, {0, 0, e}}});
  shear.update({{{0, e, 0}, {0, 0, 0}, {0, 0, 0}}});
  const double c = std::cos(e) - 1, s = std::sin(e);
  rotation.update({{{c, -s, 0}, {s, c, 0}, {0, 0, 0}}});
  turned = tension;
  turned.update({{{0, 0, 0}, {0, c, -s}, {0, s, c}}});
  for (const Pair* pair : {&tension, &rotation, &shear, &turned}) REQUIRE(pair->difference() < 1e-13);
  // a rigid rotation leaves an unstressed state alone and turns a stressed one by its angle
  CHECK(std::abs(rotation.mine.J - 1) < 1e-15);
  for (double stress : rotation.mine.s) CHECK(std::abs(stress) < 1e-5);
  const double* before = tension.mine.s;
  const double cc = std::cos(e), yz = (before[1] - before[2]) * s * cc;
  CHECK(turned.mine.s[4] == Approx(yz).margin(1e-13 * 120e6));
  CHECK(turned.mine.strain == Approx(tension.mine.strain).margin(1e-14));
}

TEMPLATE_TEST_CASE("textbook: a free body keeps mass and momentum", "[textbook]", SCHEMES) {
  typename TestType::Type loop(Box{h, {-4, -4, -4}, {8, 8, 8}});
  loop.blend = TestType::transfer == Transfer::flip ? 0.9 : 1;
  loop.gravity = {1e9, 0, -2e9};
  fill(loop, {0, 0, 0}, {4, 3, 3}, {30, -20, 50}, 20);
  const textbook::Vector before = momentum(loop);
  const int steps = 15;
  for (int i = 0; i < steps; ++i) loop.step(dt);
  double nodal = 0;
  for (const auto& node : loop.nodes) nodal += node.m;
  CHECK(nodal == Approx(mass(loop)).epsilon(1e-13));
  const textbook::Vector after = momentum(loop);
  for (int a = 0; a < 3; ++a) {
    CHECK(std::abs(after[a] - before[a] - steps * dt * mass(loop) * loop.gravity[a]) < 1e-13 * mass(loop) * 50);
    CHECK(loop.impulse[a] == 0);
  }
}

TEMPLATE_TEST_CASE("textbook: planes give exactly the momentum that the body gains", "[textbook]", SCHEMES) {
  const bool no_slip = GENERATE(false, true);
  typename TestType::Type loop(
      Box{h, {0, 0, 0}, {4, 4, 8}, {true, false, false}, {Plane{2, 0, false, no_slip}, Plane{1, 0, false, false}}});
  fill(loop, {0, 0, 0}, {4, 3, 4}, {0, 0, -50}, 10);
  const textbook::Vector before = momentum(loop);
  for (int i = 0; i < 10; ++i) loop.step(dt);
  const textbook::Vector after = momentum(loop);
  CHECK(loop.impulse[2] > 0.05 * 50 * mass(loop));
  for (int a = 0; a < 3; ++a) CHECK(std::abs(after[a] - before[a] - loop.impulse[a]) < 1e-13 * mass(loop) * 50);
}

TEMPLATE_TEST_CASE("textbook: a periodic body translates exactly", "[textbook]", SCHEMES) {
  const textbook::Vector v{400, -300, 200};
  typename TestType::Type loop(Box{h, {-2, 0, 1}, {2, 3, 4}, {true, true, true}});
  fill(loop, {-2, 0, 1}, {2, 3, 4}, v, 0);
  const auto start = loop.particles;
  const int steps = 200;
  for (int i = 0; i < steps; ++i) loop.step(dt);
  double position = 0, velocity = 0, state = 0;
  for (std::size_t p = 0; p < start.size(); ++p) {
    for (int a = 0; a < 3; ++a) {
      const double cells = (loop.particles.x[a][p] - start.x[a][p] - steps * dt * v[a]) / h, period = a == 0 ? 4 : 3;
      position = std::max(position, std::abs(cells - period * std::round(cells / period)));
      velocity = std::max(velocity, std::abs(loop.particles.v[a][p] - v[a]));
    }
    state = std::max(state, std::abs(loop.particles.J[p] - 1) + std::abs(loop.particles.s[0][p]) / 77e9);
  }
  CHECK(position < 1e-12);
  CHECK(velocity < 1e-10);
  CHECK(state < 1e-12);
}

TEMPLATE_TEST_CASE("textbook: a body cut in four by symmetry planes moves as the whole", "[textbook]", SCHEMES) {
  const bool upper = GENERATE(false, true);
  typename TestType::Type quarter(
      Box{h, {0, -6, -1}, {6, 6, 4}, {}, {Plane{0, 0, false, false}, Plane{1, 0, upper, false}}});
  typename TestType::Type whole(Box{h, {-6, -6, -1}, {6, 6, 4}});
  fill(quarter, {0, upper ? -3 : 0, 0}, {3, upper ? 0 : 3, 3}, {-40, upper ? 30.0 : -30.0, 0}, 10);
  const auto& q = quarter.particles;
  for (double sx : {1, -1})
    for (double sy : {1, -1})
      for (std::size_t p = 0; p < q.size(); ++p)
        whole.add({sx * q.x[0][p], sy * q.x[1][p], q.x[2][p]}, {sx * q.v[0][p], sy * q.v[1][p], q.v[2][p]}, q.m[p]);
  for (int i = 0; i < 20; ++i) quarter.step(dt), whole.step(dt);
  double difference = 0;
  for (std::size_t p = 0; p < q.size(); ++p)
    for (int a = 0; a < 3; ++a) {
      difference = std::max(difference, std::abs(q.v[a][p] - whole.particles.v[a][p]) / 50);
      difference = std::max(difference, std::abs(q.x[a][p] - whole.particles.x[a][p]) / h);
      difference = std::max(difference, std::abs(q.s[a + 3][p] - whole.particles.s[a + 3][p]) / 120e6);
    }
  CHECK(difference < 1e-10);
  CHECK(*std::max_element(q.strain.begin(), q.strain.end()) > 0);
}

TEST_CASE("textbook: a particle that leaves the grid is an error", "[textbook]") {
  Loop<Shape::linear, Transfer::flip, Update::usl> loop(Box{h, {0, 0, 0}, {2, 2, 2}});
  loop.add({h, h, 4 * h}, {}, 1e-15);
  CHECK_THROWS_AS(loop.step(dt), std::out_of_range);
}
