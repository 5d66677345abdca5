/// \file
/// The problems on the line, for any shape function and transfer. Compiles one solver for all of them.
#pragma once

#include <algorithm>
#include <numbers>

#include <mote/mote.hpp>

#include "convergence/orders.hpp"

namespace orders {

using namespace mote;

/// One of the three update orders, chosen at run time, so that one compiled solver serves for all.
struct AnyUpdate {
  enum Order { usl, musl, usf };
  using role = mote::role::Update;
  static constexpr bool remaps = true;  // keeps room for the second field, which only MUSL fills
  Order order;

  template <class Phases>
  void operator()(Phases& step) const {
    if (order == usl) return update::Usl{}(step);
    if (order == musl) return update::Musl{}(step);
    update::Usf{}(step);
  }
};

inline constexpr double E = 1e4, rho0 = 1, C = 100;  // Pa, kg/m^3, m/s

/// What a bar from X = 0 to `length` does, as functions of the material point and the time.
struct Motion {
  std::function<double(double, double)> displacement, velocity, stretch, force;
  double scale;       ///< m, of the displacement
  double courant;     ///< dt C/h
  double duration;    ///< s
  double length = 1;  ///< m
  bool free = false;  ///< the upper end; the lower is fixed
};

inline Motion manufactured_bar(double amplitude) {
  const exact::ManufacturedBar bar{{.modulus = E, .density = rho0, .amplitude = amplitude}};
  return {.displacement = [=](double X, double t) { return bar.displacement({X}, t)[0]; },
          .velocity = [=](double X, double t) { return bar.velocity({X}, t)[0]; },
          .stretch = [=](double X, double t) { return bar.deformation_gradient({X}, t)(0, 0); },
          .force = [=](double X, double t) { return bar.body_force({X}, t)[0]; },
          .scale = amplitude,
          .courant = 0.1,
          .duration = bar.period()};
}

inline Motion vibrating_bar() {
  const double speed = 1e-5;  // strain v/C = 1e-7: what is nonlinear is as small
  const exact::VibratingBar bar{{.length = 1, .modulus = E, .density = rho0, .speed = speed}};
  return {.displacement = [=](double X, double t) { return bar.displacement(X, t); },
          .velocity = [=](double X, double t) { return bar.velocity(X, t); },
          .stretch = [=](double X, double t) { return 1 + bar.stress(X, t) / E; },
          .force = {},
          .scale = speed / bar.frequency(),
          .courant = 0.3,
          .duration = bar.period(),
          .free = true};
}

/// u = A (g(X + Ct) -+ g(d - X + Ct)): the pulse g runs to one end and comes back, turned over by a wall, upright from
/// a free end. It begins and ends in the middle.
inline Motion pulse(bool free, double length) {
  struct Gauss {
    double at = 0.5, width = 0.08, amplitude = 1e-8;
    double value(double s) const { return amplitude * std::exp(-0.5 * std::pow((s - at) / width, 2)); }
    double slope(double s) const { return -(s - at) / (width * width) * value(s); }
  };
  const Gauss g{};
  const double sign = free ? 1 : -1;
  const auto to_end = [=](double X) { return free ? length - X : X; };  // the distance from the end that it runs to
  const auto along = [=](double X, double t) { return C * t + to_end(X); };
  const auto back = [=](double X, double t) { return C * t - to_end(X); };
  return {
      .displacement = [=](double X, double t) { return g.value(along(X, t)) + sign * g.value(back(X, t)); },
      .velocity = [=](double X, double t) { return C * (g.slope(along(X, t)) + sign * g.slope(back(X, t))); },
      .stretch = [=](double X,
                     double t) { return 1 + (free ? -1 : 1) * (g.slope(along(X, t)) - sign * g.slope(back(X, t))); },
      .force = {},
      .scale = g.amplitude,
      .courant = 0.3,
      .duration = 1 / C,
      .length = length,
      .free = free};
}

inline Motion motion_of(Problem problem, int cells) {
  if (problem == Problem::bar_large) return manufactured_bar(0.05);
  if (problem == Problem::bar_small) return manufactured_bar(1e-4);
  if (problem == Problem::vibration) return vibrating_bar();
  return pulse(problem != Problem::wall, problem == Problem::free_amid ? 1 + 0.5 / cells : 1);
}

/// The body force as in the publication, where particles bring it to the nodes: sum w m b / sum w m. It is smoothed as
/// often as the stress then. Beyond a wall it is odd, as the velocity is.
template <class Shape>
class CarriedForce {
  double spacing_;
  std::vector<double> impulse_, mass_;

 public:
  CarriedForce(double spacing, int cells)
      : spacing_(spacing), impulse_(std::size_t(cells + 1)), mass_(std::size_t(cells + 1)) {}

