/// \file
/// Mie-Grueneisen equation of state on the shock Hugoniot U_s = c0 + lambda u_p.
#pragma once

#include <mote/eos/concept.hpp>

namespace mote::eos {

/// P = P_H(x) + (gamma/V) (E - E_H), with gamma/V constant (eos::ConstantGamma: gamma constant), x = V/V0, q = 1 - x:
///
///   compression, x <= 1:  P_H = rho0 c0^2 q / (1 - lambda q)^2,   pole at x = 1 - 1/lambda
///   tension,     x >  1:  P_H = rho0 c0^2 q                        (negative; the paper's `x - 1` is a misprint)
///
/// The energy `excess` = E - E_H comes from the material's closure (energy/); in Xu et al. it is the plastic work.
/// P_H and its first derivative are continuous at x = 1.
/// Source: Xu, Zhang, Ying, Yu, equations for the Hugoniot pressure; Wilkins, Computer Simulation of Dynamic
/// Phenomena (1999), ch. 3.
struct MieGruneisen {
  using role = mote::role::Eos;

  double rho0;        ///< reference density, kg/m^3, > 0
  double c0;          ///< bulk sound speed at rest, m/s, > 0
  double lambda = 0;  ///< slope of the shock speed over the particle speed, >= 0
  double gamma0 = 0;  ///< Grueneisen coefficient at V0, >= 0

  void validate() const {
    require(rho0 > 0, "the density rho0 is ", rho0, " kg/m^3; it must be > 0");
    require(c0 > 0, "the sound speed c0 is ", c0, " m/s; it must be > 0");
    require(lambda >= 0, "the Hugoniot slope lambda is ", lambda, "; it must be >= 0");
    require(gamma0 >= 0, "the Grueneisen coefficient gamma0 is ", gamma0, "; it must be >= 0");
  }

  /// P_H, Pa.
  template <class T>
  T hugoniot_pressure(const T& x) const {
    const T q = T(1) - x;
    const T d = T(1) - T(lambda) * compression(q);
    return T(rho0 * c0 * c0) * q / (d * d);
  }

  /// P, Pa, from x and the specific energy above the reference curve, J/kg.
  template <class T>
  T pressure(const T& x, const T& excess) const {
    return hugoniot_pressure(x) + T(gamma0 * rho0) * excess;
  }

  /// -V^2 dP/dV at fixed excess energy, m^2/s^2.
  template <class T>
  T bulk_sound_speed2(const T& x, const T&) const {
    const T q = T(1) - x;
    const T lq = T(lambda) * compression(q);
    const T d = T(1) - lq;
    // d/dq [q/(1 - l q)^2] = (1 + l q)/(1 - l q)^3 and V^2 dP/dV = (x^2/rho0) dP/dx
    return T(c0 * c0) * x * x * (T(1) + lq) / (d * d * d);
  }

  /// int P_H V0 dq, J/kg.
  template <class T>
  T reference_energy(const T& x) const {
    using std::log;
    const T q = T(1) - x;
    const T tension = T(0.5 * c0 * c0) * q * q;
    if (lambda == 0) return tension;
    // int q/(1 - l q)^2 dq = [1/(1 - l q) + log(1 - l q) - 1] / l^2, which cancels badly for small l q (with an error
    // of round-off/(l q)^2): there its series, sum 2 k/(k + 1) (l q)^(k - 1), to 1e-13, or 1e-7 in single precision
    const double seam = sizeof(Scalar<T>) < sizeof(double) ? 0.1 : 0.02;
    const T lq = T(lambda) * compression(q);
    const T d = T(1) - lq;
    const T closed = T(c0 * c0 / (lambda * lambda)) * (T(1) / d + log(d) - T(1));
    T series = T(16.0 / 9);
    for (int k = 7; k > 0; --k) series = series * lq + T(2.0 * k / (k + 1));
    return select(lq > T(seam), closed, tension * series);
  }

  /// Heat of the shock along the Hugoniot per unit of x, J/kg: -c0^2 lambda q^2/(1 - lambda q)^3, zero in tension.
  ///
  /// It is d(E_H)/dx + P_H V0 with E_H = P_H (V0 - V)/2: what the shock leaves behind as heat.
  template <class T>
  T reference_heating(const T& x) const {
    const T q = compression(T(1) - x);
    const T d = T(1) - T(lambda) * q;
    return T(-c0 * c0 * lambda) * q * q / (d * d * d);
  }

  /// E_H = P_H (V0 - V)/2, J/kg, the Rankine-Hugoniot energy; in tension, where P_H is linear, that of the isentrope.
  template <class T>
  T internal_energy(const T& x) const {
    return T(0.5 / rho0) * hugoniot_pressure(x) * (T(1) - x);
  }

  double gamma_over_volume() const { return gamma0; }

  /// The equation covers every x above the pole of the Hugoniot (and above zero).
  template <class T>
  auto admissible(const T& x) const {
    return x > T(smallest_x());
  }
  double smallest_x() const { return lambda > 1 ? 1 - 1 / lambda : 0; }

 private:
  template <class T>
  static T compression(const T& q) {
    using std::max;
    return max(q, T(0));
  }

  friend bool operator==(const MieGruneisen&, const MieGruneisen&) = default;
};

}  // namespace mote::eos
