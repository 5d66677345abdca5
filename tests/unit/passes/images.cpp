/// \file
/// The images of a node beyond mirror planes, where few particles are near and some lie beyond a plane.
#include "catch.hpp"
#include "schemes.hpp"

namespace {

using namespace schemes;

/// A node's place within a slot [0, cells], and the sign with which each component comes there.
template <class Plane, int D>
struct Folded {
  IVec<D> node;
  std::array<double, std::size_t(D)> sign;

  Folded(IVec<D> from, int cells) : node(from) {
    sign.fill(1);
    for (int a = 0; a < D; ++a)
      while (node[a] < 0 || node[a] > cells) {
        node[a] = (node[a] < 0 ? 0 : 2 * cells) - node[a];
        for (int c = 0; c < D; ++c) sign[std::size_t(c)] *= Plane::odd(c, a) ? -1 : 1;
      }
  }
};

/// Whether every node that has mass, inside or beyond, has the velocity of its image inside, and none through a plane.
template <class Plane, int D>
void check_mirrored(const grid::Blocks<double, D>& blocks, const AlignedVector<double>& field, int cells) {
  const auto velocity = [&](std::size_t node) { return passes::node_vector<double, D>(field.data(), node); };
  for (std::size_t n = 0; n < blocks.nodes(); ++n) {
    if (blocks.mass[n] == 0) continue;
    const IVec<D> at = blocks.coordinates(n);
    const Folded<Plane, D> inside(at, cells);
    const std::size_t image = blocks.find(inside.node);
    REQUIRE(image != blocks.none);
    for (int c = 0; c < D; ++c) {
      CAPTURE(at[0], at[D - 1], c);
      REQUIRE(velocity(n)[c] == inside.sign[std::size_t(c)] * velocity(image)[c]);
      for (int a = 0; a < D; ++a)
        if (Plane::odd(c, a) && (inside.node[a] == 0 || inside.node[a] == cells)) REQUIRE(velocity(n)[c] == 0);
    }
  }
}

/// One step of a few particles anywhere in a slot, up to 0.45 cells beyond its planes.
template <class Scheme, int D, class... Planes>
void check_step(int cells, int per_axis, Random& random, const Planes&... planes) {
  using Plane = std::common_type_t<Planes...>;
  Solver solver{grid::Cartesian<D>{.spacing = h},
                typename Scheme::Shape{},
                transfer_of<Scheme>(0.9),
                typename Scheme::Update{},
                timestep::Fixed{.dt = 1e-11},
                aluminium,
                planes...};
  solver.fill(geometry::Box<D>{.lower = {}, .upper = Vec<double, D>::filled(h)}, aluminium, {.per_axis = per_axis});
  auto& particles = solver.particles();
  for (int a = 0; a < D; ++a)
    for (double& x : particles.template column<field::Position>(a)) x = (0.5 * cells + random(0.5 * cells + 0.45)) * h;
  shake<field::Velocity>(particles, D, 100, random);
  solver.refresh();
  Vec<double, D> gain{};
  const auto add_momentum = [&](double sign) {
    for (std::size_t p = 0; p < particles.size(); ++p)
      gain += sign * particles.template column<field::Mass>()[p] * particles.template get<field::Velocity>(p);
  };
  add_momentum(-1);
  solver.step();
  add_momentum(1);
  check_mirrored<Plane, D>(solver.nodes(), solver.nodes().velocity, cells);
  if (Scheme::Update::remaps) check_mirrored<Plane, D>(solver.nodes(), solver.nodes().remapped, cells);
  for (const auto& part : solver.ledger().impulse) gain -= part;
  CHECK(norm(gain) < 1e-12 * 2700 * std::pow(h, D) * 100);
}

/// Slots 1 to 3 cells wide along all axes, with one particle and with a few.
template <class Scheme, class Plane>
void check_slots() {
  Random random;
  for (int cells : {1, 2, 3})
    for (int per_axis : {1, 2})
      for (int i = 0; i < 30; ++i) {
        CAPTURE(cells, per_axis, i);
        const auto plane = [&](int a, bool upper) { return Plane{.side = {a, upper}, .at = upper ? cells * h : 0}; };
        check_step<Scheme, 1>(cells, per_axis, random, plane(0, false), plane(0, true));
        check_step<Scheme, 2>(cells, per_axis, random, plane(0, false), plane(0, true), plane(1, false),
                              plane(1, true));
        check_step<Scheme, 3>(cells, per_axis, random, plane(0, false), plane(0, true), plane(1, false), plane(1, true),
                              plane(2, false), plane(2, true));
      }
}

}  // namespace

TEMPLATE_TEST_CASE("few particles in a narrow slot, some beyond its planes: each node moves as its image inside",
                   "[passes][boundary]", schemes::LinearFlipMusl, schemes::QuadraticApicUsl, schemes::CubicFlipMusl,
                   schemes::CubicApicUsl) {
  check_slots<TestType, boundary::RigidWall>();
  check_slots<TestType, boundary::Symmetry>();
}
