/// \file
/// Problems of one and two dimensions with exact solutions. A scheme's parts are given as values.
#pragma once

#include <mote/mote.hpp>

#include "report.hpp"

namespace accuracy {

using namespace mote;

/// Accelerations at the nodes, found between the steps, so that no clock runs while the exact solution is computed.
template <int D>
class ForceTable {
  double spacing_;
  int lower_, count_;
  std::vector<Vec<double, D>> values_;

 public:
  /// Nodes from `from` to `to` along each axis, and four more at both ends.
  ForceTable(double spacing, double from, double to)
      : spacing_(spacing),
        lower_(int(std::floor(from / spacing)) - 4),
        count_(int(std::ceil(to / spacing)) + 5 - lower_),
        values_(std::size_t(D == 1 ? count_ : count_ * count_), Vec<double, D>{}) {}

  template <class Exact>
  void fill(const Exact& exact, double time) {
    for (std::size_t n = 0; n < values_.size(); ++n) {
      Vec<double, D> x{};
      x[0] = spacing_ * (lower_ + int(n) % count_);
      if constexpr (D == 2) x[1] = spacing_ * (lower_ + int(n) / count_);
      values_[n] = exact.body_force_at(x, time);
    }
  }
  Vec<double, D> at(const Vec<double, D>& x) const {
    std::size_t n = 0, stride = 1;
    for (int a = 0; a < D; ++a, stride *= std::size_t(count_)) {
      const int i = int(std::lround(x[a] / spacing_)) - lower_;
      if (i < 0 || i >= count_) return {};
      n += std::size_t(i) * stride;
    }
    return values_[n];
  }
};

inline auto neo_hookean(const exact::NeoHookean& m) {
  return Material{eos::LogarithmicBulk{.rho0 = m.rho0, .bulk_modulus = m.lambda},
                  strength::NeoHookean{.shear_modulus = m.mu}};
}

/// The root of the particles' mean square distance from where the exact motion brings `origin`, by id.
template <int D, class Solver, class Exact>
double distance(const Solver& solver, const Exact& exact, const std::vector<Vec<double, D>>& origin) {
  const auto& p = solver.particles();
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto x = exact.position(origin[p.template column<field::Id>()[i]], solver.time());
    for (int a = 0; a < D; ++a) {
      const double off = p.template column<field::Position>(a)[i] - x[a];
      sum += off * off;
    }
  }
  return std::sqrt(sum / double(p.size()));
}

/// Where the particles are, by id.
template <int D, class Particles>
std::vector<Vec<double, D>> places(const Particles& p) {
  std::vector<Vec<double, D>> x(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int a = 0; a < D; ++a) x[p.template column<field::Id>()[i]][a] = p.template column<field::Position>(a)[i];
  return x;
}

/// Lets a filled solver follow a manufactured motion. \return the largest of 40 errors on the way, over `unit`
template <int D, class Solver, class Exact>
double follow(Solver& solver, const Exact& exact, const std::vector<Vec<double, D>>& origin, ForceTable<D>& force,
              double end, double unit, StepClock& clock) {
  double worst = 0;
  const bool done = march(
      solver, end, 40, clock, [&](double time) { force.fill(exact, time); },
      [&](double) {
        const double e = distance<D>(solver, exact, origin) / unit;
        if (!(e <= worst)) worst = e;
      });
  return done ? worst : std::numeric_limits<double>::quiet_NaN();
}

