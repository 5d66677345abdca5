/// \file
/// Choices of the equation of state.
#include "study.hpp"

namespace study {

namespace {

using cavity::Options, cavity::Result, cavity::Voice;

/// Mie-Grueneisen with another curve in tension, x > 1. Its energies stay those of the library's curve: the ledger
/// only.
template <class Tension>
struct Stretched : mote::eos::MieGruneisen {
  Stretched() : MieGruneisen(pressure_law()) {}

  template <class T>
  T pressure(const T& x, const T& excess) const {
    return mote::select(x > T(1), Tension::pressure(*this, x), hugoniot_pressure(x)) + T(gamma0 * rho0) * excess;
  }
  template <class T>
  T bulk_sound_speed2(const T& x, const T& excess) const {
    return mote::select(x > T(1), Tension::sound2(*this, x), MieGruneisen::bulk_sound_speed2(x, excess));
  }
  friend bool operator==(const Stretched&, const Stretched&) = default;
};

/// P_H = rho0 c0^2 (x - 1), as printed. Stretched metal then pushes, and has no speed of sound; that of the time step
/// is taken of the slope's size.
struct AsPrinted {
  template <class T>
  static T pressure(const mote::eos::MieGruneisen& e, const T& x) {
    return T(e.rho0 * e.c0 * e.c0) * (x - T(1));
  }
  template <class T>
  static T sound2(const mote::eos::MieGruneisen& e, const T& x) {
    return T(e.c0 * e.c0) * x * x;
  }
};

/// The Hugoniot's own formula carried on into tension: q/(1 - lambda q)^2 with q = 1 - x < 0.
struct Hugoniot {
  template <class T>
  static T pressure(const mote::eos::MieGruneisen& e, const T& x) {
    const T q = T(1) - x, d = T(1) - T(e.lambda) * q;
    return T(e.rho0 * e.c0 * e.c0) * q / (d * d);
  }
  template <class T>
  static T sound2(const mote::eos::MieGruneisen& e, const T& x) {
    const T lq = T(e.lambda) * (T(1) - x), d = T(1) - lq;
    return T(e.c0 * e.c0) * x * x * (T(1) + lq) / (d * d * d);
  }
};

static_assert(mote::Eos<Stretched<AsPrinted>> && mote::Eos<Stretched<Hugoniot>>);

Result run_printed(const Options& o, const Extra& x, const Voice& v) {
  return simulate(mote::Material{Stretched<AsPrinted>{}, flow_law(o), warmth()}, o, x, v);
}
Result run_hugoniot(const Options& o, const Extra& x, const Voice& v) {
  return simulate(mote::Material{Stretched<Hugoniot>{}, flow_law(o), warmth()}, o, x, v);
}
Result run_gamma(const Options& o, const Extra& x, const Voice& v) {
  return simulate(mote::Material{mote::eos::ConstantGamma{pressure_law()}, flow_law(o), warmth()}, o, x, v);
}
Result run_spall(const Options& o, const Extra& x, const Voice& v) {
  return simulate(mote::Material{mote::eos::TensionCutoff{pressure_law(), {.limit = 1.2e9}}, flow_law(o), warmth()}, o,
                  x, v);
}

}  // namespace

const std::vector<Choice> choices_eos{
    {"tension-printed", "P_H = rho0 c0^2 (x - 1) in tension, as printed", run_printed},
    {"tension-hugoniot", "the Hugoniot's formula in tension too, instead of a straight line", run_hugoniot},
    {"gamma-constant", "gamma constant instead of gamma/V", run_gamma},
    {"spall", "no tension beyond 1.2 GPa", run_spall}};

}  // namespace study
