/// \file
/// A plain textbook Material Point Method in three dimensions: a dense grid, a vector per particle component, double
/// loops. No sorting, no threads, no SIMD types, no code shared with the library.
///
/// It has two uses: the baseline of every speed claim, and the slow reference that the library's passes must match.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

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

enum class Shape { linear, quadratic };
enum class Transfer { flip, apic };
enum class Update { usl, musl };

/// A mirror plane on the nodes of index `node` along `axis`; the material is above it, or below if `upper`.
struct Plane {
  int axis, node;
  bool upper = false;
  bool no_slip = true;  ///< a rigid wall; false: a symmetry plane
  double sign(int component) const { return no_slip || component == axis ? -1 : 1; }
};

/// The box of nodes that the material may touch. Nodes lie at index * spacing, from `lower` to `upper`; a periodic axis
/// repeats after upper - lower cells. Mirror planes lie inside the box; ghost layers are added around it.
struct Box {
  double spacing;
  std::array<int, 3> lower, upper;
  std::array<bool, 3> periodic = {};
  std::vector<Plane> planes = {};
};

/// One vector per component.
struct Particles {
  using Column = std::vector<double>;
  Column m, J, strain, work, temperature;
  std::array<Column, 3> x, v;
  std::array<Column, 6> s;
  std::array<Column, 9> C;  ///< row-major, only with APIC
  std::size_t size() const { return m.size(); }
};

/// m: raw mass; p: momentum (used up by the step); f: force; folded: the mass with its images.
struct alignas(64) Node {
  double m, p[3], f[3], folded;
};
/// v: new velocity (after a MUSL step: of the second scatter); old: the raw velocity p/m.
struct Motion {
  double v[3], old[3];
};

/// The loop. Fill it with add(), move it with step(dt); everything may be read and written between steps.
template <Shape S, Transfer T, Update U>
class Loop {
  static constexpr int N = S == Shape::linear ? 2 : 3, ghosts = 1;
  static constexpr bool apic = T == Transfer::apic, flip = !apic, musl = U == Update::musl, usl = !musl;
  static constexpr bool moments = apic && S == Shape::quadratic;  // else C is the velocity gradient

 public:
  Metal metal;
  double blend = 1;     ///< FLIP: 1, PIC: 0; no meaning with APIC
  Vector gravity = {};  ///< body force per mass, m/s^2
  Vector impulse = {};  ///< given by the planes since the beginning, N s
  Particles particles;
  std::vector<Node> nodes;  ///< all nodes with ghosts, z fastest
  std::vector<Motion> motion;

  explicit Loop(const Box& where, const Metal& material = {})
      : metal(material), box(where), inverse(1 / where.spacing) {
    for (int a = 0; a < 3; ++a) {
      first[a] = box.lower[a] - (box.periodic[a] ? 0 : ghosts);
      count[a] = box.upper[a] - box.lower[a] + (box.periodic[a] ? 0 : 1 + 2 * ghosts);
    }
    stride = {std::size_t(count[1]) * std::size_t(count[2]), std::size_t(count[2]), 1};
    nodes.resize(std::size_t(count[0]) * stride[0]);
    motion.resize(nodes.size());
  }

  /// Adds a particle at rest density.
  void add(const Vector& x, const Vector& v, double mass, double temperature = 300) {
    Particles& P = particles;
    P.m.push_back(mass);
    P.J.push_back(1);
    P.temperature.push_back(temperature);
    for (auto* column : {&P.strain, &P.work}) column->push_back(0);
    for (int a = 0; a < 3; ++a) P.x[a].push_back(x[a]), P.v[a].push_back(v[a]);
    for (auto& column : P.s) column.push_back(0);
    if (apic)
      for (auto& column : P.C) column.push_back(0);
    if (musl)
      for (auto& column : drift) column.push_back(0);
  }

  /// The place of node (i, j, k) in `nodes` and `motion`.
  std::size_t at(int i, int j, int k) const {
    return std::size_t(i - first[0]) * stride[0] + std::size_t(j - first[1]) * stride[1] + std::size_t(k - first[2]);
  }

  /// One step. Throws std::out_of_range, and leaves the particles in the middle of it, if one is outside the box.
  void step(double dt) {
    for (Node& n : nodes) n = {};
    for (std::size_t p = 0; p < particles.size(); ++p) scatter(p);
    move_nodes(dt);
    if constexpr (musl) {
      for (std::size_t p = 0; p < particles.size(); ++p) gather_and_rescatter(p);
      divide_and_mirror<false>();
    }
    for (std::size_t p = 0; p < particles.size(); ++p) move_particle(p, dt);
  }

 private:
  /// Weights, gradients, distances x_i - x_p and node offsets per axis.
  struct Stencil {
    double w[3][N], d[3][N], r[3][N];
    std::size_t at[3][N];
  };
  struct Gathered {
    Vector v{}, old{};
    Matrix gradient{}, moment{};
  };

  Box box;
  double inverse;
  std::array<int, 3> first{}, count{};
  std::array<std::size_t, 3> stride{};
  std::array<std::vector<double>, 3> drift;  // MUSL: sum w v_new, kept for the position

