// expect: mote: a material takes at most one strength
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>
#include <mote/strength/elastic.hpp>
#include <mote/strength/von_mises.hpp>

const mote::eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};
const mote::strength::VonMises plastic{.shear_modulus = 80e9, .yield = 250e6};

#ifdef MOTE_FAIL
const mote::Material steel{bulk, plastic, mote::strength::Elastic{.shear_modulus = 80e9}};
#else
const mote::Material steel{bulk, plastic};
#endif
