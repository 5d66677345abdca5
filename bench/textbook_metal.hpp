/// \file
/// The metal of the textbook loop: one particle's history and how it follows the motion.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace textbook {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  ///< rows of columns

/// The history of one particle: J, deviatoric stress (xx yy zz xy yz xz, Pa), eps_p, W_p (J/kg), temperature (K).
struct State {
  double J = 1, s[6] = {}, strain = 0, work = 0, temperature = 300;
};

/// Mie-Grueneisen pressure, von Mises strength with linear isotropic hardening, adiabatic heat; SI units. Default:
/// aluminium.
struct Metal {
  double rho0 = 2700, c0 = 5350, lambda = 1.34, gamma0 = 1.96;
  double shear = 25.94e9, yield = 120e6, hardening = 384e6;
  double cv = 880;

  /// P_H(J) + rho0 gamma0 W_p, Pa.
  double pressure(double J, double work) const {
    const double q = 1 - J, d = J < 1 ? 1 - lambda * q : 1;
    return rho0 * c0 * c0 * q / (d * d) + rho0 * gamma0 * work;
  }

  /// Moves the state over the increment A = dt L: Hughes and Winget (1980), radial return, Crank-Nicolson for T.
  void update(State& state, const Matrix& A) const {
    const double J_old = state.J;
    state.J *= determinant(identity_plus(1, A));
    const double work = flow(state, midpoint(A)) * 0.5 * (J_old + state.J) / rho0;
    state.work += work;
    const double dJ = state.J - J_old, half = 0.5 * gamma0 * dJ;
    const double q = std::max(1 - 0.5 * (J_old + state.J), 0.0), d = 1 - lambda * q;
    const double heat = work - c0 * c0 * lambda * q * q / (d * d * d) * dJ;
    state.temperature = (state.temperature * (1 - half) + heat / cv) / (1 + half);
  }

 private:
  static Matrix identity_plus(double f, Matrix A) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) A[i][j] = (i == j) + f * A[i][j];
    return A;
  }
  static Matrix product(const Matrix& A, const Matrix& B) {
    Matrix C;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
    return C;
  }
  static double cofactor(const Matrix& B, int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return B[a][c] * B[b][d] - B[a][d] * B[b][c];
  }
  static double determinant(const Matrix& B) {
    return B[0][0] * cofactor(B, 0, 0) + B[0][1] * cofactor(B, 0, 1) + B[0][2] * cofactor(B, 0, 2);
  }
  /// A (I + A/2)^-1.
  static Matrix midpoint(const Matrix& A) {
    const Matrix B = identity_plus(0.5, A);
    const double scale = 1 / determinant(B);
    Matrix inverse;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) inverse[i][j] = scale * cofactor(B, j, i);
    return product(A, inverse);
  }
  /// Q = I + 2/(1 + t.t) (W + W W) with W half the skew part of G and t its axial vector.
  static Matrix rotation(const Matrix& G) {
    const double x = 0.25 * (G[2][1] - G[1][2]), y = 0.25 * (G[0][2] - G[2][0]), z = 0.25 * (G[1][0] - G[0][1]);
    const double f = 2 / (1 + x * x + y * y + z * z);
    return {{{1 - f * (y * y + z * z), f * (x * y - z), f * (x * z + y)},
             {f * (x * y + z), 1 - f * (x * x + z * z), f * (y * z - x)},
             {f * (x * z - y), f * (y * z + x), 1 - f * (x * x + y * y)}}};
  }
  /// Rotates and loads the deviator, returns it to the yield surface; the plastic work per current volume, J/m^3.
  double flow(State& state, const Matrix& G) const {
    double* s = state.s;
    const Matrix Q = rotation(G);
    const Matrix QS = product(Q, {{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}});
    const double mean = (G[0][0] + G[1][1] + G[2][2]) / 3;
    constexpr int row[] = {0, 1, 2, 0, 1, 0}, column[] = {0, 1, 2, 1, 2, 2};
    for (int c = 0; c < 6; ++c) {
      const int i = row[c], j = column[c];
      const double turned = QS[i][0] * Q[j][0] + QS[i][1] * Q[j][1] + QS[i][2] * Q[j][2];
      s[c] = turned + shear * (G[i][j] + G[j][i] - (i == j ? 2 * mean : 0));
    }
    const double normal = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
    const double mises = std::sqrt(1.5 * (normal + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])));
    const double limit = yield + hardening * state.strain;
    if (mises <= limit) return 0;
    const double d = (mises - limit) / (3 * shear + hardening), factor = 1 - 3 * shear * d / mises;
    for (int c = 0; c < 6; ++c) s[c] *= factor;
    state.strain += d;
    return (limit + 0.5 * hardening * d) * d;
  }
};

}  // namespace textbook
