/// \file
/// The images of a node beyond mirror planes, where few particles are near and some lie beyond a plane; the fields that
/// walls allow.
#include <memory>

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

namespace {

/// A body between walls on the lower sides and, on the upper side of the first axis, a symmetry plane.
template <int D>
struct Corner {
  static constexpr int cells = 7;
  template <class Shape>
  static auto solver(Random& random) {
    const auto at = [](int a) { return boundary::RigidWall{.side = {a, false}, .at = 0}; };
    const boundary::Symmetry mirror{.side = {0, true}, .at = cells * h};
    const auto make = [&](const auto&... walls) {
      return Solver{grid::Cartesian<D>{.spacing = h},
                    Shape{},
                    transfer::Apic{},
                    timestep::Fixed{.dt = 1e-12},
                    aluminium,
                    mirror,
                    walls...};
    };
    auto all = [&] {
      if constexpr (D == 1) return make(at(0));
      if constexpr (D == 2) return make(at(0), at(1));
      if constexpr (D == 3) return make(at(0), at(1), at(2));
    };
    auto out = std::unique_ptr<decltype(all())>(new auto(all()));
    out->fill(geometry::Box<D>{.lower = {}, .upper = Vec<double, D>::filled(cells * h)}, aluminium, {});
    shake<field::Position>(out->particles(), D, 0.2 * h, random);
    shake<field::Velocity>(out->particles(), D, 100, random);
    shake<field::VolumeRatio>(out->particles(), 1, 1e-3, random);
    for (double& m : out->particles().template column<field::Mass>()) m *= 1 + random(0.9);
    out->step();
    return out;
  }
};

/// The field of a kernel at x, in cells.
template <class Shape, int D>
Vec<double, D> field_at(const grid::Blocks<double, D>& blocks, const AlignedVector<double>& field, Vec<double, D> x) {
  IVec<D> low{};
  double w[D][Shape::support];
  for (int a = 0; a < D; ++a) {
    low[a] = int(std::floor(x[a] - Shape::first));
    Shape::values(x[a] - low[a], w[a]);
  }
  Vec<double, D> sum{};
  for (int n = 0; n < int(std::pow(Shape::support, D)); ++n) {
    IVec<D> node = low;
    double weight = 1;
    for (int a = 0, rest = n; a < D; ++a, rest /= Shape::support) {
      node[a] += rest % Shape::support;
      weight *= w[a][rest % Shape::support];
    }
    if (weight != 0) sum += weight * passes::node_vector<double, D>(field.data(), blocks.find(node));
  }
  return sum;
}

template <class Shape, int D>
void check_walls() {
  Random random;
  const auto solver = Corner<D>::template solver<Shape>(random);
  auto blocks = solver->nodes();
  passes::Orbits<D> orbits;
  orbits.find(blocks, solver->domain(), Shape::support, Shape::inertia);
  const auto held = [&](auto field) {
    for (std::size_t i = 0; i < orbits.blocks(); ++i) passes::hold_field(i, orbits, field, blocks, {});
    return field;
  };
  const auto product = [&](const auto& a, const auto& b) {
    double sum = 0;
    for (std::size_t n = 0; n < blocks.nodes(); ++n)
      sum += blocks.mass[n] *
             dot(passes::node_vector<double, D>(a.data(), n), passes::node_vector<double, D>(b.data(), n));
    return sum;
  };
  const auto noise = [&] {
    auto field = blocks.velocity;
    for (double& v : field) v = random(1);
    return field;
  };
  const auto raw = noise(), once = held(raw), other = held(noise());

  // it vanishes on the walls, up to where the body ends
  for (int i = 0; i < 100; ++i)
    for (int a = 0; a < D; ++a) {
      Vec<double, D> x{};
      for (int b = 0; b < D; ++b) x[b] = b == a ? 0.0 : 2.5 + random(2.5);
      CAPTURE(a, x[0], x[D - 1]);
      REQUIRE(norm(field_at<Shape>(blocks, once, x)) < 1e-13);
    }
  // it is the nearest such field, and stays so
  const double size = product(raw, raw);
  auto rest = raw, again = held(once);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    rest[i] -= once[i];
    again[i] -= once[i];
  }
  CHECK(product(rest, rest) > 0.01 * size);
  CHECK(product(once, once) > 0.1 * size);
  CHECK(std::abs(product(rest, other)) < 1e-12 * size);
  CHECK(product(again, again) < 1e-24 * size);
  // the books: what the planes take at once of what comes, and what the forces add to the rest
  const auto come = held(blocks.previous);
  const double kept = 0.5 * product(come, come);
  CHECK(solver->ledger().wall_loss == Approx(0.5 * product(blocks.previous, blocks.previous) - kept).epsilon(1e-11));
  CHECK(solver->ledger().work == Approx(0.5 * product(blocks.velocity, blocks.velocity) - kept).epsilon(1e-9));
  // parabolas that vanish on the walls are left alone
  auto parabolas = raw;
  for (std::size_t n = 0; n < blocks.nodes(); ++n) {
    const IVec<D> at = blocks.coordinates(n);
    Vec<double, D> v{};
    for (int c = 0; c < D; ++c) {
      v[c] = 1;
      for (int a = 0; a < D; ++a) {
        const double slope = a == 0 && c == 0 ? 1 : c + 2, bend = a == 0 ? 0.5 : 1 - 0.3 * c;
        v[c] *= slope * at[a] + bend * (at[a] * at[a] - Shape::inertia);
      }
      // beside the mirror, which asks for other things
      if (at[0] > Corner<D>::cells - 3) v[c] = 0;
    }
    passes::set_node_vector(parabolas.data(), n, v);
  }
  const auto alone = held(parabolas);
  for (std::size_t n = 0; n < blocks.nodes(); ++n)
    if (blocks.mass[n] > 0)
      REQUIRE(norm(passes::node_vector<double, D>(alone.data(), n) -
                   passes::node_vector<double, D>(parabolas.data(), n)) < 1e-10);
}

}  // namespace

TEMPLATE_TEST_CASE("walls allow what vanishes on them and is a parabola near them, and take the nearest such field",
                   "[passes][boundary]", shape::QuadraticBSpline, shape::CubicBSpline) {
  check_walls<TestType, 1>();
  check_walls<TestType, 2>();
  check_walls<TestType, 3>();
}
