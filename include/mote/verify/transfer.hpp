/// \file
/// Whether a transfer is one: alone, and in a solver.
#pragma once

#include <array>
#include <mote/eos/linear_bulk.hpp>
#include <mote/geometry/box.hpp>
#include <mote/grid/cartesian.hpp>
#include <mote/material.hpp>
#include <mote/shape/quadratic_bspline.hpp>
#include <mote/solver.hpp>
#include <mote/timestep/fixed.hpp>
#include <mote/verify/tools.hpp>

namespace mote::verify {

namespace detail {

/// The checks of one transfer with one kernel, in plane strain, on a grid of spacing 1 m, and with numbers of 1.
template <class X, class Shape>
class TransferChecks {
  static constexpr bool affine = X::affine;
  using Vector = Vec<double, 2>;
  using Matrix2 = Mat<double, 2>;
  using Values1 = Values<double, 2, fields<field::Velocity, field::Affine>>;

  static constexpr double instant = 1e-20;  ///< s: nothing moves, nothing pushes

  const X& transfer_;

  /// K = rho0, so that the sound speed is 1 m/s at a density of 1 kg/m^3.
  static auto rubber() { return Material{mote::eos::LinearBulk{.rho0 = 1, .bulk_modulus = 1}}; }

  /// A body of `cells` x `cells` cells from `lower` on, four particles per cell, all at rest; calls f(solver).
  template <class F>
  void in_solver(double dt, Vector lower, int cells, const F& f) const {
    const auto material = rubber();
    Solver solver{grid::Cartesian<2>{.spacing = 1}, Shape{}, transfer_, mote::timestep::Fixed{.dt = dt}, material};
    const Vector size = Vector::filled(cells);
    solver.fill(geometry::Box<2>{.lower = lower, .upper = lower + size}, material, {.per_axis = 2});
    f(solver);
  }

  template <class P>
  static Vector momentum(const P& particles) {
    Vector sum{};
    for (std::size_t p = 0; p < particles.size(); ++p)
      sum += particles.template column<field::Mass>()[p] * particles.template get<field::Velocity>(p);
    return sum;
  }
  /// With the spin D (C - C^T), D = inertia h^2, of the affine matrices.
  template <class P>
  static double angular_momentum(const P& particles) {
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const auto x = particles.template get<field::Position>(p), v = particles.template get<field::Velocity>(p);
      double spin = x[0] * v[1] - x[1] * v[0];
      if constexpr (affine) {
        const auto c = particles.template get<field::Affine>(p);
        spin += Shape::inertia * (c(1, 0) - c(0, 1));
      }
      sum += particles.template column<field::Mass>()[p] * spin;
    }
    return sum;
  }
  template <class P>
  static double mass(const P& particles) {
    double sum = 0;
    for (const double m : particles.template column<field::Mass>()) sum += m;
    return sum;
  }
  static double size(const Matrix2& a) {
    double sum = 0;
    for (const double c : a.c) sum += c * c;
    return std::sqrt(sum);
  }

  static Values1 particle(const Vector& v, const Matrix2& c) {
    Values1 values;
    get<field::Velocity>(values) = v;
    get<field::Affine>(values) = c;
    return values;
  }
  static GridVelocity<double, 2> some_grid(Random& random) {
    GridVelocity<double, 2> grid{};
    for (auto* v : {&grid.pic, &grid.increment, &grid.sharp})
      for (double& c : v->c) c = random(0.25);
    for (double& c : grid.affine.c) c = random(0.25);
    grid.dt = 0.125;
    return grid;
  }
  Vector taken(Values1 values, const GridVelocity<double, 2>& grid) const {
    transfer_.update(values, grid);
    return get<field::Velocity>(values);
  }

 public:
  explicit TransferChecks(const X& transfer) : transfer_(transfer) {}

  /// A particle that moves with the grid, whose velocity was the grid's before the forces, has the grid's velocity
  /// after them: there every transfer is PIC, the limit of a fine field.
  Row pic_limit() const {
    Worst worst;
    Random random(1);
    for (int i = 0; i < 50; ++i) {
      GridVelocity<double, 2> grid = some_grid(random);
      grid.sharp = grid.pic;
      const Vector v = taken(particle(grid.pic - grid.increment, grid.affine), grid);
      worst.see(norm(v - grid.pic), 16 * eps * 2, [&] { return text("m/s, particle ", i); });
    }
    return worst.row("what moves with the grid takes its velocity");
  }

