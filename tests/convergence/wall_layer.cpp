/// \file
/// Metal that slides along walls it sticks to: does it keep its volume where it is sheared most?
///
/// Between two walls, at z = 0 and 1, and symmetry planes, at x = 0 and 1, a linear elastic body swings as
///   u = a sin(w t) (S'(z) sin(k x), -k S(z) cos(k x)),  S = z^2 (1 - z)^2,  k = pi,
/// without any change of volume, under the force rho u_tt - mu nabla^2 u. So each pressure is an error. At the walls
/// u_z is its own curvature: a field that may not bend there compresses the layers at the wall (docs/accuracy.md), and
/// has order 1 in them and 1.5 in the mean.
#include <cmath>
#include <vector>

#include <mote/mote.hpp>

#include "catch.hpp"

namespace {

using namespace mote;

constexpr double amplitude = 1e-5, frequency = 2 * M_PI, wave_number = M_PI, end = 0.25;
constexpr double shear = 1, bulk = 3;  // over the density
const double sound = std::sqrt(bulk + 4.0 / 3 * shear);

/// S and its derivatives.
double stream(double z, int derivative) {
  switch (derivative) {
    case 0:
      return z * z * (1 - z) * (1 - z);
    case 1:
      return 2 * z * (1 - z) * (1 - 2 * z);
    case 2:
      return 2 - 12 * z + 12 * z * z;
    default:
      return -12 + 24 * z;
  }
}

/// (S^(n+1) sin kx, -k S^(n) cos kx): the displacement's shape for n = 0.
Vec<double, 2> shape_of(const Vec<double, 2>& x, int n) {
  return {stream(x[1], n + 1) * std::sin(wave_number * x[0]),
          -wave_number * stream(x[1], n) * std::cos(wave_number * x[0])};
}

Vec<double, 2> force(const Vec<double, 2>& x, double time) {
  const Vec<double, 2> u = shape_of(x, 0), laplace = shape_of(x, 2) - wave_number * wave_number * u;
  return -amplitude * std::sin(frequency * time) * (frequency * frequency * u + shear * laplace);
}

/// Root mean squares of P over that of a strain `amplitude`: of all particles, and of the worst of the four lowest
/// layers.
struct Error {
  double all = 0, worst_layer = 0;
};

template <class Transfer>
Error error(const Transfer& transfer, int cells) {
  const double h = 1.0 / cells, dt = 0.2 * h / sound;
  const Material soft{eos::LinearBulk{.rho0 = 1, .bulk_modulus = bulk}, strength::Elastic{.shear_modulus = shear}};
  Solver solver{grid::Cartesian<2>{.spacing = h},
                shape::QuadraticBSpline{},
                transfer,
                timestep::Fixed{.dt = dt},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                boundary::Symmetry{.side = side::x_max, .at = 1},
                boundary::RigidWall{.side = side::y_min, .at = 0},
                boundary::RigidWall{.side = side::y_max, .at = 1},
                load::BodyForce<2>{&force},
                soft};
  const auto velocity = [](const Vec<double, 2>& x) { return amplitude * frequency * shape_of(x, 0); };
  solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {1, 1}}, soft, {.velocity = velocity});
  while (solver.time() < end) solver.step();
  Error e;
  std::vector<double> layer(4), count(4);
  const auto& particles = solver.particles();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    Values<double, 2, typename std::remove_cvref_t<decltype(particles)>::list> state;
    particles.load(p, state);
    const double square = std::pow(soft.pressure(state) / (bulk * amplitude), 2);
    e.all += square / double(particles.size());
    const auto n = std::size_t(get<field::Position>(state)[1] / (0.5 * h));
    if (n < layer.size()) layer[n] += square, ++count[n];
  }
  for (std::size_t n = 0; n < layer.size(); ++n) e.worst_layer = std::max(e.worst_layer, layer[n] / count[n]);
  return {std::sqrt(e.all), std::sqrt(e.worst_layer)};
}

template <class Transfer>
void check(const Transfer& transfer) {
  const Error coarse = error(transfer, 16), middle = error(transfer, 32), fine = error(transfer, 64);
  CAPTURE(coarse.all, middle.all, fine.all, coarse.worst_layer, middle.worst_layer, fine.worst_layer);
  CHECK(std::log2(coarse.all / fine.all) / 2 == Approx(1.9).margin(0.25));
  CHECK(fine.all < 5e-4);
  CHECK(std::log2(coarse.worst_layer / fine.worst_layer) / 2 > 1.25);
  CHECK(fine.worst_layer < 2.5e-3);
}

}  // namespace

TEST_CASE("metal keeps its volume where it slides along a wall that it sticks to", "[convergence][boundary]") {
  check(transfer::AffineFlip{});
  check(transfer::Apic{});
}