  Stencil stencil(std::size_t p) const {
    Stencil t;
    for (int a = 0; a < 3; ++a) {
      const double xi = particles.x[a][p] * inverse;
      const double base = std::floor(S == Shape::linear ? xi : xi - 0.5), f = xi - base;
      double *w = t.w[a], *d = t.d[a];
      if constexpr (S == Shape::linear) {
        w[0] = 1 - f, w[1] = f;
        d[0] = -inverse, d[1] = inverse;
      } else {
        w[0] = 0.5 * (1.5 - f) * (1.5 - f), w[1] = 0.75 - (f - 1) * (f - 1), w[2] = 0.5 * (f - 0.5) * (f - 0.5);
        d[0] = (f - 1.5) * inverse, d[1] = 2 * (1 - f) * inverse, d[2] = (f - 0.5) * inverse;
      }
      const int start = int(base) - first[a];
      if (!box.periodic[a] && (start < 0 || start + N > count[a])) throw std::out_of_range("a particle left the grid");
      for (int k = 0; k < N; ++k) {
        t.r[a][k] = (k - f) * box.spacing;
        int i = start + k;
        if (box.periodic[a]) {
          while (i < 0) i += count[a];
          while (i >= count[a]) i -= count[a];
        }
        t.at[a][k] = std::size_t(i) * stride[a];
      }
    }
    return t;
  }

  /// m_p v_p, and m_p C_p if there is one.
  void momentum(std::size_t p, Vector& mv, Matrix& mC) const {
    const double m = particles.m[p];
    for (int a = 0; a < 3; ++a) {
      mv[a] = m * particles.v[a][p];
      if constexpr (apic)
        for (int b = 0; b < 3; ++b) mC[a][b] = m * particles.C[3 * a + b][p];
    }
  }

