/// \file
/// verify::eos: what the library has passes, and each check fails on an equation that is wrong in that alone.
#include <mote/verify/eos.hpp>

#include <mote/eos/constant_gamma.hpp>
#include <mote/eos/ideal_gas.hpp>
#include <mote/eos/linear_bulk.hpp>
#include <mote/eos/logarithmic_bulk.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/eos/tension_cutoff.hpp>
#include <sstream>

#include "fails.hpp"

namespace {

using namespace mote;

const eos::MieGruneisen aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};

enum class Fault { none, admissible, jump, energy, sound, isentropic, gamma, internal, packs };

/// eos::LinearBulk with one mistake.
struct Faulty {
  using role = mote::role::Eos;
  Fault fault;
  double rho0 = 1000, k = 1e9;

  double off(Fault f) const { return fault == f ? 1.01 : 1; }
  /// Of the pressure at x = 1.1, Pa.
  double jump() const { return fault == Fault::jump ? 1e-3 * k : 0; }

  template <class T>
  T pressure(const T& x, const T&) const {
    const T p = T(k) * (T(1) - x) - select(x > T(1.1), T(jump()), T(0));
    return is_pack<T> ? T(T(off(Fault::packs)) * p) : p;
  }
  template <class T>
  T work(const T& x) const {
    using std::max;
    return T(0.5 * k / rho0) * (T(1) - x) * (T(1) - x) + T(jump() / rho0) * max(T(x - T(1.1)), T(0));
  }
  template <class T>
  T bulk_sound_speed2(const T& x, const T&) const {
    return T(off(Fault::sound) * k / rho0) * x * x;
  }
  template <class T>
  T isentropic_sound_speed2(const T& x, const T&) const {
    return T(off(Fault::isentropic) * k / rho0) * x * x;
  }
  template <class T>
  T reference_energy(const T& x) const {
    return T(off(Fault::energy)) * work(x);
  }
  template <class T>
  T internal_energy(const T& x) const {
    return T(off(Fault::internal)) * work(x);
  }
  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  double gamma_over_volume() const { return fault == Fault::gamma ? 1 : 0; }
  template <class T>
  auto admissible(const T& x) const {
    return x > T(fault == Fault::admissible ? -10 : 0);
  }
};

void fails(Fault fault, const char* check) { verdict::fails(verify::eos(Faulty{fault}), {check}); }

}  // namespace

TEST_CASE("verify::eos passes all equations of state of the library", "[verify]") {
  verdict::passes(verify::eos(aluminium));
  verdict::passes(verify::eos(eos::MieGruneisen{.rho0 = 8930, .c0 = 3940, .lambda = 1.489, .gamma0 = 2}));
  verdict::passes(verify::eos(eos::MieGruneisen{.rho0 = 1000, .c0 = 1500}));
  verdict::passes(verify::eos(eos::ConstantGamma{aluminium}));
  verdict::passes(verify::eos(eos::TensionCutoff{aluminium, {.limit = 1.2e9}}));
  verdict::passes(verify::eos(eos::IdealGas{.rho0 = 1.2, .gamma = 1.4, .initial_pressure = 1e5}));
  verdict::passes(verify::eos(eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 1e9}));
  verdict::passes(verify::eos(eos::LogarithmicBulk{.rho0 = 1000, .bulk_modulus = 1e9}, {.to = 2.5}));
  verdict::passes(verify::eos(eos::LogarithmicBulk{.rho0 = 1000}));
  verdict::passes(verify::eos(Faulty{Fault::none}));
}

TEST_CASE("verify::eos: each check fails on its own mistake", "[verify]") {
  fails(Fault::admissible, "admissible range");
  fails(Fault::jump, "pressure is continuous");
  fails(Fault::energy, "reference energy is the work -int P dV");
  fails(Fault::sound, "sound speed is that of the pressure");
  fails(Fault::isentropic, "isentropic sound speed is that of the pressure");
  fails(Fault::gamma, "gamma/V is dP/dE");
  fails(Fault::internal, "internal energy is heat less work");
  fails(Fault::packs, "packs are numbers, lane by lane");
}

TEST_CASE("verify: a report says where, and can be streamed", "[verify]") {
  const auto report = verify::eos(Faulty{Fault::sound});
  std::ostringstream out;
  out << report;
  CHECK(out.str() == report.text());
  CHECK(out.str().find("verify::eos: FAILED\n") == 0);
  CHECK(out.str().find("V/V0 = ") != std::string::npos);
  CHECK(report.rows.size() == 8);
  CHECK_THROWS_AS(verify::eos(aluminium, {.from = 2}), InputError);

  verify::detail::Worst worst;
  CHECK(!worst.row("nothing seen").passed);
  worst.see(0, 1, [] { return "fine"; });
  CHECK(worst.row("fine").passed);
  worst.see(std::nan(""), 1, [] { return "not a number"; });
  worst.see(2, 1, [] { return "above"; });
  CHECK(!worst.row("bad").passed);
  CHECK(worst.row("bad").where == "not a number");
}
