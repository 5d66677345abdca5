/// \file
/// Compressible neo-Hookean elasticity, for which the manufactured solutions are made.
#pragma once

#include <cmath>

#include <mote/core/error.hpp>
#include <mote/core/tensor.hpp>

namespace mote::exact {

/// Energy per initial volume W = (mu/2) (tr b - 3) - mu ln J + (lambda/2) (ln J)^2, with b = F F^T and J = det F, hence
///
///     P = dW/dF = mu (F - F^-T) + lambda ln J F^-T,     sigma = P F^T / J = [mu (b - I) + lambda ln J I] / J.
///
/// Source: Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis (2008), eqs. 6.27 to 6.29.
struct NeoHookean {
  double rho0;        ///< density at rest, kg/m^3, > 0
  double lambda = 0;  ///< Lame's first parameter, Pa, >= 0
  double mu;          ///< shear modulus, Pa, > 0

  /// From Young's modulus (Pa, > 0) and Poisson's ratio (0 to below 0.5) at small strain.
  static NeoHookean from_young(double rho0, double young, double poisson) {
    require(young > 0, "Young's modulus is ", young, " Pa; it must be > 0");
    require(poisson >= 0 && poisson < 0.5, "Poisson's ratio is ", poisson, "; it must lie in [0, 0.5)");
    const NeoHookean m{.rho0 = rho0,
                       .lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
                       .mu = young / (2 * (1 + poisson))};
    m.validate();
    return m;
  }

  void validate() const {
    require(rho0 > 0, "the density rho0 is ", rho0, " kg/m^3; it must be > 0");
    require(lambda >= 0, "Lame's parameter lambda is ", lambda, " Pa; it must be >= 0");
    require(mu > 0, "the shear modulus mu is ", mu, " Pa; it must be > 0");
  }

  /// Young's modulus, Pa.
  double young() const { return mu * (3 * lambda + 2 * mu) / (lambda + mu); }
  /// Poisson's ratio.
  double poisson() const { return lambda / (2 * (lambda + mu)); }
  /// lambda + 2 mu/3, Pa.
  double bulk_modulus() const { return lambda + 2 * mu / 3; }
  /// sqrt(E/rho0), m/s, the C of the manufactured bar.
  double bar_speed() const { return std::sqrt(young() / rho0); }
  /// sqrt((lambda + 2 mu)/rho0), m/s.
  double longitudinal_speed() const { return std::sqrt((lambda + 2 * mu) / rho0); }

  /// W, J/m^3 of initial volume.
  double energy(const Mat<double, 3>& f) const {
    double squares = 0;
    for (const double c : f.c) squares += c * c;
    const double log_j = std::log(det(f));
    return 0.5 * mu * (squares - 3) - mu * log_j + 0.5 * lambda * log_j * log_j;
  }

  /// Cauchy stress, Pa, tension positive.
  SymTensor<double> stress(const Mat<double, 3>& f) const {
    const double j = det(f);
    return add_diagonal(sym(f * transpose(f)) * (mu / j), (lambda * std::log(j) - mu) / j);
  }

  friend bool operator==(const NeoHookean&, const NeoHookean&) = default;
};

}  // namespace mote::exact
