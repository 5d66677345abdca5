// expect: mote: a material with a viscosity needs to know the step
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>
#include <mote/viscosity/von_neumann.hpp>

const mote::Material steel{mote::eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9},
                           mote::viscosity::VonNeumann{.linear = 0.2, .quadratic = 2}};

double pressure(const mote::Mat<double, 3>& increment) {
  auto state = steel.initial<double>();
#ifdef MOTE_FAIL
  steel.update(state, increment);
#else
  steel.update(state, increment, {.dt = 1e-9, .spacing = 1e-5});
#endif
  return steel.pressure(state);
}
