/// \file
/// Choices that only change numbers of the default material, the complete energy equation, and conduction.
#include <cmath>

#include "study.hpp"

namespace study {

namespace {

using cavity::Options, cavity::Result, cavity::Voice;

Result run_default(const Options& o, const Extra& x, const Voice& v) {
  return simulate(mote::Material{pressure_law(), flow_law(o), warmth()}, o, x, v);
}
Result run_plastic_norm(const Options& o, const Extra& x, const Voice& v) {
  auto flow = flow_law(o);
  flow.hardening *= std::sqrt(1.5);
  return simulate(mote::Material{pressure_law(), flow, warmth()}, o, x, v);
}
Result run_no_hardening(const Options& o, const Extra& x, const Voice& v) {
  auto flow = flow_law(o);
  flow.hardening = 0;
  return simulate(mote::Material{pressure_law(), flow, warmth()}, o, x, v);
}
Result run_bulk_modulus(const Options& o, const Extra& x, const Voice& v) {
  auto eos = pressure_law();
  eos.c0 = std::sqrt(young / (3 * (1 - 2 * poisson)) / eos.rho0);
  return simulate(mote::Material{eos, flow_law(o), warmth()}, o, x, v);
}
Result run_shear_modulus(const Options& o, const Extra& x, const Voice& v) {
  const auto eos = pressure_law();
  auto flow = flow_law(o);
  flow.shear_modulus = 1.5 * eos.rho0 * eos.c0 * eos.c0 * (1 - 2 * poisson) / (1 + poisson);
  return simulate(mote::Material{eos, flow, warmth()}, o, x, v);
}
Result run_full_energy(const Options& o, const Extra& x, const Voice& v) {
  return simulate(mote::Material{pressure_law(), flow_law(o), warmth(), mote::energy::Full{}}, o, x, v);
}

Result run_conducting(const Options& o, const Extra& x, const Voice& v) {
  const auto heat = warmth();
  return simulate(mote::Material{pressure_law(), flow_law(o),
                                 mote::heat::Conducting{.specific_heat = heat.specific_heat,
                                                        .initial_temperature = heat.initial_temperature,
                                                        .conductivity = 237}},
                  o, x, v);
}

}  // namespace

const std::vector<Choice> choices_numbers{
    {"default", "as the library reads the paper", run_default},
    {"plastic-norm", "hardening by |e_p| instead of sqrt(2/3) |e_p|: H_iso = sqrt(3/2) E_Harden", run_plastic_norm},
    {"no-hardening", "H_iso = 0", run_no_hardening},
    {"bulk-modulus", "K from Young's modulus and Poisson's ratio (67.6 GPa) instead of c0 (77.3 GPa)",
     run_bulk_modulus},
    {"shear-modulus", "G from c0's K and Poisson's ratio (29.6 GPa) instead of Young's modulus (25.9 GPa)",
     run_shear_modulus},
    {"full-energy", "the complete energy equation instead of the plastic work alone", run_full_energy},
    {"conducting", "conduction of heat, 237 W/(m K)", run_conducting}};

}  // namespace study
