/// \file
/// What the passes between particles and grid conserve.
#include <optional>

#include "catch.hpp"
#include "schemes.hpp"

namespace {

using namespace schemes;

/// So soft that its stress is nothing beside any momentum. Of the metal's type, whose kernels are there.
const Aluminium dust{eos::MieGruneisen{.rho0 = 1000, .c0 = 1e-16, .lambda = 1.34, .gamma0 = 1.96},
                     strength::VonMises{.shear_modulus = 1e-30, .yield = 1},
                     heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

template <int D>
geometry::Box<D> cube(double from, double to) {
  return {.lower = Vec<double, D>::filled(from * h), .upper = Vec<double, D>::filled(to * h)};
}

template <class P>
double mass(const P& particles) {
  double sum = 0;
  for (double m : particles.template column<field::Mass>()) sum += m;
  return sum;
}

template <class P>
auto momentum(const P& particles) {
  Vec<double, P::dimension> sum{};
  for (std::size_t p = 0; p < particles.size(); ++p)
    sum += particles.template column<field::Mass>()[p] * particles.template get<field::Velocity>(p);
  return sum;
}

/// About the origin in the plane (i, j), with the spin D (C - C^T), D = inertia h^2, that the affine matrices carry.
template <class Shape, class P>
double angular_momentum(const P& particles, int i, int j) {
  double sum = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const auto x = particles.template get<field::Position>(p), v = particles.template get<field::Velocity>(p);
    const auto C = particles.template get<field::Affine>(p);
    sum += particles.template column<field::Mass>()[p] *
           (x[i] * v[j] - x[j] * v[i] + Shape::inertia * h * h * (C(j, i) - C(i, j)));
  }
  return sum;
}

/// Moves a free cloud of dust, whose particles fly at random velocities, by 20 steps.
/// \param check called with the solver before and after
template <class Scheme, int D, class F>
void fly(const F& check) {
  Solver solver{grid::Cartesian<D>{.spacing = h}, typename Scheme::Shape{},     transfer_of<Scheme>(0.9),
                typename Scheme::Update{},        timestep::Fixed{.dt = 2e-10}, dust};
  solver.fill(cube<D>(-3, 3), dust, {.per_axis = 2, .velocity = Vec<double, D>::filled(50)});
  shake(solver.particles(), 100);
  solver.refresh();
  check(solver);
  for (int i = 0; i < 20; ++i) solver.step();
  check(solver);
}

/// The first number it is given is the reference for the second.
struct Kept {
  std::optional<double> before = {};
  void operator()(double now, double tolerance) {
    if (before) CHECK(std::abs(now - *before) < tolerance);
    before = now;
  }
};

template <class Scheme, int D>
void check_conservation() {
  Kept total, component[D];
  fly<Scheme, D>([&](const auto& solver) {
    const double m = mass(solver.particles());
    total(m, 1e-14 * m);
    for (int a = 0; a < D; ++a) component[a](momentum(solver.particles())[a], 1e-13 * m * 100);
    if (solver.steps() == 0) return;
    double nodal = 0;
    for (double n : solver.nodes().mass) nodal += n;
    CHECK(std::abs(nodal - m) < 1e-13 * m);
  });
}

template <class Scheme, int D>
void check_angular_momentum() {
  Kept spin[D][D];
  fly<Scheme, D>([&](const auto& solver) {
    const double scale = mass(solver.particles()) * 100 * 3 * h;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < i; ++j)
        spin[i][j](angular_momentum<typename Scheme::Shape>(solver.particles(), i, j), 1e-13 * scale);
  });
}

/// A block thrown into a wall between symmetry planes; the scene of a shock.
template <class Scheme, int D>
void check_impulse() {
  constexpr int z = D - 1;
  const double blend = GENERATE(1.0, 0.9);
  if (!Scheme::flip && blend < 1) return;
  Solver solver{grid::Cartesian<D>{.spacing = h},
                typename Scheme::Shape{},
                transfer_of<Scheme>(blend),
                typename Scheme::Update{},
                timestep::Cfl{.courant = 0.3},
                boundary::RigidWall{.side = {z, false}, .at = 0},
                boundary::Symmetry{.side = side::x_min, .at = -h},
                boundary::Symmetry{.side = side::x_max, .at = 4 * h},
                aluminium};
  auto block = cube<D>(0, 5);
  block.lower[0] = -h, block.upper[0] = 4 * h;
  solver.fill(block, aluminium, {.per_axis = 2, .velocity = [](const Vec<double, D>& x) {
                                   Vec<double, D> v{};
                                   v[0] = 80, v[D - 1] = -500 - 20e6 * x[0];
                                   return v;
                                 }});
  auto& particles = solver.particles();
  const auto before = momentum(particles);
  for (int i = 0; i < 20; ++i) solver.step();
  Vec<double, D> given{};
  for (const auto& part : solver.ledger().impulse) given += part;
  CHECK(given[z] > 0.05 * mass(particles) * 500);
  CHECK(norm(momentum(particles) - before - given) < 1e-13 * mass(particles) * 500);
  for (int part : {1, 2})
    for (int a = 1; a < z; ++a) CHECK(solver.ledger().impulse[std::size_t(part)][a] == 0);
}

}  // namespace

TEMPLATE_TEST_CASE("transfers conserve mass and momentum", "[passes]", MOTE_TEST_SCHEMES) {
  check_conservation<TestType, 1>();
  check_conservation<TestType, 2>();
}

// a covering few; against_textbook.cpp has all of them in three dimensions
TEMPLATE_TEST_CASE("transfers conserve mass and momentum in three dimensions", "[passes]", schemes::QuadraticApicUsl,
                   schemes::QuadraticAffineFlipUsl, schemes::LinearFlipMusl) {
  check_conservation<TestType, 3>();
}

TEMPLATE_TEST_CASE("APIC with B-splines conserves angular momentum", "[passes]", schemes::QuadraticApicUsl,
                   schemes::QuadraticApicMusl, schemes::CubicApicUsl, schemes::CubicApicMusl) {
  check_angular_momentum<TestType, 2>();
  check_angular_momentum<TestType, 3>();
}

TEMPLATE_TEST_CASE("planes give exactly the momentum that the body gains", "[passes]", MOTE_TEST_SCHEMES) {
  check_impulse<TestType, 2>();
}

TEMPLATE_TEST_CASE("planes give exactly the momentum that the body gains in three dimensions", "[passes]",
                   schemes::QuadraticApicUsl, schemes::QuadraticAffineFlipUsl, schemes::LinearFlipMusl) {
  check_impulse<TestType, 3>();
}

TEMPLATE_TEST_CASE("a body force adds mass times acceleration times time", "[passes]", MOTE_TEST_SCHEMES) {
  const Vec<double, 2> b{1e9, -3e9};
  Solver solver{grid::Cartesian<2>{.spacing = h},
                typename TestType::Shape{},
                transfer_of<TestType>(0.9),
                typename TestType::Update{},
                timestep::Fixed{.dt = 3e-11},
                load::BodyForce<2>{b},
                aluminium};
  solver.fill(cube<2>(-3, 3), aluminium, {.velocity = {50, 0}});
  auto& particles = solver.particles();
  shake(particles, 20);
  solver.refresh();
  const auto before = momentum(particles);
  for (int i = 0; i < 20; ++i) solver.step();
  const auto gain = momentum(particles) - before, expected = b * (mass(particles) * solver.time());
  CHECK(norm(gain - expected) < 1e-12 * norm(expected));
}
