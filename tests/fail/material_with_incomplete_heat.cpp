// expect: mote: the heat policy lacks a member; heat/concept.hpp lists them
#include <mote/eos/linear_bulk.hpp>
#include <mote/heat/adiabatic.hpp>
#include <mote/material.hpp>

const mote::eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};

struct Incomplete {  // no update()
  using role = mote::role::Heat;
};

#ifdef MOTE_FAIL
const mote::Material steel{bulk, Incomplete{}};
#else
const mote::Material steel{bulk, mote::heat::Adiabatic{.specific_heat = 460}};
#endif
