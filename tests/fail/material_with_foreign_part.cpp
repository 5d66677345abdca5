// expect: mote: a material takes an equation of state, a strength, a heat policy, a viscosity and an energy closure only
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>

const mote::eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};

struct Shape {  // a part, but of a solver
  using role = mote::role::Shape;
};

#ifdef MOTE_FAIL
const mote::Material steel{bulk, Shape{}};
#else
const mote::Material steel{bulk};
#endif
