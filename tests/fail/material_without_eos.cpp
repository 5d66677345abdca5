// expect: mote: a material needs exactly one equation of state
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>
#include <mote/strength/elastic.hpp>

#ifdef MOTE_FAIL
const mote::Material steel{mote::strength::Elastic{.shear_modulus = 80e9}};
#else
const mote::Material steel{mote::eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9},
                           mote::strength::Elastic{.shear_modulus = 80e9}};
#endif
