/// \file
/// Exponential map: the plastic update of a von Mises metal that follows the rate equations along the increment.
#pragma once

#include <mote/strength/hardening.hpp>

namespace mote::strength {

/// The state s - alpha at the end of an increment, and what flowed on the way.
template <class T>
struct ExponentialMap {
  SymTensor<T> relative;        ///< s - alpha, Pa
  SymTensor<T> plastic_strain;  ///< increment of e_p
  T rise;                       ///< of the equivalent plastic strain
  T dissipated;                 ///< J/m^3 of current volume
};

namespace detail {

/// The part of an increment `step` that stays inside the unit ball: the larger a with |start + a step| = 1, in [0, 1].
template <class T>
T elastic_fraction(const SymTensor<T>& start, const SymTensor<T>& step) {
  using std::max;
  using std::min;
  using std::sqrt;
  const T a = max(ddot(step, step), T(1e-30)), b = ddot(start, step);
  // a start outside by round-off is one on the surface
  const T c = min(ddot(start, start) - T(1), T(0));
  const T root = sqrt(b * b - a * c);
  // two forms of the same root, each without cancellation on its side
  const T fraction = select(b > T(0), T(-c / max(root + b, T(1e-30))), T((root - b) / a));
  return min(max(fraction, T(0)), T(1));
}

}  // namespace detail

/// One increment of deviatoric strain, `strain`, from the state `start` = s - alpha.
///
/// With radius R = sqrt(2/3) (Y + H_iso eps_p), n = (s - alpha)/R, k = 2G + (2/3)(H_iso + H_kin) the rate equations are
///
///   R n' = 2G (e' - (n : e') n),   R' = (2/3) H_iso gamma',   gamma' = |e_p'| = 2G (n : e')/k.
///
/// n = N/X turns the first into the linear pair X' = (2G/R) N : e', N' = (2G/R) X e', whose solution for constant e'
/// and R is cosh and sinh; the exact relation d ln R = (2/3)(H_iso/k) d ln X then moves the radius. Before that, the
/// part of the increment that is elastic is cut off. It is exact for straight increments without isotropic hardening;
/// with it R in 2G/R is taken at mid-step (by half a radial return), which makes it second order. It ends on the yield
/// surface. All is divided by exp(theta), so that large increments do not overflow. Source: Auricchio and Beirao da
/// Veiga, IJNME 56 (2003) 1375.
template <class T>
ExponentialMap<T> exponential_map(const SymTensor<T>& start, const SymTensor<T>& strain, const T& plastic_strain,
                                  double shear_modulus, const LinearHardening& law) {
  using std::exp;
  using std::expm1;
  using std::log;
  using std::log1p;
  using std::max;
  using std::sqrt;
  const double g2 = 2 * shear_modulus, rigid = g2 + law.kinematic * (2.0 / 3), h = law.isotropic * (2.0 / 3),
               k = rigid + h;
  const T limit = law.yield_stress(plastic_strain), radius = T(std::sqrt(2.0 / 3)) * limit;
  const SymTensor<T> step = T(g2) * strain, trial = start + step;
  const auto elastic = ddot(trial, trial) <= radius * radius;
  ExponentialMap<T> out{trial, {}, T(0), T(0)};
  for (auto& c : out.plastic_strain.c) c = T(0);
  if (all_of(elastic)) return out;

  const T a = detail::elastic_fraction(start * (T(1) / radius), step * (T(1) / radius));
  const SymTensor<T> contact = start + a * step, rest = (T(1) - a) * step;
  const T size = max(sqrt(ddot(rest, rest)), T(1e-30));
  const SymTensor<T> n0 = contact * (T(1) / max(sqrt(ddot(contact, contact)), T(1e-30))), e = rest * (T(1) / size);
  const T c = max(ddot(n0, e), T(0));  // outward: the flow begins where the path leaves the elastic ball

  T theta = size / radius;
  if (law.isotropic > 0) {
    // over the mean radius: the logarithmic one between its start and where a radial return would end
    const T back = sqrt(radius * radius + T(2) * radius * size * c + size * size);  // |radius n0 + rest|
    const T growth = max(T(h / k) * (back - radius) / radius, T(1e-30));
    theta = theta * log1p(growth) / growth;
  }
  const T q = exp(-theta), q2 = q * q;
  const T x = T(0.5) * ((T(1) + c) + (T(1) - c) * q2);  // X exp(-theta), in [1/2, 1]
  const T log_x = max(theta + log(x), T(0));
  const T of_e = T(0.5) * ((T(1) - q2) + c * (T(1) - q) * (T(1) - q));
  // gamma = int R d(ln X)/k with R = radius X^(h/k)
  const T gamma = law.isotropic > 0 ? T(radius * expm1(T(h / k) * log_x) * T(1 / h)) : T(radius * log_x * T(1 / k));
  const SymTensor<T> end = (n0 * q + e * of_e) * ((radius + T(h) * gamma) / x);
  const SymTensor<T> flowed = (rest - (end - contact)) * T(1 / rigid);

  out.rise = select(elastic, T(0), T(T(std::sqrt(2.0 / 3)) * gamma));
  out.dissipated = law.dissipation(limit, out.rise);
  for (int i = 0; i < 6; ++i) {
    out.relative.c[i] = select(elastic, trial.c[i], end.c[i]);
    out.plastic_strain.c[i] = select(elastic, T(0), flowed.c[i]);
  }
  return out;
}

}  // namespace mote::strength
