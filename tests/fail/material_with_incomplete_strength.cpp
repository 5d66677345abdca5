// expect: mote: the strength lacks a member; strength/concept.hpp lists them
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>
#include <mote/strength/elastic.hpp>

const mote::eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};

struct Incomplete {  // no update()
  using role = mote::role::Strength;
  double shear_modulus = 80e9;
};

#ifdef MOTE_FAIL
const mote::Material steel{bulk, Incomplete{}};
#else
const mote::Material steel{bulk, mote::strength::Elastic{.shear_modulus = 80e9}};
#endif
