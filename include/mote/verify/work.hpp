/// \file
/// Whether the work of a material's stress is where it says.
#pragma once

#include <mote/verify/states.hpp>
#include <numbers>

namespace mote::verify::detail {

/// Work and energies of a path F(t), 0 <= t <= 1, in steps; J/kg.
struct Balance {
  double work = 0;          ///< of the stress
  double elastic = 0;       ///< gained
  double plastic = 0;       ///< dissipated
  double largest_work = 0;  ///< on the way
  double length = 0;        ///< of the path, sum of |F_new F_old^-1 - I|
};
template <class M, class F>
Balance travel(const Subject<M>& subject, const F& gradient, int steps) {
  auto state = subject.rest();
  Balance b;
  const double start = subject.material.elastic_energy(state);
  Matrix f = gradient(0.0);
  for (int i = 1; i <= steps; ++i) {
    const Matrix next = gradient(double(i) / steps), a = next * inverse(f) - Matrix::identity();
    const auto after = subject.moved(state, a);
    const double middle = 0.5 * (get<field::VolumeRatio>(state) + get<field::VolumeRatio>(after));
    b.work += 0.5 * middle / subject.material.rho0() *
              ddot(subject.stress(state) + subject.stress(after), Kinematics<double>(a).strain);
    b.largest_work = std::max(b.largest_work, std::abs(b.work));
    b.length += magnitude(a);
    state = after, f = next;
  }
  b.elastic = subject.material.elastic_energy(state) - start;
  b.plastic = subject.flow(state);
  return b;
}

/// The checks of work against energy of one material.
template <class M>
class WorkChecks {
  Subject<M> subject_;

 public:
  explicit WorkChecks(const M& m) : subject_(m) {}

  void append_to(Report& report) const {
    elastic_energy(report);
    report.rows.push_back(flow());
  }

 private:
  /// Work of the stress against elastic energy on paths without flow, straight and closed, of strains of 0.1% or less.
  ///
  /// Allowed is what half as many steps change, and what a rate form leaves: of the energy J |s|^2/(4 G) it does not
  /// count the change by J, int |s|^2/(4 G) tr(D) dt, at most sqrt(3) times the path's length of the largest energy.
  void elastic_energy(Report& report) const {
    Worst straight, closed;
    Random random(8);
    for (int i = 0; i < 16; ++i) {
      const Matrix b = random.matrix(1), c = random.matrix(1);
      for (double size = 1e-3; size > 1e-9; size /= 4) {
        const double angle = 2 * std::numbers::pi;
        const auto ray = [&](double t) { return Matrix::identity() + (t * size) * b; };
        const auto circle = [&](double t) {
          return Matrix::identity() + (size * std::sin(angle * t)) * b + (size * (1 - std::cos(angle * t))) * c;
        };
        if (travel(subject_, ray, 128).plastic != 0 || travel(subject_, circle, 128).plastic != 0) continue;
        see_balance(straight, ray, text("path ", i, " of strain ", size));
        see_balance(closed, circle, text("path ", i, " of strain ", size));
        break;
      }
    }
    const auto put = [&](const char* name, const Worst& worst) {
      report.rows.push_back(worst.saw_nothing() ? only_reported(name, 0, "not checked: it flows at any strain")
                                                : worst.row(name));
    };
    put("work is elastic energy on straight paths", straight);
    put("work is elastic energy on closed paths", closed);
  }

  /// On an isochoric path to 5%: the work of the stress is what is stored and what is dissipated.
  Row flow() const {
    Worst worst;
    Random random(9);
    for (int i = 0; i < 8; ++i) {
      Matrix b = random.matrix(1);
      const auto path = [&](double t) {
        const Matrix f = Matrix::identity() + (0.05 * t) * b;
        return (1 / std::cbrt(det(f))) * f;
      };
      const int steps = 800;
      const Balance fine = travel(subject_, path, steps), coarse = travel(subject_, path, steps / 2);
      const double kept = fine.elastic + fine.plastic, step_strain = 0.05 * magnitude(b) / steps;
      // first order, twice over; yield begins within a step, whose rise of stress times strain is in doubt
      const double steps_error =
          2 * (std::abs(fine.work - coarse.work) + std::abs(kept - coarse.elastic - coarse.plastic)) +
          subject_.c2 * step_strain * step_strain;
      worst.see(std::abs(fine.work - kept), steps_error + 256 * eps * subject_.c2, [&] {
        return text("J/kg, path ", i, ": work ", fine.work, ", elastic ", fine.elastic, ", plastic ", fine.plastic);
      });
    }
    return worst.row("work of flow is elastic and plastic");
  }

  template <class Path>
  void see_balance(Worst& worst, const Path& path, const std::string& where) const {
    const Balance fine = travel(subject_, path, 128), coarse = travel(subject_, path, 64);
    // every increment F_new F_old^-1 - I has round-off of 1
    const double noise = 256 * eps * 128 * subject_.c2 * fine.length;
    worst.see(std::abs(fine.work - fine.elastic),
              2 * fine.length * fine.largest_work + std::abs(fine.work - coarse.work) + noise,
              [&] { return text("J/kg, ", where, ": work ", fine.work, ", energy ", fine.elastic); });
  }
};

}  // namespace mote::verify::detail
