/// \file
/// verify::material: what the library has passes, and each check fails on a strength or a viscosity that is wrong in
/// that alone.
#include <mote/verify/material.hpp>

#include <mote/energy/full.hpp>
#include <mote/eos/constant_gamma.hpp>
#include <mote/eos/ideal_gas.hpp>
#include <mote/eos/logarithmic_bulk.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/eos/tension_cutoff.hpp>
#include <mote/heat/conducting.hpp>
#include <mote/strength/elastic.hpp>
#include <mote/strength/neo_hookean.hpp>
#include <mote/strength/von_mises.hpp>
#include <mote/strength/von_mises_exponential.hpp>
#include <mote/strength/von_mises_logarithmic.hpp>
#include <mote/strength/von_mises_mixed.hpp>
#include <mote/strength/von_mises_mixed_exponential.hpp>
#include <mote/viscosity/von_neumann.hpp>

#include "fails.hpp"

namespace {

using namespace mote;

const eos::MieGruneisen eos_of_aluminium{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
const heat::Adiabatic warm{.specific_heat = 880, .initial_temperature = 300};
constexpr double G = 25.94e9, Y = 120e6, H = 384e6;

enum class Fault {
  none,
  no_rotation,
  outside,
  relaxing,
  gaining,
  brittle,
  fast_at_rest,
  slow,
  energy,
  softer_back,
  half_work,
  packs,
  nan
};

/// strength::VonMises with one mistake.
struct Faulty {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress, field::PlasticStrain, field::VolumeRatio>;
  Fault fault;
  double shear_modulus = G;

  strength::LinearHardening law() const { return {fault == Fault::outside ? 1.001 * Y : Y, H}; }

  /// What it claims; the elastic ones claim nothing.
  template <class V>
  double yield_stress(const V& values) const {
    if (fault == Fault::relaxing || fault == Fault::gaining) return 1e300;
    return Y + H * get<field::PlasticStrain>(values);
  }
  template <class T>
  static T magnitude(const SymTensor<T>& s) {
    using std::sqrt;
    return sqrt(ddot(s, s));
  }

  template <class V, class T>
  T update(V& values, const Kinematics<T>& k) const {
    auto& s = get<field::DeviatoricStress>(values);
    const SymTensor<T> before = fault == Fault::no_rotation ? s : rotate(k.rotation, s);
    SymTensor<T> rise = T(2 * shear_modulus) * deviator(k.strain);
    if (fault == Fault::packs && is_pack<T>) rise = rise * T(1.001);
    if (fault == Fault::relaxing || fault == Fault::gaining) return flow_without_yield(s, before, rise);
    if (fault == Fault::softer_back) {  // the part along s, where it unloads
      using std::min;
      rise = rise - before * (T(0.1) * min(ddot(before, rise), T(0)) / (ddot(before, before) + T(1)));
    }
    s = before + rise;
    if (fault == Fault::brittle) return snap(s);
    if (fault == Fault::nan) s.c[3] = T(std::nan(""));
    auto& eps = get<field::PlasticStrain>(values);
    const auto flow = strength::radial_return(s, eps, shear_modulus, law());
    s = s * (T(1) - T(3 * shear_modulus) * flow.rise / flow.equivalent);
    eps += flow.rise;
    return fault == Fault::half_work ? T(T(0.5) * flow.dissipated) : flow.dissipated;
  }

  /// Relaxing: a tenth of the stress goes with each call, as heat. Gaining: strain makes it flow against the stress.
  template <class T>
  T flow_without_yield(SymTensor<T>& s, const SymTensor<T>& before, const SymTensor<T>& rise) const {
    if (fault == Fault::relaxing) {
      s = T(0.9) * before + rise;
      return T(0.19 / (4 * shear_modulus)) * ddot(before, before);
    }
    const SymTensor<T> trial = before + rise;
    const SymTensor<T> gain = trial * (T(0.1) * magnitude(rise) / (magnitude(trial) + T(1e8)));
    s = trial + gain;
    return T(-0.25 / shear_modulus) * ddot(before + s, gain);
  }
  /// Falls to half of the yield stress at once.
  template <class T>
  T snap(SymTensor<T>& s) const {
    using std::max;
    const T equivalent = max(T(std::sqrt(1.5)) * magnitude(s), T(1e-30)), was = ddot(s, s);
    s = s * select(equivalent > T(Y), T(T(0.5 * Y) / equivalent), T(1));
    return T(0.25 / shear_modulus) * (was - ddot(s, s));
  }

  template <class V>
  auto elastic_energy(const V& values) const {
    using T = typename V::number;
    const auto& s = get<field::DeviatoricStress>(values);
    const T e = T(0.25 / shear_modulus) * ddot(s, s) * get<field::VolumeRatio>(values);
    return T(e * select(get<field::PlasticStrain>(values) > T(0), T(1), T(fault == Fault::energy ? 1.1 : 1)));
  }
  template <class V, class T>
  T wave_modulus(const V& values, const T& bulk) const {
    const T size = magnitude(get<field::DeviatoricStress>(values)), part = size / (size + T(1e8));
    T shear = T(4.0 / 3 * shear_modulus) * get<field::VolumeRatio>(values);
    if (fault == Fault::fast_at_rest) shear *= T(1.01);
    if (fault == Fault::slow) shear *= T(1) - T(0.1) * part;
    if (fault == Fault::gaining) shear += T(0.2 * shear_modulus) * part;
    return bulk + shear;
  }
};

/// viscosity::VonNeumann with one mistake.
struct FaultyViscosity {
  using role = mote::role::Viscosity;
  bool in_expansion, slow;

  template <class T>
  T pressure(const T& rho, const T& c, const T& u) const {
    using std::abs, std::max;
    const T closing = in_expansion ? abs(u) : max(u, T(0));
    return rho * closing * (T(0.2) * c + T(2) * closing);
  }
  template <class T>
  T signal_speed2(const T&, const T& c2, const T&) const {
    return c2 * T(slow ? 0.99 : 1.5);
  }
};

void fails(Fault fault, const char* check) {
  verdict::fails(verify::material(Material{eos_of_aluminium, Faulty{fault}}), {check});
}

}  // namespace

TEST_CASE("verify::material passes all strengths of the library", "[verify]") {
  const auto passes = [](const auto& strength) {
    verdict::passes(verify::material(Material{eos_of_aluminium, strength, warm}));
  };
  verdict::passes(verify::material(Material{eos_of_aluminium}));
  verdict::passes(verify::material(Material{eos_of_aluminium, strength::Elastic{G}}));
  passes(strength::VonMises{.shear_modulus = G, .yield = Y, .hardening = H});
  passes(strength::VonMisesMixed{.shear_modulus = G, .yield = Y, .hardening = H, .kinematic_hardening = 5e9});
  passes(strength::VonMisesExponential{.shear_modulus = G, .yield = Y, .hardening = H});
  passes(
      strength::VonMisesMixedExponential{.shear_modulus = G, .yield = Y, .hardening = H, .kinematic_hardening = 5e9});
  passes(strength::VonMisesLogarithmic{.shear_modulus = G, .yield = Y, .hardening = H});
  verdict::passes(verify::material(
      Material{eos::LogarithmicBulk{.rho0 = 1000, .bulk_modulus = 1e9}, strength::NeoHookean{.shear_modulus = 1e9}}));
  verdict::passes(verify::material(Material{eos_of_aluminium, Faulty{Fault::none}}));
}

TEST_CASE("verify::material passes hot, viscous and complete materials", "[verify]") {
  const strength::VonMises metal{.shear_modulus = G, .yield = Y, .hardening = H};
  const viscosity::VonNeumann viscous{};
  const heat::Conducting conducting{.specific_heat = 880, .conductivity = 237};
  verdict::passes(verify::material(Material{eos_of_aluminium, warm}));
  verdict::passes(verify::material(Material{eos::ConstantGamma{eos_of_aluminium}, metal, energy::Full{}, conducting}));
  verdict::passes(verify::material(Material{eos_of_aluminium, metal, energy::Full{}, viscous, warm}));
  verdict::passes(verify::material(Material{eos::TensionCutoff{eos_of_aluminium, {.limit = 1.2e9}}, metal, warm}));
  verdict::passes(verify::material(
      Material{eos::IdealGas{.rho0 = 1.2, .gamma = 1.4, .initial_pressure = 1e5}, energy::Full{}, viscous}));
}

TEST_CASE("verify::material: each check fails on its own mistake", "[verify]") {
  fails(Fault::no_rotation, "objectivity");
  fails(Fault::relaxing, "an increment of nothing changes nothing");
  fails(Fault::outside, "yield surface is respected");
  fails(Fault::gaining, "plastic work does not fall");
  fails(Fault::brittle, "stress is continuous in the increment");
  fails(Fault::fast_at_rest, "sound speed at rest is that of the stress");
  fails(Fault::slow, "no wave is faster than the sound speed");
  fails(Fault::energy, "work is elastic energy on straight paths");
  fails(Fault::softer_back, "work is elastic energy on closed paths");
  fails(Fault::half_work, "work of flow is elastic and plastic");
  fails(Fault::packs, "packs are numbers, lane by lane");

  const auto broken = verify::material(Material{eos_of_aluminium, Faulty{Fault::nan}}).failures();
  CHECK(broken.size() >= 9);  // what is not a number is nowhere taken for small

  const auto viscous = [](bool in_expansion, bool slow) {
    return verify::material(Material{eos_of_aluminium, FaultyViscosity{in_expansion, slow}});
  };
  verdict::passes(viscous(false, false));
  verdict::fails(viscous(true, false), {"viscous pressure only resists compression"});
  verdict::fails(viscous(false, true), {"signal speed is not below that of sound"});
}
