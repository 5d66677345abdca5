/// \file
/// What mote_bench_stability prints for a scheme: rows of CSV, experiment,scheme,parameter,quantity,value.
#pragma once

#include <cstdio>

#include "../../tests/stability/plane.hpp"

namespace stability {

inline const char* word(shape::Linear) { return "linear"; }
inline const char* word(shape::QuadraticBSpline) { return "quadratic"; }
inline const char* word(shape::CubicBSpline) { return "cubic"; }
inline const char* word(shape::ContiguousGimp) { return "cpGIMP"; }
inline const char* word(transfer::Flip) { return "FLIP"; }
inline const char* word(transfer::Apic) { return "APIC"; }
inline const char* word(transfer::AffineFlip) { return "AffineFlip"; }
inline const char* word(transfer::Xpic) { return "XPIC"; }
inline const char* word(update::Usl) { return "USL"; }
inline const char* word(update::Musl) { return "MUSL"; }
inline const char* word(update::Usf) { return "USF"; }

template <class S>
class Report {
  std::string scheme_ =
      text(word(typename S::Shape{}), " ", word(typename S::Transfer{}), " ", word(typename S::Update{}));

  void row(const char* experiment, double parameter, const char* quantity, double value) const {
    std::printf("%s,%s,%.6g,%s,%.6g\n", experiment, scheme_.c_str(), parameter, quantity, value);
    std::fflush(stdout);
  }
  void end(const char* experiment, double parameter, const End& end) const {
    row(experiment, parameter, "NumericalError", end.failed());
    if (end.failed()) std::fprintf(stderr, "%s %s %g: %s\n", experiment, scheme_.c_str(), parameter, end.error.c_str());
  }

  /// In 20 periods; infinite after a NumericalError.
  static double most_energy(const Bar& bar) {
    const auto v = vibrate<S>(bar, {20});
    return v.end.failed() ? std::numeric_limits<double>::infinity() : v.most_energy;
  }

 public:
  void courant() const {
    for (const double strain : {1e-3, 0.05})
      for (int i = 1; i <= 12; ++i)
        row(strain < 0.01 ? "courant_small" : "courant_large", 0.1 * i, "most_energy",
            most_energy({.strain = strain, .courant = 0.1 * i}));
  }
  void drift() const {
    const std::vector<double> periods{20, 50, 100, 200, 300, 400, 600, 800, 1000};
    for (const double strain : {1e-3, 0.05}) {
      const auto v = vibrate<S>({.strain = strain}, periods);
      const char* name = strain < 0.01 ? "drift_small" : "drift_large";
      for (std::size_t i = 0; i < v.energy.size(); ++i) {
        row(name, periods[i], "energy", v.energy[i]);
        row(name, periods[i], "amplitude", v.amplitude[i]);
      }
      row(name, 0, "most_energy", v.most_energy);
      end(name, 1000, v.end);
    }
  }
  void surface() const {
    for (int e = 1; e <= 12; ++e) {
      const auto s = let_go<S>(std::pow(10, -e));
      row("surface", -e, "mass", s.least_mass), row("surface", -e, "kick", s.kick);
      row("surface", -e, "strain", s.strain), row("surface", -e, "swing", swing<S>(std::pow(10, -e)));
      row("surface", -e, "release", release<S>(std::pow(10, -e), 1e-3));
    }
  }
  void particles() const {
    for (const int n : {1, 2, 3, 4, 8, 27}) row("per_cell", n, "most_energy", most_energy({.per_axis = n}));
  }
  void jitter() const {
    double worst = 0, lost = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const auto v = vibrate<S>({.strain = 0.01, .jitter = 0.5, .seed = seed}, {5});
      lost += v.blew_up();
      worst = std::max(worst, v.end.failed() ? std::numeric_limits<double>::infinity() : v.most_energy);
    }
    row("jitter", 0.5, "most_energy", worst), row("jitter", 0.5, "lost", lost);
  }
  void violence() const {
    for (const double v : {1000.0, 2500.0, 5000.0, 6870.0, 10000.0}) {
      const auto c = crash<S>(v);
      row("crash", v, "pressure", c.pressure), row("crash", v, "middle", c.middle);
      row("crash", v, "finite", c.finite), end("crash", v, c.end);
    }
    if constexpr (std::is_same_v<S, Default>)
      for (const double v : {1000.0, 2500.0, 5000.0, 6870.0, 10000.0}) {
        const auto c = crash<S>(v, 0.4, viscous_metal);
        row("crash_viscous", v, "pressure", c.pressure), row("crash_viscous", v, "middle", c.middle);
        row("crash_viscous", v, "finite", c.finite), end("crash_viscous", v, c.end);
      }
    for (const double v : {400.0, 1000.0, 5000.0}) {
      const auto t = tear<S>(v);
      row("tear", v, "p_min_gpa", 1e-9 * t.pressure.least), row("tear", v, "p_max_gpa", 1e-9 * t.pressure.most);
      row("tear", v, "volume_max", t.volume.most), row("tear", v, "finite", t.finite), end("tear", v, t.end);
    }
    const auto c = collide<S>(5000);
    row("collide", 5000, "pressure", c.pressure), row("collide", 5000, "energy", c.energy);
    row("collide", 5000, "momentum", c.momentum), row("collide", 5000, "finite", c.finite);
    end("collide", 5000, c.end);
  }
  void quiet() const {
    for (const int n : {1, 2, 3, 4}) {
      const auto s = stretch<S>(n);
      row("stretch", n, "least", s.least), row("stretch", n, "most", s.most);
    }
    const auto f = fly_alone<S>();
    row("alone", 1000, "speed", f.speed), row("alone", 1000, "volume_min", f.volume.least);
    row("alone", 1000, "volume_max", f.volume.most), end("alone", 1000, f.end);
  }
  void line() const { surface(), courant(), particles(), jitter(), violence(), quiet(), drift(); }

  void plane() const {
    const auto motion = [&](const char* name, double parameter, const Motion& m) {
      row(name, parameter, "kinetic", m.kinetic), row(name, parameter, "angular_momentum", m.angular_momentum);
      row(name, parameter, "stress_mpa", 1e-6 * m.stress), row(name, parameter, "size", m.size);
      row(name, parameter, "turns", m.turns), end(name, parameter, m.end);
    };
    motion("fly", 1000, fly<S>(1000));
    motion("spin", 100, spin<S>(100));
  }
};

template <class Shape, class Transfer, class... Updates>
void line_of() {
  (Report<Scheme<Shape, Transfer, Updates>>{}.line(), ...);
}
template <class Shape, class Transfer>
void plane_of() {
  Report<Scheme<Shape, Transfer, update::Usl>>{}.plane();
  Report<Scheme<Shape, Transfer, update::Musl>>{}.plane();
}

/// What is compiled on its own; run with its name.
struct Part {
  std::string name;
  void (*run)();
};
inline std::vector<Part>& parts() {
  static std::vector<Part> all;
  return all;
}
struct Registered {
  Registered(const char* name, void (*run)()) { parts().push_back({name, run}); }
};

}  // namespace stability
