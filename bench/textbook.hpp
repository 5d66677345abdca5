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

#include "textbook_grid.hpp"
#include "textbook_metal.hpp"

namespace textbook {

enum class Shape { linear, quadratic, cubic, gimp, contiguous_gimp };
enum class Transfer { flip, apic, affine_flip };
enum class Update { usl, musl };

/// One vector per component.
struct Particles {
  using Column = std::vector<double>;
  Column m, J, strain, work, temperature;
  std::array<Column, 3> x, v;
  std::array<Column, 6> s;
  std::array<Column, 9> C;  ///< row-major, not with FLIP
  std::array<Column, 3> l;  ///< half sizes, only with GIMP
  std::size_t size() const { return m.size(); }
};

/// The loop. Fill it with add(), move it with step(dt); everything may be read and written between steps.
template <Shape S, Transfer T, Update U>
class Loop : public Grid {
  static constexpr int N = S == Shape::linear ? 2 : (S == Shape::cubic ? 4 : 3);
  static constexpr int ghosts = N / 2;  // of a particle up to half a cell beyond a plane
  static constexpr bool affine = T != Transfer::flip, increments = T != Transfer::apic, musl = U == Update::musl,
                        usl = !musl;
  static constexpr bool sharpened = T == Transfer::affine_flip;
  static constexpr bool gimp = S == Shape::gimp || S == Shape::contiguous_gimp;
  static constexpr bool moments = T == Transfer::apic && S != Shape::linear && !gimp;  // else C is the gradient

 public:
  Metal metal;
  double blend = 1;     ///< FLIP: 1, PIC: 0; no meaning with APIC
  int order = 2;        ///< terms of the change of velocity, with affine FLIP
  double tail = 1.25;   ///< weight of the last of them
  Vector gravity = {};  ///< body force per mass, m/s^2
  Vector impulse = {};  ///< given by the planes since the beginning, N s
  Particles particles;

  explicit Loop(const Box& where, const Metal& material = {})
      : Grid(where, ghosts, S == Shape::quadratic ? 0.25 : (S == Shape::cubic ? 1.0 / 3 : 0)),
        metal(material),
        inverse(1 / where.spacing) {}

  /// Adds a particle at rest density; with GIMP a quarter of a cell is half its edge.
  void add(const Vector& x, const Vector& v, double mass, double temperature = 300) {
    Particles& P = particles;
    P.m.push_back(mass);
    P.J.push_back(1);
    P.temperature.push_back(temperature);
    for (auto* column : {&P.strain, &P.work}) column->push_back(0);
    for (int a = 0; a < 3; ++a) P.x[a].push_back(x[a]), P.v[a].push_back(v[a]);
    for (auto& column : P.s) column.push_back(0);
    if (gimp)
      for (auto& column : P.l) column.push_back(0.25 * box.spacing);
    if (affine)
      for (auto& column : P.C) column.push_back(0);
    if (musl)
      for (auto& column : drift) column.push_back(0);
  }