  /// Two velocities that differ by a little: what remains of the difference is kept().
  Row kept() const {
    Worst worst;
    Random random(2);
    for (int i = 0; i < 50; ++i) {
      const auto grid = some_grid(random);
      const Vector v{random(0.25), random(0.25)}, other{random(0.25), random(0.25)};
      const Vector left = taken(particle(v, grid.affine), grid) - taken(particle(other, grid.affine), grid);
      worst.see(norm(left - transfer_.kept() * (v - other)), 16 * eps * 4, [&] {
        return text("m/s, particle ", i, ": ", left[0], " is left of ", v[0] - other[0], ", kept() is ",
                    transfer_.kept());
      });
    }
    return worst.row("kept() is what a particle keeps");
  }

  Row packs() const {
    Worst worst;
    Random random(3);
    GridVelocity<Pack<double>, 2> grids{};
    grids.dt = 0.125;
    Values<Pack<double>, 2, fields<field::Velocity, field::Affine>> values;
    std::array<GridVelocity<double, 2>, lanes> grid;
    std::array<Values1, lanes> one;
    for (auto& g : grid) g = some_grid(random);
    for (auto& v : one) v = particle({random(1), random(1)}, {random(1), random(1), random(1), random(1)});
    const auto pack = [&](const auto& number) { return Pack<double>([&](int l) { return number(std::size_t(l)); }); };
    for (int i = 0; i < 2; ++i) {
      grids.pic[i] = pack([&](std::size_t l) { return grid[l].pic[i]; });
      grids.increment[i] = pack([&](std::size_t l) { return grid[l].increment[i]; });
      grids.sharp[i] = pack([&](std::size_t l) { return grid[l].sharp[i]; });
      get<field::Velocity>(values)[i] = pack([&](std::size_t l) { return get<field::Velocity>(one[l])[i]; });
    }
    for (int i = 0; i < 4; ++i) {
      grids.affine.c[i] = pack([&](std::size_t l) { return grid[l].affine.c[i]; });
      get<field::Affine>(values).c[i] = pack([&](std::size_t l) { return get<field::Affine>(one[l]).c[i]; });
    }
    transfer_.update(values, grids);
    for (std::size_t l = 0; l < lanes; ++l) {
      transfer_.update(one[l], grid[l]);
      const auto see = [&](const Pack<double>& all, double number, const char* what) {
        worst.see(std::abs(all[l] - number), 64 * eps,
                  [&] { return text(what, " in lane ", l, ": ", all[l], " instead of ", number); });
      };
      for (int i = 0; i < 2; ++i) see(get<field::Velocity>(values)[i], get<field::Velocity>(one[l])[i], "velocity");
      for (int i = 0; i < 4; ++i) see(get<field::Affine>(values).c[i], get<field::Affine>(one[l]).c[i], "affine");
    }
    return worst.row("packs are numbers, lane by lane");
  }

  /// A free cloud, shaken in place and velocity, of which the stress pushes: 20 steps at a Courant number of 0.2.
  ///
  /// Round-off per particle and step is that of its largest velocities, here some 10 m/s; 16 of it.
  void conservation(Report& report) const {
    Worst linear;
    double change = 0;
    in_solver(0.2, {0.3, 0.1}, 4, [&](auto& solver) {
      Random random(4);
      auto& particles = solver.particles();
      for (std::size_t p = 0; p < particles.size(); ++p)
        for (int a = 0; a < 2; ++a) {
          particles.template column<field::Position>(a)[p] += random(0.2);
          particles.template column<field::Velocity>(a)[p] = 0.1 * (a + 1) + random(0.1);
        }
      particles.template column<field::Velocity>(0)[5] = 4;  // one that flies far from the others
      solver.refresh();
      const double m = mass(particles), scale = m * 4;
      const Vector before = momentum(particles);
      const double spin_before = angular_momentum(particles);
      for (int step = 1; step <= 20; ++step) {
        solver.step();
        linear.see(norm(momentum(particles) - before), 16 * eps * step * scale,
                   [&] { return text("kg m/s of ", norm(before), ", step ", step, " of a shaken body"); });
      }
      change = std::abs(angular_momentum(particles) - spin_before) / (m * 0.1 * 4);
    });
    report.rows.push_back(linear.row("linear momentum is conserved"));
    report.rows.push_back(only_reported("angular momentum", change, "change over mass x 0.1 m/s x 4 m in 20 steps"));
  }

