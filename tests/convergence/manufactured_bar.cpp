// The manufactured bar in the solver: order 2 for every kernel while displacements are far below a cell.
#include <algorithm>
#include <array>
#include <cmath>
#include <mote/mote.hpp>
#include <vector>

#include "catch.hpp"

namespace {

using namespace mote;

/// The bar's law as an equation of state: in uniaxial strain the stress is P(F) with F = x.
struct BarLaw {
  using role = mote::role::Eos;
  double rho0, modulus;

  template <class T>
  T pressure(const T& x, const T&) const {
    return T(-0.5 * modulus) * (x - T(1) / x);
  }
  template <class T>
  T bulk_sound_speed2(const T& x, const T&) const {
    return T(0.5 * modulus / rho0) * (x * x + T(1));
  }
  template <class T>
  T reference_energy(const T& x) const {
    using std::log;
    return T(0.5 * modulus / rho0) * (T(0.5) * (x * x - T(1)) - log(x));
  }
  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  double gamma_over_volume() const { return 0; }
  template <class T>
  auto admissible(const T& x) const {
    return x > T(0);
  }
};

/// Largest over a period of the RMS over particles of the error in place, over the amplitude. The bar starts undeformed
/// and moving, so the sine of the axis-aligned solution serves.
template <class Shape>
double error(const Shape& shape, int cells, double amplitude) {
  const exact::AxisAligned<1> exact{
      {.material = {.rho0 = 1, .lambda = 0, .mu = 5e3}, .amplitude = {amplitude}, .speed = 100}};
  const Material bar{BarLaw{.rho0 = 1, .modulus = 1e4}};
  Solver solver{grid::Cartesian<1>{.spacing = 1.0 / cells},
                shape,
                transfer::Flip{.blend = 1},
                timestep::Cfl{.courant = 0.1},
                boundary::RigidWall{.side = side::x_min, .at = 0},
                boundary::RigidWall{.side = side::x_max, .at = 1},
                load::BodyForce<1>{exact.body_force_field()},
                bar};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1}}, bar, {.per_axis = 2, .velocity = exact.velocity_field(0)});
  const auto id = [&] { return solver.particles().template column<field::Id>(); };
  const auto place = [&] { return solver.particles().template column<field::Position>(0); };
  std::vector<double> point(place().size());
  for (std::size_t p = 0; p < point.size(); ++p) point.at(std::size_t(id()[p])) = place()[p];
  double worst = 0;
  while (solver.time() < 0.02) {
    solver.step();
    double squares = 0;
    for (std::size_t p = 0; p < point.size(); ++p) {
      const double at = exact.position({point[std::size_t(id()[p])]}, solver.time())[0];
      squares += (place()[p] - at) * (place()[p] - at);
    }
    worst = std::max(worst, std::sqrt(squares / double(point.size())) / amplitude);
  }
  return worst;
}

TEST_CASE("the manufactured bar of small amplitude converges with order 2") {
  const auto check = [](const auto& shape) {
    std::array<double, 4> e{};
    for (int k = 0; k < 4; ++k) e[std::size_t(k)] = error(shape, 16 << k, 1e-4);
    INFO("errors " << e[0] << " " << e[1] << " " << e[2] << " " << e[3]);
    CHECK(std::log2(e[1] / e[2]) == Approx(2).margin(0.15));
    CHECK(std::log2(e[2] / e[3]) == Approx(2).margin(0.1));
    CHECK(e[3] < 1.3e-3);  // a wrong force would leave an error of order 1
  };
  check(shape::Linear{});
  check(shape::QuadraticBSpline{});
  check(shape::CubicBSpline{});
}

}  // namespace
