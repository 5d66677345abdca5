/// \file
/// The library's fast passes against the textbook loop (bench/textbook.hpp), which shares no code with them.
#include "against_textbook.hpp"

#include "catch.hpp"

namespace {

using namespace beside;

/// 8 x 8 x 10 cells on a wall with a void, everything in it shaken, launched upwards and sideways.
template <class Scheme, class... Sides>
void run_beside(double blend, textbook::Box box, const Sides&... sides) {
  box.planes.push_back({.axis = 2, .node = 0});
  auto transfer = transfer_of<Scheme>(blend);
  if constexpr (Scheme::affine_flip) transfer.order = blend == 1 ? 3 : 2;
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename Scheme::Shape{},
                transfer,
                typename Scheme::Update{},
                timestep::Fixed{.dt = dt},
                sides...,
                boundary::RigidWall{.side = side::z_min, .at = 0},
                aluminium};
  const geometry::Box<3> block{.lower = {-4 * h, -4 * h, 0}, .upper = {4 * h, 4 * h, 10 * h}};
  const geometry::Ball<3> hole{.centre = {0, 0, 4 * h}, .radius = 2 * h};
  solver.fill(block - hole, aluminium, {.per_axis = 2, .velocity = {400, -300, 100}});
  auto& particles = solver.particles();
  shake(particles, 20);
  Book<Scheme> book(box);
  book.blend = blend;
  if constexpr (Scheme::affine_flip) book.order = transfer.order;
  copy_particles(particles, book);

  for (int i = 0; i < 20; ++i) {
    if (i % 8 == 0) solver.refresh();  // sorts
    solver.step();
    book.step(dt);
  }

  const Difference d = compare(particles, book, box.periodic[0] ? 8 : 0);
  CAPTURE(d.position, d.velocity, d.volume, d.stress, d.plastic, d.temperature, d.affine, d.size);
  CHECK(d.largest() < 1e-12);
  const auto strain = particles.template column<field::PlasticStrain>();
  CHECK(*std::max_element(strain.begin(), strain.end()) > 1e-3);
  double impulse[3] = {}, momentum = 0;
  for (const auto& part : solver.ledger().impulse)
    for (int a = 0; a < 3; ++a) impulse[a] += part[a];
  for (double m : book.particles.m) momentum += 100 * m;
  for (int a = 0; a < 3; ++a) CHECK(std::abs(impulse[a] - book.impulse[std::size_t(a)]) < 1e-12 * momentum);
}

template <class Scheme>
double blend() {
  return Scheme::flip || Scheme::affine_flip ? GENERATE(1.0, 0.97) : 0.0;
}

}  // namespace

TEMPLATE_TEST_CASE("the passes equal the textbook between periodic sides", "[passes][textbook]", MOTE_TEST_SCHEMES) {
  const double part = blend<TestType>();
  run_beside<TestType>(part, {h, {-4, -4, 0}, {4, 4, 13}, {true, true, false}},
                       boundary::Periodic{.axis = axis::x, .from = -4 * h, .to = 4 * h},
                       boundary::Periodic{.axis = axis::y, .from = -4 * h, .to = 4 * h});
}

TEMPLATE_TEST_CASE("the passes equal the textbook between symmetry planes", "[passes][textbook]", MOTE_TEST_SCHEMES) {
  const double part = blend<TestType>();
  run_beside<TestType>(
      part,
      {h,
       {-4, -4, 0},
       {4, 4, 13},
       {},
       {{0, -4, false, false}, {0, 4, true, false}, {1, -4, false, false}, {1, 4, true, false}}},
      boundary::Symmetry{.side = side::x_min, .at = -4 * h}, boundary::Symmetry{.side = side::x_max, .at = 4 * h},
      boundary::Symmetry{.side = side::y_min, .at = -4 * h}, boundary::Symmetry{.side = side::y_max, .at = 4 * h});
}

TEMPLATE_TEST_CASE("half a body behind a symmetry plane moves as the whole", "[passes]", schemes::LinearFlipUsl,
                   schemes::LinearFlipMusl, schemes::QuadraticFlipUsl, schemes::QuadraticFlipMusl,
                   schemes::LinearApicMusl, schemes::QuadraticApicUsl, schemes::CubicFlipUsl, schemes::CubicFlipMusl,
                   schemes::CubicApicUsl, schemes::ContiguousGimpFlipUsl, schemes::ContiguousGimpFlipMusl) {
  const bool upper = GENERATE(false, true);
  const double part = blend<TestType>(), s = upper ? -1 : 1;
  const grid::Cartesian<3> cells{.spacing = h};
  const boundary::RigidWall wall{.side = side::z_min, .at = 0};
  const boundary::Symmetry mirror{.side = {axis::x, upper}, .at = 0};
  const timestep::Fixed fixed{.dt = dt};
  const auto transfer = transfer_of<TestType>(part);
  Solver half{cells, typename TestType::Shape{}, transfer, typename TestType::Update{}, fixed, wall, mirror, aluminium};
  Solver whole{cells, typename TestType::Shape{}, transfer, typename TestType::Update{}, fixed, wall, aluminium};
  const geometry::Box<3> block{.lower = {-3 * h, 0, 0}, .upper = {3 * h, 4 * h, 3 * h}};
  const std::size_t n = half.fill(block, aluminium, {.per_axis = 2, .velocity = {-s * 100, 0, 50}});
  REQUIRE(whole.fill(block, aluminium, {}) == 2 * n);
  auto &mine = half.particles(), &theirs = whole.particles();
  shake(mine, 20);
  for (std::size_t p = 0; p < 2 * n; ++p) {
    const double sign = p < n ? 1 : -1;
    auto x = mine.template get<field::Position>(p % n), v = mine.template get<field::Velocity>(p % n);
    x[0] *= sign, v[0] *= sign;
    theirs.template set<field::Position>(p, x);
    theirs.template set<field::Velocity>(p, v);
    theirs.template column<field::Mass>()[p] = mine.template column<field::Mass>()[p % n];
    if constexpr (!TestType::flip) {
      auto C = mine.template get<field::Affine>(p % n);
      for (int a = 1; a < 3; ++a) C(0, a) *= sign, C(a, 0) *= sign;
      theirs.template set<field::Affine>(p, C);
    }
    if constexpr (sized<typename TestType::Shape>)
      theirs.template set<field::HalfSize>(p, mine.template get<field::HalfSize>(p % n));
  }
  half.refresh();
  whole.refresh();
  for (int i = 0; i < 20; ++i) half.step(), whole.step();

  std::vector<std::size_t> place(2 * n);
  for (std::size_t q = 0; q < 2 * n; ++q) place[theirs.template column<field::Id>()[q]] = q;
  Difference d;
  for (std::size_t p = 0; p < n; ++p) {
    const std::size_t q = place[mine.template column<field::Id>()[p]];
    for (int a = 0; a < 3; ++a) {
      take(d.position, mine.template column<field::Position>(a)[p], theirs.template column<field::Position>(a)[q], h);
      take(d.velocity, mine.template column<field::Velocity>(a)[p], theirs.template column<field::Velocity>(a)[q], 100);
      take(d.stress, mine.template column<field::DeviatoricStress>(a + 3)[p],
           theirs.template column<field::DeviatoricStress>(a + 3)[q], 120e6);
    }
  }
  CAPTURE(d.position, d.velocity, d.stress);
  CHECK(d.largest() < 1e-12);
}
