/// \file
/// The shock Hugoniot of a metal without strength, with the temperature along it.
#pragma once

#include <cmath>
#include <limits>

#include <mote/core/error.hpp>
#include <mote/eos/mie_gruneisen.hpp>
#include <mote/exact/numerics.hpp>
#include <mote/heat/adiabatic.hpp>

namespace mote::exact {

/// What one shock leaves behind in metal that was at rest, unstressed and at the initial temperature.
struct ShockState {
  double particle_speed;  ///< u_p, m/s: the jump of velocity
  double shock_speed;     ///< U_s, m/s, seen from the metal ahead
  double x;               ///< V/V0
  double density;         ///< kg/m^3
  double pressure;        ///< P_H, Pa
  double energy;          ///< E_H = P_H (V0 - V)/2 = u_p^2/2 above that at rest, J/kg
  double temperature;     ///< K; nan without heat
};

/// U_s = c0 + lambda u_p with the jumps of mass, momentum and energy, q = 1 - x = u_p/U_s:
///
///     P_H = rho0 U_s u_p = rho0 c0^2 q/(1 - lambda q)^2,     E_H = u_p^2/2.
///
/// Along the curve cv dT = dE_H + P_H dV - cv (gamma/V) T dV, the heat of the shock less the work on the thermal
/// pressure:
///
///     dT/dx = h(x)/cv - (V0 gamma/V) T,   h = -c0^2 lambda q^2/(1 - lambda q)^3,   T(1) = T0,
///
/// integrated by Runge-Kutta to 1e-11. In the units of Xu et al. the first term is c0^2 lambda (V0 - V)^2 /
/// (cv ((lambda - 1) V0 - lambda V)^3) per V. It takes the gamma law of its equation of state.
/// Source: Walsh and Christian, Phys. Rev. 97 (1955) 1544; Meyers, Dynamic Behavior of Materials (1994), secs. 4.4 and
/// 5.4; Xu, Zhang, Ying, Yu, temperature equation.
template <class Eos = eos::MieGruneisen>
class Hugoniot {
 public:
  /// \param equation has rho0, c0 and lambda. \throws InputError for numbers outside their ranges.
  explicit Hugoniot(const Eos& equation) : eos_(equation) { eos_.validate(); }
  Hugoniot(const Eos& equation, const heat::Adiabatic& heat)
      : eos_(equation), cv_(heat.specific_heat), t0_(heat.initial_temperature) {
    eos_.validate();
    heat.validate();
  }

  /// From the jump of velocity, m/s, >= 0; with lambda < 1 below c0/(1 - lambda), where V would be 0.
  ShockState from_particle_speed(double u) const {
    require(u >= 0 && std::isfinite(u) && u < fastest(), "the particle speed is ", u,
            " m/s; it must be >= 0 and below ", fastest(), " m/s for this equation of state");
    const double speed = eos_.c0 + eos_.lambda * u, x = (eos_.c0 - (1 - eos_.lambda) * u) / speed;
    return {u, speed, x, eos_.rho0 / x, eos_.rho0 * speed * u, 0.5 * u * u, temperature(x)};
  }

  /// From the pressure behind, Pa, >= 0.
  ShockState from_pressure(double p) const {
    require(p >= 0 && std::isfinite(p), "the shock pressure is ", p, " Pa; it must be >= 0");
    // the root of lambda u^2 + c0 u - p/rho0, in the form that lambda = 0 does not upset
    const double c = eos_.c0, root = std::sqrt(c * c + 4 * eos_.lambda * p / eos_.rho0);
    return from_particle_speed(2 * p / eos_.rho0 / (c + root));
  }

  /// From V/V0, above the pole 1 - 1/lambda (or 0) and at most 1.
  ShockState from_volume_ratio(double x) const {
    require(x <= 1 && x > eos_.smallest_x(), "V/V0 behind the shock is ", x, "; it must lie above ", eos_.smallest_x(),
            " and be at most 1");
    return from_particle_speed(eos_.c0 * (1 - x) / (1 - eos_.lambda * (1 - x)));
  }

 private:
  Eos eos_;
  double cv_ = std::numeric_limits<double>::quiet_NaN(), t0_ = cv_;

  double fastest() const {
    return eos_.lambda < 1 ? eos_.c0 / (1 - eos_.lambda) : std::numeric_limits<double>::infinity();
  }

  double gamma_over_volume(double x) const {
    if constexpr (requires { eos_.gamma_over_volume(x); })
      return eos_.gamma_over_volume(x);
    else
      return eos_.gamma_over_volume();
  }

  double temperature(double x) const {
    if (std::isnan(cv_)) return cv_;
    const auto rate = [this](double y, const detail::Numbers<1>& t) {
      return detail::Numbers<1>{eos_.reference_heating(y) / cv_ - gamma_over_volume(y) * t[0]};
    };
    return detail::solve_ode(rate, detail::Numbers<1>{t0_}, 1, x, 1e-13)[0];
  }
};

}  // namespace mote::exact