  /// \param b(i) the acceleration of particle i
  template <class P, class B>
  void set(const P& p, const B& b) {
    std::fill(impulse_.begin(), impulse_.end(), 0.0);
    std::fill(mass_.begin(), mass_.end(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double xi = p.template column<field::Position>()[i] / spacing_, base = std::floor(xi - Shape::first);
      const double m = p.template column<field::Mass>()[i];
      double w[Shape::support];
      if constexpr (sized<Shape>)
        Shape::values(xi - base, p.template column<field::HalfSize>()[i] / spacing_, w);
      else
        Shape::values(xi - base, w);
      for (int k = 0; k < Shape::support; ++k) {
        const auto [node, sign] = inside(long(base) + k);
        mass_[node] += w[k] * m, impulse_[node] += sign * w[k] * m * b(i);
      }
    }
  }
  double at(double x) const {
    const auto [node, sign] = inside(std::lround(x / spacing_));
    return mass_[node] > 0 ? sign * impulse_[node] / mass_[node] : 0;
  }

 private:
  std::pair<std::size_t, double> inside(long node) const {
    const long last = long(mass_.size()) - 1;
    if (node < 0) return {std::size_t(-node), -1};
    if (node > last) return {std::size_t(2 * last - node), -1};
    return {std::size_t(node), 1};
  }
};

/// Puts the particles where the motion begins. An explicit step has velocities in the middle of steps, and with USF the
/// strain lags behind the places by a step.
template <class P>
void begin(P& p, const std::vector<double>& X, const Motion& motion, double dt, bool stress_first) {
  const auto id = p.template column<field::Id>();
  const auto set = [&](auto tag, const auto& value) {
    if constexpr (requires { p.template column<decltype(tag)>(); })
      for (std::size_t i = 0; i < p.size(); ++i) p.template column<decltype(tag)>()[i] = value(X[id[i]], i);
  };
  const auto stretch = [&](double at) { return motion.stretch(at, stress_first ? -dt : 0); };
  set(field::Position{}, [&](double at, std::size_t) { return at + motion.displacement(at, 0); });
  set(field::Velocity{}, [&](double at, std::size_t) { return motion.velocity(at, -0.5 * dt); });
  set(field::VolumeRatio{}, [&](double at, std::size_t) { return stretch(at); });
  set(field::LeftCauchyGreen{}, [&](double at, std::size_t) { return std::pow(stretch(at), 2); });
  using List = typename P::list;
  if constexpr (contains<List, field::HalfSize>)
    set(field::HalfSize{},
        [&](double at, std::size_t i) { return p.template column<field::HalfSize>()[i] * stretch(at); });
  if constexpr (contains<List, field::Affine>)
    set(field::Affine{}, [&](double at, std::size_t) {
      const double e = 1e-5;
      return (motion.velocity(at + e, -0.5 * dt) - motion.velocity(at - e, -0.5 * dt)) / (2 * e * stretch(at));
    });
}

template <class Shape, class Transfer>
double error_on_line(const Transfer& transfer, const AnyUpdate& update, Problem problem, int cells) {
  const Motion motion = motion_of(problem, cells);
  const double h = 1.0 / cells, dt = motion.courant * h / C;
  CarriedForce<Shape> carried(h, cells);
  const load::BodyForce<1> force{{[&](const Vec<double, 1>& x, double) { return Vec<double, 1>{carried.at(x[0])}; }}};
  const load::BodyForce<1> none{};
  const Material rubber{eos::LogarithmicBulk{.rho0 = rho0}, strength::NeoHookean{.shear_modulus = 0.5 * E}};
  Solver solver{grid::Cartesian<1>{.spacing = h},
                Shape{},
                transfer,
                update,
                timestep::Fixed{.dt = dt},
                boundary::RigidWall{.side = side::x_min, .at = 0},
                boundary::RigidWall{.side = side::x_max, .at = motion.free ? 2.0 : 1.0},  // 2: out of reach
                motion.force ? force : none,
                rubber};
  solver.fill(geometry::Box<1>{.lower = {0}, .upper = {motion.length}}, rubber, {.per_axis = 2});
  auto& p = solver.particles();
  const auto x = p.template column<field::Position>();
  const auto id = p.template column<field::Id>();
  std::vector<double> X(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) X[id[i]] = x[i];
  begin(p, X, motion, dt, update.order == AnyUpdate::usf);
  solver.refresh();
  double worst = 0;
  while (solver.time() < motion.duration * (1 - 1e-9)) {
    if (motion.force) carried.set(p, [&](std::size_t i) { return motion.force(X[id[i]], solver.time()); });
    solver.step();
    double squares = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      squares += std::pow(x[i] - X[id[i]] - motion.displacement(X[id[i]], solver.time()), 2);
    const double rms = std::sqrt(squares / double(p.size())) / motion.scale;
    if (!(rms <= worst)) worst = rms;
  }
  return worst;
}

/// An error function with each update order; a run that fails has an infinite error.
/// \param error(update, problem, cells)
template <class F>
void add(Methods& all, const char* shape, const char* transfer, const F& error) {
  const auto one = [&](const char* name, AnyUpdate update) {
    all.push_back({shape, transfer, name, [=](Problem problem, int cells) {
                     try {
                       return error(update, problem, cells);
                     } catch (const NumericalError&) {
                       return std::numeric_limits<double>::infinity();
                     }
                   }});
  };
  one("USL", {AnyUpdate::usl});
  one("MUSL", {AnyUpdate::musl});
  one("USF", {AnyUpdate::usf});
}

/// A shape function with each transfer.
template <class Shape>
Methods on_line(const char* shape) {
  Methods all;
  const auto with = [&](const char* name, const auto& transfer) {
    add(all, shape, name, [=](const AnyUpdate& update, Problem problem, int cells) {
      return error_on_line<Shape>(transfer, update, problem, cells);
    });
  };
  with("FLIP", transfer::Flip{});
  with("APIC", transfer::Apic{});
  with("AFLIP", transfer::AffineFlip{});
  with("XPIC(5)", transfer::Xpic{.order = 5});
  with("FMPM(2)", transfer::Fmpm{.order = 2});
  return all;
}

}  // namespace orders
