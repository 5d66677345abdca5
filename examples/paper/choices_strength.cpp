/// \file
/// Choices of the strength: the kinematic modulus that the paper does not give, and how the flow is integrated.
#include <cmath>

#include "study.hpp"

namespace study {

namespace {

using cavity::Options, cavity::Result, cavity::Voice;

/// The exponential map of Auricchio and Beirao da Veiga with theta times a factor: 1 is right, 1/2 is the misprint that
/// has G where 2G belongs. The radius is that of the step's beginning.
struct MisprintedTheta {
  using role = mote::role::Strength;
  using particle_fields = mote::fields<mote::field::DeviatoricStress, mote::field::PlasticStrain>;

  double shear_modulus, yield, hardening, factor;

  template <class V, class T>
  T update(V& values, const mote::Kinematics<T>& k) const {
    using std::exp, std::max, std::pow, std::sqrt;
    auto& s = mote::get<mote::field::DeviatoricStress>(values);
    auto& eps = mote::get<mote::field::PlasticStrain>(values);
    const double h = 2.0 / 3 * hardening, stiffness = 2 * shear_modulus + h;
    const T limit = T(yield) + T(hardening) * eps, radius = T(std::sqrt(2.0 / 3)) * limit;
    const auto start = mote::rotate(k.rotation, s);
    const auto step = T(2 * shear_modulus) * mote::deviator(k.strain);
    const auto trial = start + step;
    const auto elastic = mote::ddot(trial, trial) <= radius * radius;
    const T a = mote::strength::detail::elastic_fraction(start * (T(1) / radius), step * (T(1) / radius));
    const auto contact = start + a * step, rest = (T(1) - a) * step;
    const T size = max(sqrt(mote::ddot(rest, rest)), T(1e-30));
    const auto n0 = contact * (T(1) / max(sqrt(mote::ddot(contact, contact)), T(1e-30))), e = rest * (T(1) / size);
    const T c = max(mote::ddot(n0, e), T(0)), theta = T(factor) * size / radius;
    const T up = exp(theta), big = T(0.5) * (up + T(1) / up), small = up - big, x = big + small * c;  // cosh and sinh
    const T end = radius * pow(x, mote::Scalar<T>(h / stiffness));  // the radius grows by X0^((2/3) H_iso/k)
    const T rise = T(std::sqrt(2.0 / 3) / std::max(h, 1e-30)) * (end - radius);
    const auto flowed = (n0 + ((big - T(1)) * c + small) * e) * (end / x);
    for (int i = 0; i < 6; ++i) s.c[i] = mote::select(elastic, trial.c[i], flowed.c[i]);
    const T risen = mote::select(elastic, T(0), rise);
    eps += risen;
    return (limit + T(0.5 * hardening) * risen) * risen;
  }
  friend bool operator==(const MisprintedTheta&, const MisprintedTheta&) = default;
};

Result mixed(const Options& o, const Extra& x, const Voice& v, double isotropic, double kinematic) {
  const auto flow = flow_law(o);
  const mote::strength::VonMisesMixed both{.shear_modulus = flow.shear_modulus,
                                           .yield = flow.yield,
                                           .hardening = isotropic * flow.hardening,
                                           .kinematic_hardening = kinematic * flow.hardening};
  return simulate(mote::Material{pressure_law(), both, warmth()}, o, x, v);
}
Result run_kinematic(const Options& o, const Extra& x, const Voice& v) { return mixed(o, x, v, 0, 1); }
Result run_both(const Options& o, const Extra& x, const Voice& v) { return mixed(o, x, v, 1, 1); }

Result run_exponential(const Options& o, const Extra& x, const Voice& v) {
  const auto flow = flow_law(o);
  const mote::strength::VonMisesExponential map{
      .shear_modulus = flow.shear_modulus, .yield = flow.yield, .hardening = flow.hardening};
  return simulate(mote::Material{pressure_law(), map, warmth()}, o, x, v);
}
Result misprinted(const Options& o, const Extra& x, const Voice& v, double factor) {
  const auto flow = flow_law(o);
  return simulate(
      mote::Material{
          pressure_law(),
          MisprintedTheta{
              .shear_modulus = flow.shear_modulus, .yield = flow.yield, .hardening = flow.hardening, .factor = factor},
          warmth()},
      o, x, v);
}
Result run_theta(const Options& o, const Extra& x, const Voice& v) { return misprinted(o, x, v, 1); }
Result run_half_theta(const Options& o, const Extra& x, const Voice& v) { return misprinted(o, x, v, 0.5); }

}  // namespace

const std::vector<Choice> choices_strength{
    {"kinematic", "all hardening kinematic: H_kin = E_Harden, H_iso = 0", run_kinematic},
    {"kinematic-too", "kinematic hardening beside the isotropic: H_kin = H_iso = E_Harden", run_both},
    {"exponential-map", "the exponential map instead of the radial return", run_exponential},
    {"theta", "the exponential map by the paper's formula, with the right theta", run_theta},
    {"theta-half", "the same with theta half as large (G in the place of 2G)", run_half_theta}};

}  // namespace study