/// The bar of Steffen et al., A = 0.05: it starts at rest, stretched by up to 31%, and swings once. The step is 0.3
/// h/C; the fastest signal, in the most stretched part, is 1.17 C, so that its Courant number is 0.35. The error is the
/// largest RMS of places, over A.
template <class Shape, class Transfer, class Update>
Row bar(const Shape& shape, const Transfer& transfer, const Update& update, int cells, int per_axis) {
  const exact::ManufacturedBar exact{{.modulus = 1e4, .density = 1, .amplitude = 0.05}};
  const double h = 1.0 / cells, dt = 0.3 * h / exact.speed();
  ForceTable<1> force(h, 0, 1);
  const auto rubber = neo_hookean(exact.material());
  Solver solver{grid::Cartesian<1>{.spacing = h},
                shape,
                transfer,
                update,
                timestep::Fixed{.dt = dt},
                boundary::RigidWall{.side = side::x_min, .at = 0},
                boundary::RigidWall{.side = side::x_max, .at = 1},
                load::BodyForce<1>{{[&](const Vec<double, 1>& x, double) { return force.at(x); }}},
                rubber};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {1}}, rubber, {.per_axis = per_axis});
  auto& p = solver.particles();
  const auto origin = places<1>(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto X = origin[p.template column<field::Id>()[i]];
    const double stretch = exact.deformation_gradient(X, 0)(0, 0);
    p.template column<field::Position>()[i] = exact.position(X, 0)[0];
    p.template column<field::Velocity>()[i] = exact.velocity(X, -0.5 * dt)[0];  // velocities belong to half steps
    p.template column<field::VolumeRatio>()[i] = stretch;
    p.template column<field::LeftCauchyGreen>(0)[i] = stretch * stretch;
    if constexpr (mote::sized<Shape>) p.template column<field::HalfSize>()[i] *= stretch;
  }
  solver.refresh();
  StepClock clock;
  Row row{.problem = "bar", .h = h, .per_axis = per_axis, .particles = solver.size()};
  row.error = follow<1>(solver, exact, origin, force, exact.period(), 0.05, clock);
  row.steps = solver.steps(), row.seconds = clock.seconds();
  return row;
}

/// The generalized vortex, E = 1000, nu = 0.3, rho0 = 1000, radii 0.75 and 1.25, from rest, turned by 0.4 rad and back
/// in T = 1 (shear up to 2.5). The step is 0.4 h over 3.3 m/s, the speed of the fastest signal. The error is the
/// largest RMS of places, over the way of the middle, 0.4 m.
template <class Shape, class Transfer, class Update>
Row vortex(const Shape& shape, const Transfer& transfer, const Update& update, int cells, int per_axis) {
  const double turn = 0.4;
  const exact::GeneralizedVortex<2> exact{
      {.material = exact::NeoHookean::from_young(1000, 1000, 0.3), .amplitude = turn}};
  const double h = 1.0 / cells, dt = 0.4 * h / 3.3;
  ForceTable<2> force(h, -1.25, 1.25);
  const auto rubber = neo_hookean(exact.material());
  Solver solver{grid::Cartesian<2>{.spacing = h},
                shape,
                transfer,
                update,
                timestep::Fixed{.dt = dt},
                load::BodyForce<2>{{[&](const Vec<double, 2>& x, double) { return force.at(x); }}},
                rubber};
  const auto before = [&](const Vec<double, 2>& X) { return exact.velocity(X, -0.5 * dt); };
  solver.fill(geometry::Ball<2>{.centre = {0, 0}, .radius = 1.25} - geometry::Ball<2>{.centre = {0, 0}, .radius = 0.75},
              rubber, {.per_axis = per_axis, .velocity = before, .method = geometry::Method::fraction});
  const auto origin = places<2>(solver.particles());
  StepClock clock;
  Row row{.problem = "vortex", .h = h, .per_axis = per_axis, .particles = solver.size()};
  row.error = follow<2>(solver, exact, origin, force, 1, turn, clock);
  row.steps = solver.steps(), row.seconds = clock.seconds();
  return row;
}

