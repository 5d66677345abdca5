// expect: mote: the complete energy equation needs an equation of state with internal_energy(x)
#include <mote/energy/full.hpp>
#include <mote/eos/linear_bulk.hpp>
#include <mote/material.hpp>

struct Linear {  // complete but for internal_energy(x)
  using role = mote::role::Eos;
  double rho0 = 7800;
  // clang-format off
  template <class T> T pressure(const T& x, const T&) const { return T(160e9) * (T(1) - x); }
  template <class T> T bulk_sound_speed2(const T& x, const T&) const { return T(2e7) * x * x; }
  template <class T> T reference_energy(const T& x) const { return T(1e7) * (T(1) - x) * (T(1) - x); }
  template <class T> T reference_heating(const T&) const { return T(0); }
  template <class T> auto admissible(const T& x) const { return x > T(0); }
  // clang-format on
  double gamma_over_volume() const { return 0; }
};

const mote::Material paper{Linear{}};
#ifdef MOTE_FAIL
const mote::Material steel{Linear{}, mote::energy::Full{}};
#else
const mote::Material steel{mote::eos::LinearBulk{.rho0 = 7800, .bulk_modulus = 160e9}, mote::energy::Full{}};
#endif
