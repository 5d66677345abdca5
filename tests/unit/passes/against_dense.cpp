/// \file
/// update::Usf, transfer::Xpic and transfer::Fmpm against the slow dense loop, which shares no code with them.
#include "against_textbook.hpp"
#include "catch.hpp"
#include "dense.hpp"

namespace {

using namespace beside;

template <class X>
inline constexpr auto dense_transfer = std::is_same_v<X, transfer::Flip>   ? dense::Transfer::flip
                                       : std::is_same_v<X, transfer::Apic> ? dense::Transfer::apic
                                       : std::is_same_v<X, transfer::Xpic> ? dense::Transfer::xpic
                                                                           : dense::Transfer::fmpm;
template <class U>
inline constexpr auto dense_update = std::is_same_v<U, update::Usl>    ? dense::Update::usl
                                     : std::is_same_v<U, update::Musl> ? dense::Update::musl
                                                                       : dense::Update::usf;

template <class X>
X transfer_of_order(int order) {
  if constexpr (requires(X x) { x.order; })
    return {.order = order};
  else
    return {};
}

using LinearFlipUsf = Scheme<shape::Linear, transfer::Flip, update::Usf>;
using LinearXpicMusl = Scheme<shape::Linear, transfer::Xpic, update::Musl>;
using QuadraticApicUsf = Scheme<shape::QuadraticBSpline, transfer::Apic, update::Usf>;
using QuadraticXpicUsl = Scheme<shape::QuadraticBSpline, transfer::Xpic, update::Usl>;
using QuadraticXpicUsf = Scheme<shape::QuadraticBSpline, transfer::Xpic, update::Usf>;
using QuadraticFmpmUsl = Scheme<shape::QuadraticBSpline, transfer::Fmpm, update::Usl>;
using QuadraticFmpmMusl = Scheme<shape::QuadraticBSpline, transfer::Fmpm, update::Musl>;
using CubicXpicUsl = Scheme<shape::CubicBSpline, transfer::Xpic, update::Usl>;
using CubicFmpmUsf = Scheme<shape::CubicBSpline, transfer::Fmpm, update::Usf>;

}  // namespace

/// A block with a void on a wall, between symmetry planes and periodic sides, everything in it shaken, thrown upwards
/// and sideways.
TEMPLATE_TEST_CASE("USF, XPIC and FMPM equal the dense loop", "[passes][textbook]", LinearFlipUsf, LinearXpicMusl,
                   QuadraticApicUsf, QuadraticXpicUsl, QuadraticXpicUsf, QuadraticFmpmUsl, QuadraticFmpmMusl,
                   CubicXpicUsl, CubicFmpmUsf) {
  using X = typename TestType::Transfer;
  using U = typename TestType::Update;
  constexpr bool ordered = requires(X x) { x.order; };
  const int order = ordered ? GENERATE(1, 2, 5) : 1;
  if (!ordered && order > 1) return;
  const int n = 3;  // cells from the middle
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename TestType::Shape{},
                transfer_of_order<X>(order),
                U{},
                timestep::Fixed{.dt = dt},
                boundary::Periodic{.axis = axis::x, .from = -n * h, .to = n * h},
                boundary::Symmetry{.side = side::y_min, .at = -n * h},
                boundary::Symmetry{.side = side::y_max, .at = n * h},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                aluminium};
  const geometry::Box<3> block{.lower = {-n * h, -n * h, 0}, .upper = {n * h, n * h, 8 * h}};
  solver.fill(block - geometry::Ball<3>{.centre = {0, 0, 4 * h}, .radius = 1.5 * h}, aluminium,
              {.per_axis = 2, .velocity = {400, -300, 100}});
  auto& particles = solver.particles();
  shake(particles, 20);
  dense::Loop<TestType::Shape::support> book(
      {h, {-n, -n, 0}, {n, n, 11}, {true, false, false}, {{1, -n, false, false}, {1, n, true, false}, {2, 0}}},
      dense_transfer<X>, dense_update<U>, order);
  copy_particles(particles, book);
  for (int i = 0; i < 10; ++i) {
    if (i % 4 == 0) solver.refresh();  // sorts
    solver.step();
    book.step(dt);
  }

  const Difference d = compare(particles, book, 2 * n);
  CAPTURE(order, d.position, d.velocity, d.volume, d.stress, d.plastic, d.temperature, d.affine);
  CHECK(d.largest() < 1e-12);
  const auto strain = particles.template column<field::PlasticStrain>();
  CHECK(*std::max_element(strain.begin(), strain.end()) > 1e-3);
  double impulse[3] = {}, momentum = 0;
  for (const auto& part : solver.ledger().impulse)
    for (int a = 0; a < 3; ++a) impulse[a] += part[a];
  for (double m : book.particles.m) momentum += 500 * m;
  for (int a = 0; a < 3; ++a) CHECK(std::abs(impulse[a] - book.impulse[std::size_t(a)]) < 1e-12 * momentum);
}