  /// One step. Throws std::out_of_range, and leaves the particles in the middle of it, if one is outside the box.
  void step(double dt) {
    for (Node& n : nodes) n = {};
    for (std::size_t p = 0; p < particles.size(); ++p) scatter(p);
    if constexpr (increments) set_old_velocity();
    const Vector given = move(dt, gravity, increments ? blend : 0);
    for (int a = 0; a < 3; ++a) impulse[a] += given[a];
    if constexpr (sharpened) sharpen();
    if constexpr (musl) {
      for (std::size_t p = 0; p < particles.size(); ++p) gather_and_rescatter(p, dt);
      set_velocity<false>();
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

  double inverse;
  std::array<std::vector<double>, 3> drift;  // MUSL: sum w v_new, kept for the position

  Stencil stencil(std::size_t p) const {
    Stencil t;
    for (int a = 0; a < 3; ++a) {
      const double xi = particles.x[a][p] * inverse;
      const double base = std::floor(xi - 0.5 * (N - 2)), f = xi - base;
      double *w = t.w[a], *d = t.d[a];
      if constexpr (S == Shape::linear) {
        w[0] = 1 - f, w[1] = f;
        d[0] = -inverse, d[1] = inverse;
      } else if constexpr (S == Shape::quadratic) {
        w[0] = 0.5 * (1.5 - f) * (1.5 - f), w[1] = 0.75 - (f - 1) * (f - 1), w[2] = 0.5 * (f - 0.5) * (f - 0.5);
        d[0] = (f - 1.5) * inverse, d[1] = 2 * (1 - f) * inverse, d[2] = (f - 0.5) * inverse;
      } else if constexpr (gimp) {  // the three pieces of Bardenhagen and Kober (2004)
        const double l = std::min(0.5, particles.l[a][p] * inverse);
        for (int k = 0; k < N; ++k) {
          const double r = std::abs(f - k), sign = k < f ? inverse : -inverse;
          if (r < l)
            w[k] = 1 - (r * r + l * l) / (2 * l), d[k] = -r / l * sign;
          else if (r < 1 - l)
            w[k] = 1 - r, d[k] = -sign;
          else if (r < 1 + l)
            w[k] = (1 + l - r) * (1 + l - r) / (4 * l), d[k] = -(1 + l - r) / (2 * l) * sign;
          else
            w[k] = d[k] = 0;
        }
      } else {  // |r|^3/2 - r^2 + 2/3 within a cell of the particle, (2 - |r|)^3/6 beyond
        for (int k = 0; k < N; ++k) {
          const double r = std::abs(f - k), outer = 2 - r;
          const bool inner = k == 1 || k == 2;
          w[k] = inner ? 0.5 * r * r * r - r * r + 2.0 / 3 : 1.0 / 6 * outer * outer * outer;
          d[k] = (inner ? 1.5 * r * r - 2 * r : -0.5 * outer * outer) * (k < f ? inverse : -inverse);
        }
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
      if constexpr (affine)
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
          q[a] = mv[a] + (affine ? mC[a][0] * t.r[0][i] + mC[a][1] * t.r[1][j] : 0);
          f[a] = stress[a][0] * dw + stress[a][1] * wd;
          g[a] = stress[a][2] * ww;
        }
        Node* row = &nodes[t.at[0][i] + t.at[1][j]];
        for (int k = 0; k < N; ++k) {
          Node& n = row[t.at[2][k]];
          const double w = ww * t.w[2][k];
          for (int a = 0; a < 3; ++a) n.p[a] += w * (affine ? q[a] + mC[a][2] * t.r[2][k] : q[a]);
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

  /// v += (1 - S+ S) dv + ... + tail (1 - S+ S)^(order - 1) dv, dv = v - old: the terms of the consistent mass beyond
  /// the lumped one.
  void sharpen() {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int a = 0; a < 3; ++a) nodes[i].p[a] = nodes[i].m * (motion[i].v[a] - motion[i].old[a]);
    std::vector<Motion> sum = motion;
    set_velocity<false>();  // motion now holds the term
    for (int j = 1; j < order; ++j) {
      const double weight = j == order - 1 ? tail : 1;
      for (std::size_t p = 0; p < particles.size(); ++p) {
        const Stencil t = stencil(p);
        Vector v = gather<false, false, false>(t).v;
        for (double& c : v) c *= particles.m[p];
        spread<false>(t, 0, v, {}, {});
      }
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int a = 0; a < 3; ++a) {
          double& p = nodes[i].p[a];
          p = nodes[i].m * motion[i].v[a] - p;
          impulse[a] -= weight * p;
        }
      set_velocity<false>();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int a = 0; a < 3; ++a) {
          sum[i].v[a] += weight * motion[i].v[a];
          impulse[a] += weight * nodes[i].m * motion[i].v[a];
        }
    }
    motion = std::move(sum);
  }

  /// The particle's new velocity, and C if there is one.
  void take_velocity(std::size_t p, const Gathered& g) {
    const double D = (S == Shape::cubic ? 1.0 / 3 : 0.25) * box.spacing * box.spacing;
    for (int a = 0; a < 3; ++a) {
      double& v = particles.v[a][p];
      v = increments ? g.v[a] + blend * (v - g.old[a]) : g.v[a];
      for (int b = 0; affine && b < 3; ++b) particles.C[3 * a + b][p] = moments ? g.moment[a][b] / D : g.gradient[a][b];
    }
  }

  /// C <- C - dt C^2 + dt^2 C^3: affine FLIP's gradient goes with the particle.
  void take_along(std::size_t p, double dt) {
    const auto product = [](const Matrix& a, const Matrix& b) {
      Matrix c{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
      return c;
    };
    Matrix C;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) C[a][b] = particles.C[3 * a + b][p];
    const Matrix square = product(C, C), cube = product(square, C);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) particles.C[3 * a + b][p] += dt * (dt * cube[a][b] - square[a][b]);
  }

  /// MUSL: the velocity, then its momentum back to the grid.
  void gather_and_rescatter(std::size_t p, double dt) {
    const Stencil t = stencil(p);
    const Gathered g = gather < increments, affine && !moments, moments > (t);
    take_velocity(p, g);
    for (int a = 0; a < 3; ++a) drift[a][p] = g.v[a];
    Vector mv;
    Matrix mC{};
    momentum(p, mv, mC);
    spread<false>(t, 0, mv, mC, {});
    if constexpr (sharpened) take_along(p, dt);
  }

  /// Velocity (USL), stress and position from the nodes' velocity.
  void move_particle(std::size_t p, double dt) {
    Particles& P = particles;
    Gathered g = gather < increments && usl, true, moments && usl > (stencil(p));
    if constexpr (usl) take_velocity(p, g);
    if constexpr (usl && sharpened) take_along(p, dt);
    for (Vector& row : g.gradient)
      for (double& L : row) L *= dt;
    State state{P.J[p], {}, P.strain[p], P.work[p], P.temperature[p]};
    for (int c = 0; c < 6; ++c) state.s[c] = P.s[c][p];
    metal.update(state, g.gradient);
    for (int c = 0; c < 6; ++c) P.s[c][p] = state.s[c];
    P.J[p] = state.J, P.strain[p] = state.strain, P.work[p] = state.work, P.temperature[p] = state.temperature;
    for (int a = 0; a < 3; ++a) {
      if constexpr (S == Shape::contiguous_gimp) P.l[a][p] *= 1 + g.gradient[a][a];
      double& x = P.x[a][p];
      x += dt * (musl ? drift[a][p] : g.v[a]);
      if (!box.periodic[a]) continue;
      const double from = box.lower[a] * box.spacing, to = box.upper[a] * box.spacing;
      x += x < from ? to - from : (x >= to ? from - to : 0);
    }
  }
};

}  // namespace textbook
