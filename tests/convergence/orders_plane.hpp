/// \file
/// The problems in the plane. Compiles one solver for all of them.
#pragma once

#include "convergence/orders_bar.hpp"

namespace orders {

using Point = Vec<double, 2>;

/// How a manufactured body of two dimensions is run.
template <class Exact, class Region>
struct Scene {
  Exact exact;
  Region region;
  double plane;     ///< symmetry planes on x, y = -plane or 0, and plane; out of reach of the ring
  bool from_zero;   ///< from 0
  double wave;      ///< m/s, a bound of the fastest
  double scale;     ///< m, of the displacement
  double duration;  ///< s
  geometry::Method fill;
  int per_axis;
};

inline auto box_along_axes() {
  const auto rubber = exact::NeoHookean::from_young(1, 1e4, 0.3);
  const exact::AxisAligned<2> motion{
      {.material = rubber, .amplitude = {0.05, 0.05}, .speed = rubber.bar_speed(), .phase = {0, std::numbers::pi}}};
  return Scene{motion,
               geometry::Box<2>{.lower = {0, 0}, .upper = {1, 1}},
               1.0,
               true,
               1.6 * rubber.longitudinal_speed(),
               0.05,
               2 / rubber.bar_speed(),
               geometry::Method::lattice,
               2};
}

/// \param angle rad
inline auto vortex(double angle, int per_axis) {
  const auto rubber = exact::NeoHookean::from_young(1000, 1000, 0.3);
  const exact::GeneralizedVortex<2> motion{{.material = rubber, .amplitude = angle}};
  const double shear = 6.9 * angle;  // the largest R d_R alpha; along it b = 1 + shear^2 at most, and a bit
  const double wave = std::sqrt((rubber.mu * (3 + shear * shear) + rubber.lambda) / rubber.rho0);
  return Scene{
      motion,
      geometry::Ball<2>{.centre = {0, 0}, .radius = 1.25} - geometry::Ball<2>{.centre = {0, 0}, .radius = 0.75},
      2.0,
      false,
      wave,
      angle,
      1.0,
      geometry::Method::fraction,
      per_axis};
}

/// Puts the particles where the motion begins; see the one on the line.
template <class P, class Exact>
void begin(P& p, const std::vector<Point>& X, const Exact& exact, double dt, bool stress_first) {
  using List = typename P::list;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point at = X[p.template column<field::Id>()[i]];
    const auto f = exact.deformation_gradient(at, stress_first ? -dt : 0);
    const auto b = f * transpose(f);
    const Point x = exact.position(at, 0), v = exact.velocity(at, -0.5 * dt);
    const double four[] = {b(0, 0), b(1, 1), b(2, 2), b(0, 1)};
    for (int k = 0; k < 4; ++k) p.template column<field::LeftCauchyGreen>(k)[i] = four[k];
    p.template column<field::VolumeRatio>()[i] = det(f);
    for (int a = 0; a < 2; ++a) {
      p.template column<field::Position>(a)[i] = x[a];
      p.template column<field::Velocity>(a)[i] = v[a];
      if constexpr (contains<List, field::HalfSize>) p.template column<field::HalfSize>(a)[i] *= f(a, a);
      if constexpr (contains<List, field::Affine>)
        for (int j = 0; j < 2; ++j) {
          Point e{};
          e[j] = 1e-5;
          const Point dv = exact.velocity_at(x + e, -0.5 * dt) - exact.velocity_at(x - e, -0.5 * dt);
          p.template column<field::Affine>(2 * a + j)[i] = dv[a] / 2e-5;
        }
    }
  }
}

/// The root of the mean over mass of the squared distance to where particles should be, over the scale.
template <class P, class S>
double distance(const P& p, const std::vector<Point>& X, const S& scene, double time) {
  double squares = 0, mass = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point at = scene.exact.position(X[p.template column<field::Id>()[i]], time);
    const double m = p.template column<field::Mass>()[i];
    mass += m;
    for (int a = 0; a < 2; ++a) squares += m * std::pow(p.template column<field::Position>(a)[i] - at[a], 2);
  }
  return std::sqrt(squares / mass) / scene.scale;
}

template <class Shape, class Transfer, class S>
double run(const Transfer& transfer, const AnyUpdate& update, const S& scene, int cells) {
  const double h = 1.0 / cells, from = scene.from_zero ? 0 : -scene.plane;
  const double steps = std::ceil(scene.duration * scene.wave / (0.2 * h)), dt = scene.duration / steps;
  const auto& m = scene.exact.material();
  const Material rubber{eos::LogarithmicBulk{.rho0 = m.rho0, .bulk_modulus = m.lambda},
                        strength::NeoHookean{.shear_modulus = m.mu}};
  Solver solver{grid::Cartesian<2>{.spacing = h},
                Shape{},
                transfer,
                update,
                timestep::Fixed{.dt = dt},
                boundary::Symmetry{.side = side::x_min, .at = from},
                boundary::Symmetry{.side = side::x_max, .at = scene.plane},
                boundary::Symmetry{.side = side::y_min, .at = from},
                boundary::Symmetry{.side = side::y_max, .at = scene.plane},
                load::BodyForce<2>{scene.exact.body_force_field()},
                rubber};
  solver.fill(scene.region, rubber, {.per_axis = scene.per_axis, .method = scene.fill});
  auto& p = solver.particles();
  std::vector<Point> X(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int a = 0; a < 2; ++a) X[p.template column<field::Id>()[i]][a] = p.template column<field::Position>(a)[i];
  begin(p, X, scene.exact, dt, update.order == AnyUpdate::usf);
  solver.refresh();
  double worst = 0;
  for (int n = 1; n <= int(steps); ++n) {
    solver.step();
    if (n % 8 != 0) continue;  // what is smooth in time is not measured in each step
    const double e = distance(p, X, scene, solver.time());
    if (!(e <= worst)) worst = e;
  }
  return worst;
}

template <class Shape, class Transfer>
void add_plane(Methods& all, const char* shape, const char* name, const Transfer& transfer) {
  add(all, shape, name, [=](const AnyUpdate& update, Problem problem, int cells) {
    if (problem == Problem::axis_aligned) return run<Shape>(transfer, update, box_along_axes(), cells);
    const double angle = problem == Problem::vortex ? 1 : problem == Problem::vortex_small ? 1e-3 : 0.2;
    return run<Shape>(transfer, update, vortex(angle, problem == Problem::vortex_dense ? 4 : 2), cells);
  });
}

}  // namespace orders
