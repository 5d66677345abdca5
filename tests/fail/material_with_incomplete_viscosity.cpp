// expect: mote: the viscosity lacks a member; viscosity/concept.hpp lists them
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>
#include <mote/viscosity/von_neumann.hpp>

const mote::eos::LinearBulk bulk{.rho0 = 7800, .bulk_modulus = 160e9};

struct Incomplete {  // no signal_speed2()
  using role = mote::role::Viscosity;
  template <class T>
  T pressure(const T& rho, const T& c, const T& u) const {
    return rho * c * u;
  }
};

#ifdef MOTE_FAIL
const mote::Material steel{bulk, Incomplete{}};
#else
const mote::Material steel{bulk, mote::viscosity::VonNeumann{}};
#endif
