// expect: mote: the equation of state lacks a member; eos/concept.hpp lists them
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>

struct Incomplete {  // a pressure alone
  using role = mote::role::Eos;
  double rho0 = 7800;
  template <class T>
  T pressure(const T& x, const T&) const {
    return T(160e9) * (T(1) - x);
  }
};

#ifdef MOTE_FAIL
const mote::Material steel{Incomplete{}};
#else
const mote::Material steel{mote::eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}};
#endif