/// A plane wave in aluminium, as in tests/convergence/bar.hpp: 50 um launched off a wall or into it, until the plastic
/// front has come 43 um far, Courant number 0.4. Two rows: `wave_SPEED`, the mean of |v - exact| over the bar, over the
/// launch speed; `plateau_SPEED`, the mean of |stress - exact| behind the front, 0.3 to 0.8 of its way, over the
/// stress.
template <class Shape, class Transfer, class Update>
std::pair<Row, Row> wave(const Shape& shape, const Transfer& transfer, const Update& update, double launch, double um,
                         int per_axis) {
  const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                       strength::VonMises{.shear_modulus = 69e9 / (2 * 1.33), .yield = 120e6, .hardening = 384e6},
                       heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
  const auto wave = exact::plane_wave(metal, launch);
  Solver solver{
      grid::Cartesian<1>{.spacing = um * 1e-6},          shape, transfer, update, timestep::Cfl{.courant = 0.4},
      boundary::RigidWall{.side = side::x_min, .at = 0}, metal};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {50e-6}}, metal,
              {.per_axis = per_axis, .velocity = Vec<double, 1>{launch}});
  const auto& p = solver.particles();
  const auto origin = places<1>(p);
  StepClock clock;
  const std::string speed = std::to_string(int(launch));
  Row row{.problem = "wave_" + speed, .h = um, .per_axis = per_axis, .particles = solver.size()};
  double profile = 0, stress = 0, behind = 0;
  const auto compare = [&](double time) {
    profile = stress = behind = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      Values<double, 1, typename std::remove_cvref_t<decltype(p)>::list> state;
      p.load(i, state);
      const double X = origin[std::size_t(get<field::Id>(state))][0];
      profile += std::abs(get<field::Velocity>(state)[0] - exact::at(wave, X, time).velocity);
      if (X < 0.3 * 43e-6 || X > 0.8 * 43e-6) continue;
      stress += std::abs(metal.stress(state)(0, 0) / wave.behind.stress - 1), ++behind;
    }
  };
  const bool done = march(
      solver, 43e-6 / wave.plastic_speed, 1, clock, [](double) {}, compare);
  row.steps = solver.steps(), row.seconds = clock.seconds();
  Row plateau = row;
  plateau.problem = "plateau_" + speed;
  if (done) row.error = profile / double(p.size()) / std::abs(launch), plateau.error = stress / behind;
  return {row, plateau};
}

/// All meshes and particles per cell of all of these that are wanted.
template <class Shape, class Transfer, class Update>
void run_scheme(const Wanted& wanted, const std::string& shape, const std::string& transfer_name,
                const std::string& update, const Transfer& transfer) {
  const std::string name = shape + " " + transfer_name + " " + update;
  const auto print = [&](Row row) {
    row.scheme = name;
    row.print();
  };
  for (const int per_axis : {2, 3}) {
    if (wanted("bar", shape, transfer_name, update))
      for (const int cells : {32, 64, 128, 256}) print(bar(Shape{}, transfer, Update{}, cells, per_axis));
    for (const double launch : {100.0, 400.0, -500.0})
      if (wanted("wave_" + std::to_string(int(launch)), shape, transfer_name, update))
        for (const double um : {1.0, 0.5, 0.25}) {
          const auto [row, plateau] = wave(Shape{}, transfer, Update{}, launch, um, per_axis);
          print(row), print(plateau);
        }
    if (wanted("vortex", shape, transfer_name, update))
      for (const int cells : {8, 16, 32}) print(vortex(Shape{}, transfer, Update{}, cells, per_axis));
  }
}

/// All update orders.
template <class Shape, class Transfer>
void run_schemes(const Wanted& wanted, const char* shape, const char* name, const Transfer& transfer) {
  run_scheme<Shape, Transfer, update::Usl>(wanted, shape, name, "usl", transfer);
  run_scheme<Shape, Transfer, update::Musl>(wanted, shape, name, "musl", transfer);
  run_scheme<Shape, Transfer, update::Usf>(wanted, shape, name, "usf", transfer);
}

/// Transfers without an affine field.
template <class Shape>
void plain(const Wanted& wanted, const char* shape) {
  run_schemes<Shape>(wanted, shape, "flip", transfer::Flip{.blend = 1});
  run_schemes<Shape>(wanted, shape, "flip0.99", transfer::Flip{.blend = 0.99});
}
/// Transfers with one.
template <class Shape>
void affine(const Wanted& wanted, const char* shape) {
  run_schemes<Shape>(wanted, shape, "apic", transfer::Apic{});
  run_schemes<Shape>(wanted, shape, "aflip", transfer::AffineFlip{});
}
/// Transfers that go to and fro several times.
template <class Shape>
void sharpened(const Wanted& wanted, const char* shape) {
  run_schemes<Shape>(wanted, shape, "xpic", transfer::Xpic{});
  run_schemes<Shape>(wanted, shape, "fmpm", transfer::Fmpm{});
}

}  // namespace accuracy