  /// v everywhere, no force: a step changes nothing.
  Row constant_field() const {
    Worst worst;
    const Vector v{0.3, -0.2};
    in_solver(instant, {0.3, 0.1}, 4, [&](auto& solver) {
      auto& particles = solver.particles();
      for (std::size_t p = 0; p < particles.size(); ++p)
        for (int a = 0; a < 2; ++a) particles.template column<field::Velocity>(a)[p] = v[a];
      solver.refresh();
      for (int step = 0; step < 3; ++step) solver.step();
      for (std::size_t p = 0; p < particles.size(); ++p) see_particle(worst, particles, p, v, Matrix2{}, 256 * eps);
    });
    return worst.row("a constant field is preserved");
  }

  /// v + B x on a lattice, in an instant, where no kernel reaches the surface; with B for the affine matrices.
  Row affine_field() const {
    Worst worst;
    int order = 1;
    if constexpr (sharpens<X> != Sharpens::nothing) order = transfer_.order;
    const int margin = (order + 1) * Shape::support, cells = 2 * margin + 2;  // each term reaches a kernel further
    const Matrix2 b{0.02, 0.5, -0.3, 0.01};
    const double largest = norm(b * Vector::filled(cells)) + 1;
    in_solver(instant, {0, 0}, cells, [&](auto& solver) {
      auto& particles = solver.particles();
      const auto at = [&](const Vector& x) { return Vector{0.3, -0.2} + b * x; };
      for (std::size_t p = 0; p < particles.size(); ++p)
        for (int a = 0; a < 2; ++a) {
          particles.template column<field::Velocity>(a)[p] = at(particles.template get<field::Position>(p))[a];
          if constexpr (affine)
            for (int c = 0; c < 2; ++c) particles.template column<field::Affine>(2 * a + c)[p] = b(a, c);
        }
      solver.refresh();
      solver.step();
      for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto x = particles.template get<field::Position>(p);
        bool inside = true;
        for (int a = 0; a < 2; ++a) inside = inside && x[a] > margin && x[a] < cells - margin;
        if (inside) see_particle(worst, particles, p, at(x), b, 256 * eps * order * largest);
      }
    });
    return worst.row("an affine field is preserved");
  }

 private:
  template <class P>
  static void see_particle(Worst& worst, const P& particles, std::size_t p, const Vector& v, const Matrix2& c,
                           double noise) {
    const auto x = particles.template get<field::Position>(p);
    const auto where = [&](const char* what) { return text(what, " at (", x[0], ", ", x[1], ")"); };
    worst.see(norm(particles.template get<field::Velocity>(p) - v), noise, [&] { return where("velocity"); });
    if constexpr (affine)
      worst.see(size(particles.template get<field::Affine>(p) - c), noise, [&] { return where("affine"); });
  }
};

}  // namespace detail

/// Checks a transfer: alone, what it takes from a grid that it moves with, and kept(), packs; in a solver of a shape
/// function, conservation of linear momentum, and that a constant and an affine field stay. The change of angular
/// momentum is reported: transfers that conserve it are few.
///
///     std::cout << mote::verify::transfer(MyTransfer{...});
template <class X, class Shape = mote::shape::QuadraticBSpline>
Report transfer(const X& x, const Shape& = {}) {
  static_assert(mote::Transfer<X>, "mote: the transfer lacks a member; transfer/concept.hpp lists them");
  const detail::TransferChecks<X, Shape> checks(x);
  Report report{"transfer", {checks.pic_limit(), checks.kept(), checks.constant_field(), checks.affine_field()}};
  checks.conservation(report);
  report.rows.push_back(checks.packs());
  return report;
}

}  // namespace mote::verify