  /// Particle to grid; without `Full` only the momentum.
  template <bool Full>
  void spread(const Stencil& t, double m, const Vector& mv, const Matrix& mC, const Matrix& stress) {
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) {
        const double ww = t.w[0][i] * t.w[1][j], dw = t.d[0][i] * t.w[1][j], wd = t.w[0][i] * t.d[1][j];
        Vector q, f, g;
        for (int a = 0; a < 3; ++a) {
          q[a] = mv[a] + (apic ? mC[a][0] * t.r[0][i] + mC[a][1] * t.r[1][j] : 0);
          f[a] = stress[a][0] * dw + stress[a][1] * wd;
          g[a] = stress[a][2] * ww;
        }
        Node* row = &nodes[t.at[0][i] + t.at[1][j]];
        for (int k = 0; k < N; ++k) {
          Node& n = row[t.at[2][k]];
          const double w = ww * t.w[2][k];
          for (int a = 0; a < 3; ++a) n.p[a] += w * (apic ? q[a] + mC[a][2] * t.r[2][k] : q[a]);
          if constexpr (!Full) continue;
          n.m += w * m;
          for (int a = 0; a < 3; ++a) n.f[a] -= t.w[2][k] * f[a] + t.d[2][k] * g[a];
        }
      }
  }

  void scatter(std::size_t p) {
    const Particles& P = particles;
    const double pressure = metal.pressure(P.J[p], P.work[p]), V = P.J[p] * P.m[p] / metal.rho0;
    const double xy = V * P.s[3][p], yz = V * P.s[4][p], xz = V * P.s[5][p];
    const Matrix stress{{{V * (P.s[0][p] - pressure), xy, xz},
                         {xy, V * (P.s[1][p] - pressure), yz},
                         {xz, yz, V * (P.s[2][p] - pressure)}}};
    Vector mv;
    Matrix mC{};
    momentum(p, mv, mC);
    spread<true>(stencil(p), P.m[p], mv, mC, stress);
  }

  void move_nodes(double dt) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Node& n = nodes[i];
      n.folded = n.m;
      for (int a = 0; a < 3; ++a) {
        motion[i].old[a] = n.m > 0 ? n.p[a] / n.m : 0;
        n.p[a] += dt * (n.f[a] + n.m * gravity[a]);
        if (!box.planes.empty()) impulse[a] -= n.p[a];
      }
    }
    divide_and_mirror<true>();
    if (box.planes.empty()) return;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int a = 0; a < 3; ++a) impulse[a] += nodes[i].m * motion[i].v[a];
  }

  /// Calls f(real, image) for the nodes at distance `layer` from a plane.
  template <class F>
  void each_pair(const Plane& plane, int layer, F f) const {
    const int a = plane.axis, b = (a + 1) % 3, c = (a + 2) % 3, k = plane.node - first[a];
    const std::size_t real = std::size_t(plane.upper ? k - layer : k + layer) * stride[a];
    const std::size_t image = std::size_t(plane.upper ? k + layer : k - layer) * stride[a];
    for (int i = 0; i < count[b]; ++i)
      for (int j = 0; j < count[c]; ++j) {
        const std::size_t side = std::size_t(i) * stride[b] + std::size_t(j) * stride[c];
        f(real + side, image + side);
      }
  }

  /// v = p/m with the images folded onto the real nodes (one axis after the other, so all products of planes come in),
  /// zero where a plane holds the node, mirrored back onto the ghosts. Leaves p = 0 for a second scatter.
  template <bool FoldMass>
  void divide_and_mirror() {
    for (const Plane& plane : box.planes)
      each_pair(plane, 1, [&](std::size_t real, std::size_t image) {
        if (FoldMass) nodes[real].folded += nodes[image].folded;
        for (int a = 0; a < 3; ++a) nodes[real].p[a] += plane.sign(a) * nodes[image].p[a];
      });
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int a = 0; a < 3; ++a) {
        motion[i].v[a] = nodes[i].folded > 0 ? nodes[i].p[a] / nodes[i].folded : 0;
        if constexpr (musl) nodes[i].p[a] = 0;
      }
    for (const Plane& plane : box.planes)
      each_pair(plane, 0, [&](std::size_t real, std::size_t) {
        for (int a = 0; a < 3; ++a)
          if (plane.sign(a) < 0) motion[real].v[a] = 0;
      });
    for (const Plane& plane : box.planes)
      each_pair(plane, 1, [&](std::size_t real, std::size_t image) {
        for (int a = 0; a < 3; ++a) motion[image].v[a] = plane.sign(a) * motion[real].v[a];
      });
  }

  /// Sums of v_new, and if asked of v_old, of v_new (x) grad w and of w v_new (x) (x_i - x_p).
  template <bool Old, bool Gradient, bool Moment>
  Gathered gather(const Stencil& t) const {
    Gathered g;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) {
        const double ww = t.w[0][i] * t.w[1][j], dw = t.d[0][i] * t.w[1][j], wd = t.w[0][i] * t.d[1][j];
        const Motion* row = &motion[t.at[0][i] + t.at[1][j]];
        Vector v{}, old{}, slope{}, moment{};
        for (int k = 0; k < N; ++k) {
          const Motion& n = row[t.at[2][k]];
          const double w = t.w[2][k], d = t.d[2][k], r = w * t.r[2][k];
          for (int a = 0; a < 3; ++a) {
            v[a] += w * n.v[a];
            if constexpr (Old) old[a] += w * n.old[a];
            if constexpr (Gradient) slope[a] += d * n.v[a];
            if constexpr (Moment) moment[a] += r * n.v[a];
          }
        }
        for (int a = 0; a < 3; ++a) {
          g.v[a] += ww * v[a];
          if constexpr (Old) g.old[a] += ww * old[a];
          if constexpr (Gradient) {
            g.gradient[a][0] += dw * v[a];
            g.gradient[a][1] += wd * v[a];
            g.gradient[a][2] += ww * slope[a];
          }
          if constexpr (Moment) {
            g.moment[a][0] += ww * t.r[0][i] * v[a];
            g.moment[a][1] += ww * t.r[1][j] * v[a];
            g.moment[a][2] += ww * moment[a];
          }
        }
      }
    return g;
  }

  /// The particle's new velocity, and C with APIC.
  void set_velocity(std::size_t p, const Gathered& g) {
    const double D = 0.25 * box.spacing * box.spacing;
    for (int a = 0; a < 3; ++a) {
      double& v = particles.v[a][p];
      v = apic ? g.v[a] : g.v[a] + blend * (v - g.old[a]);
      if constexpr (apic)
        for (int b = 0; b < 3; ++b) particles.C[3 * a + b][p] = moments ? g.moment[a][b] / D : g.gradient[a][b];
    }
  }

  /// MUSL: the velocity, then its momentum back to the grid.
  void gather_and_rescatter(std::size_t p) {
    const Stencil t = stencil(p);
    const Gathered g = gather < flip, apic && !moments, moments > (t);
    set_velocity(p, g);
    for (int a = 0; a < 3; ++a) drift[a][p] = g.v[a];
    Vector mv;
    Matrix mC{};
    momentum(p, mv, mC);
    spread<false>(t, 0, mv, mC, {});
  }

  /// Velocity (USL), stress and position from the nodes' velocity.
  void move_particle(std::size_t p, double dt) {
    Particles& P = particles;
    Gathered g = gather < flip && usl, true, moments && usl > (stencil(p));
    if constexpr (usl) set_velocity(p, g);
    for (Vector& row : g.gradient)
      for (double& L : row) L *= dt;
    State state{P.J[p], {}, P.strain[p], P.work[p], P.temperature[p]};
    for (int c = 0; c < 6; ++c) state.s[c] = P.s[c][p];
    metal.update(state, g.gradient);
    for (int c = 0; c < 6; ++c) P.s[c][p] = state.s[c];
    P.J[p] = state.J, P.strain[p] = state.strain, P.work[p] = state.work, P.temperature[p] = state.temperature;
    for (int a = 0; a < 3; ++a) {
      double& x = P.x[a][p];
      x += dt * (musl ? drift[a][p] : g.v[a]);
      if (!box.periodic[a]) continue;
      const double from = box.lower[a] * box.spacing, to = box.upper[a] * box.spacing;
      x += x < from ? to - from : (x >= to ? from - to : 0);
    }
  }
};

}  // namespace textbook
