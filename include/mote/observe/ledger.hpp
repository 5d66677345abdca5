/// \file
/// The ledger: mass, momenta and energies of the whole body.
#pragma once

#include <mote/observe/schedule.hpp>

namespace mote::observe {

/// Extensive quantities of all bodies at one time, sums over particles unless said otherwise. In one and two dimensions
/// they are per m^2 and per m, and the missing components are zero.
struct Ledger {
  double mass = 0;                ///< kg
  Vec<double, 3> momentum{};      ///< sum m v, kg m/s
  double kinetic = 0;             ///< sum 1/2 m v^2, J
  double elastic = 0;             ///< recoverable: sum m e, e the material's elastic energy (J/kg), J
  double plastic = 0;             ///< sum m W_p, J
  double viscous = 0;             ///< dissipated by shock viscosity, J
  double load_work = 0;           ///< done by loads since the solver began, on the grid, J
  double work = 0;                ///< done by all forces since the solver began, on the grid, J
  double wall_loss = 0;           ///< kinetic energy taken since then by planes that incoming momentum disobeys, J
  double piston_work = 0;         ///< done by pistons since the solver began, J
  Vec<double, 3> wall_impulse{};  ///< that all planes gave the body since then, N s

  Ledger& operator+=(const Ledger& b) {
    mass += b.mass, momentum += b.momentum, kinetic += b.kinetic, elastic += b.elastic, plastic += b.plastic;
    viscous += b.viscous, load_work += b.load_work, work += b.work, wall_loss += b.wall_loss;
    piston_work += b.piston_work, wall_impulse += b.wall_impulse;
    return *this;
  }
  Ledger& operator*=(double s) {
    mass *= s, momentum *= s, kinetic *= s, elastic *= s, plastic *= s;
    viscous *= s, load_work *= s, work *= s, wall_loss *= s, piston_work *= s, wall_impulse *= s;
    return *this;
  }
  /// Of all forms, less what loads and pistons put in, J: constant in an exact computation.
  double energy() const { return kinetic + elastic + plastic + viscous - load_work - piston_work; }
};

/// What the transfers and the wall's start have taken since `start`, J: K(start) - K(now) + work of the forces.
inline double transfer_loss(const Ledger& start, const Ledger& now) {
  return start.kinetic - now.kinetic + (now.work - start.work);
}

/// Change of the sum of all energies since `start`, over the kinetic energy then; nan if that was zero.
inline double energy_error(const Ledger& start, const Ledger& now) {
  return start.kinetic > 0 ? (now.energy() - start.energy()) / start.kinetic : detail::nan;
}

namespace detail {

/// Sums in packs of double, whatever the particles' number type.
template <int D>
struct LedgerSums {
  using P = Pack<double>;
  P mass{0.0}, kinetic{0.0}, elastic{0.0}, plastic{0.0}, viscous{0.0};
  Vec<P, D> momentum = Vec<P, D>::filled(P(0.0));

  LedgerSums& operator+=(const LedgerSums& b) {
    mass += b.mass, kinetic += b.kinetic, elastic += b.elastic, plastic += b.plastic, momentum += b.momentum;
    viscous += b.viscous;
    return *this;
  }
};

inline Pack<double> widened(const Pack<double>& x) { return x; }
inline Pack<double> widened(const Pack<float>& x) {
  return Pack<double>([&](int l) { return double(x[std::size_t(l)]); });
}

inline double total(const Pack<double>& x) {
  double sum = 0;
  for (std::size_t l = 0; l < lanes; ++l) sum += x[l];
  return sum;
}

/// Adds n particles, with velocity, mass and the fields of their material.
template <int D, class Material, class V>
[[gnu::always_inline]] inline void add_to_ledger(LedgerSums<D>& sums, const Material& material, const V& values,
                                                 int n) {
  Pack<double> m = widened(get<field::Mass>(values)), v2(0.0);
  for (int l = n; l < lanes; ++l) m.set(l, 0);  // surplus lanes repeat a particle
  sums.mass += m;
  for (int a = 0; a < D; ++a) {
    const Pack<double> v = widened(get<field::Velocity>(values)[a]);
    sums.momentum[a] += m * v;
    v2 += v * v;
  }
  sums.kinetic += 0.5 * m * v2;
  sums.elastic += m * widened(material.elastic_energy(values));
  if constexpr (carries<V, field::PlasticWork>) sums.plastic += m * widened(get<field::PlasticWork>(values));
  if constexpr (carries<V, field::ViscousWork>) sums.viscous += m * widened(get<field::ViscousWork>(values));
}

/// The ledger from the sums over particles and what the grid knows.
template <class Solver>
Ledger whole_ledger(const Solver& solver, const LedgerSums<Solver::dimension>& sums, int copies) {
  Ledger all;
  all.mass = total(sums.mass), all.kinetic = total(sums.kinetic);
  all.elastic = total(sums.elastic), all.plastic = total(sums.plastic);
  all.viscous = total(sums.viscous);
  const auto& grid = solver.ledger();
  all.load_work = grid.load_work, all.work = grid.work, all.wall_loss = grid.wall_loss;
  all.piston_work = grid.piston_work;
  for (int a = 0; a < Solver::dimension; ++a) {
    all.momentum[a] = total(sums.momentum[a]);
    for (const auto& impulse : grid.impulse) all.wall_impulse[a] += impulse[a];
  }
  return all *= double(copies);
}

}  // namespace detail

/// The ledger of a solver now. `copies`: how many times the whole body holds what is simulated, 4 for a quarter; then
/// only components along the symmetry planes mean something, the others cancel in the whole.
template <class Solver>
Ledger ledger(const Solver& solver, int copies = 1) {
  using T = typename Solver::number;
  using Sums = detail::LedgerSums<Solver::dimension>;
  const auto add = [](Sums& part, const auto& material, const auto& particles, std::size_t first, int n) {
    detail::add_to_ledger(part, material,
                          detail::load_state<T, field::Velocity, field::Mass>(material, particles, first, n), n);
  };
  return detail::whole_ledger(solver, detail::sum_by_chunk<Sums>(solver, add), copies);
}

}  // namespace mote::observe
