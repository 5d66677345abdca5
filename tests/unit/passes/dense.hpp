/// \file
/// USF, XPIC and FMPM in three dimensions, the slow way: one table of weights per step, and every formula as the papers
/// print it, with binomial coefficients. Shares the dense grid with its planes and the metal with bench/textbook.hpp,
/// and no code with the library.
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>

#include "../../../bench/textbook.hpp"

namespace dense {

using textbook::Matrix;
using textbook::Vector;
enum class Transfer { flip, apic, xpic, fmpm };
enum class Update { usl, musl, usf };

/// \tparam N nodes per axis that a particle touches, 2 to 4
template <int N>
class Loop : public textbook::Grid {
 public:
  Transfer transfer;
  Update update;
  int order = 1;
  textbook::Metal metal;
  textbook::Particles particles;
  Vector impulse = {};  ///< given by the planes: the momentum that the particles gained, N s

  Loop(const textbook::Box& where, Transfer t, Update u, int terms)
      : Grid(where, N / 2, N == 2 ? 0 : (N == 3 ? 0.25 : 1.0 / 3)), transfer(t), update(u), order(terms) {}

  void add(const Vector& x, const Vector& v, double mass) {
    auto& P = particles;
    P.m.push_back(mass), P.J.push_back(1), P.temperature.push_back(300);
    P.strain.push_back(0), P.work.push_back(0);
    for (int a = 0; a < 3; ++a) P.x[a].push_back(x[a]), P.v[a].push_back(v[a]);
    for (auto& column : P.s) column.push_back(0);
    for (auto& column : P.C) column.push_back(0);
  }

  void step(double dt) {
    find_weights();
    const Vector before = momentum();
    if (update == Update::usf) {
      clear();
      scatter_momentum();
      set_velocity<true>();
      strain(transfer == Transfer::fmpm ? summed(velocity()) : velocity(), dt);
    }
    clear();
    scatter_momentum();
    set_velocity<true>();
    const Field incoming = velocity();  // within all planes
    clear();
    scatter_momentum();
    scatter_force();
    set_old_velocity();  // FLIP: whole at symmetry planes, raw at walls
    move(dt, {}, 0);
    const Field after = velocity(), moving = transfer == Transfer::fmpm ? summed(after) : after;
    take_velocity(incoming, after, moving);
    const Vector gained = momentum();
    for (int a = 0; a < 3; ++a) impulse[a] += gained[a] - before[a];
    const Field drift = to_particles(moving);
    if (update == Update::usl) strain(moving, dt);
    if (update == Update::musl) {
      for (auto& n : nodes) n.p[0] = n.p[1] = n.p[2] = 0;
      scatter_momentum_only();
      set_velocity<false>();
      strain(transfer == Transfer::fmpm ? summed(velocity()) : velocity(), dt);
    }
    for (std::size_t p = 0; p < particles.size(); ++p)
      for (int a = 0; a < 3; ++a) shift(particles.x[a][p], dt * drift[p][a], a);
  }

 private:
  using Field = std::vector<Vector>;  // of nodes or of particles
  struct Weight {
    std::size_t node;
    double w;
    Vector slope, arm;  // grad w, x_i - x_p
  };
  std::vector<std::vector<Weight>> weights_;  // by particle

  /// The B-spline of N - 1 degrees about 0, by the recursion over degrees, and its slope.
  static double spline(int degree, double r) {
    if (degree == 0) return r >= -0.5 && r < 0.5 ? 1 : 0;
    const double half = 0.5 * (degree + 1);
    return ((half + r) * spline(degree - 1, r + 0.5) + (half - r) * spline(degree - 1, r - 0.5)) / degree;
  }
  static double slope(int degree, double r) { return spline(degree - 1, r + 0.5) - spline(degree - 1, r - 0.5); }

  void find_weights() {
    weights_.assign(particles.size(), {});
    for (std::size_t p = 0; p < particles.size(); ++p) {
      int low[3];
      for (int a = 0; a < 3; ++a) low[a] = int(std::floor(particles.x[a][p] / box.spacing - 0.5 * (N - 2)));
      for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j)
          for (int k = 0; k < N; ++k) {
            const int node[3] = {low[0] + i, low[1] + j, low[2] + k};
            double w[3], d[3];
            Weight one{};
            for (int a = 0; a < 3; ++a) {
              const double r = particles.x[a][p] / box.spacing - node[a];
              w[a] = spline(N - 1, r), d[a] = slope(N - 1, r) / box.spacing;
              one.arm[a] = -r * box.spacing;
              int index = node[a];
              const int cells = box.upper[a] - box.lower[a];
              if (box.periodic[a]) index = box.lower[a] + ((index - box.lower[a]) % cells + cells) % cells;
              if (index < first[a] || index >= first[a] + count[a]) throw std::out_of_range("a particle left the grid");
              one.node += std::size_t(index - first[a]) * stride[a];
            }
            one.w = w[0] * w[1] * w[2];
            one.slope = {d[0] * w[1] * w[2], w[0] * d[1] * w[2], w[0] * w[1] * d[2]};
            weights_[p].push_back(one);
          }
    }
  }

  Vector momentum() const {
    Vector sum{};
    for (std::size_t p = 0; p < particles.size(); ++p)
      for (int a = 0; a < 3; ++a) sum[a] += particles.m[p] * particles.v[a][p];
    return sum;
  }
  void clear() {
    for (auto& n : nodes) n = {};
  }
  Field velocity() const {
    Field v;
    for (const auto& m : motion) v.push_back({m.v[0], m.v[1], m.v[2]});
    return v;
  }

  void scatter_momentum_only() {
    for (std::size_t p = 0; p < particles.size(); ++p)
      for (const Weight& t : weights_[p])
        for (int a = 0; a < 3; ++a) {
          double v = particles.v[a][p];
          if (transfer == Transfer::apic)
            for (int b = 0; b < 3; ++b) v += particles.C[3 * a + b][p] * t.arm[b];
          nodes[t.node].p[a] += t.w * particles.m[p] * v;
        }
  }
  void scatter_momentum() {
    scatter_momentum_only();
    for (std::size_t p = 0; p < particles.size(); ++p)
      for (const Weight& t : weights_[p]) nodes[t.node].m += t.w * particles.m[p];
  }
  void scatter_force() {
    const auto& P = particles;
    constexpr int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (std::size_t p = 0; p < P.size(); ++p) {
      const double V = P.J[p] * P.m[p] / metal.rho0, pressure = metal.pressure(P.J[p], P.work[p]);
      for (const Weight& t : weights_[p])
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            nodes[t.node].f[a] -= V * (P.s[at[a][b]][p] - (a == b ? pressure : 0)) * t.slope[b];
    }
  }

  /// S v. Not inlined: g++ 12 then takes the vectors' memory for somebody else's.
  [[gnu::noinline]] Field to_particles(const Field& v) const {
    Field V(particles.size(), Vector{});
    for (std::size_t p = 0; p < V.size(); ++p)
      for (const Weight& t : weights_[p])
        for (int a = 0; a < 3; ++a) V[p][a] += t.w * v[t.node][a];
    return V;
  }
  /// S+ S v, within the planes; the masses are on the nodes.
  Field there_and_back(const Field& v) {
    const Field V = to_particles(v);
    for (auto& n : nodes) n.p[0] = n.p[1] = n.p[2] = 0;
    for (std::size_t p = 0; p < V.size(); ++p)
      for (const Weight& t : weights_[p])
        for (int a = 0; a < 3; ++a) nodes[t.node].p[a] += t.w * particles.m[p] * V[p][a];
    set_velocity<false>();
    return velocity();
  }
  /// sum_l (-1)^(l+1) C(order, l) (S+ S)^(l-1) v.
  Field summed(const Field& v) {
    Field sum(v.size(), Vector{}), power = v;
    double binomial = 1;
    for (int l = 1; l <= order; ++l) {
      if (l > 1) power = there_and_back(power);
      binomial *= double(order - l + 1) / l;
      for (std::size_t i = 0; i < v.size(); ++i)
        for (int a = 0; a < 3; ++a) sum[i][a] += (l % 2 ? binomial : -binomial) * power[i][a];
    }
    return sum;
  }

  void take_velocity(const Field& incoming, const Field& after, const Field& moving) {
    auto& P = particles;
    if (transfer == Transfer::flip) {
      for (std::size_t p = 0; p < P.size(); ++p)
        for (const Weight& t : weights_[p])
          for (int a = 0; a < 3; ++a) P.v[a][p] += t.w * (after[t.node][a] - motion[t.node].old[a]);
      return;
    }
    Field V = to_particles(moving);
    if (transfer == Transfer::xpic) {  // of its own velocity the filtered one, and the change by the forces
      V = to_particles(summed(incoming));
      const Field v = to_particles(after), old = to_particles(incoming);
      for (std::size_t p = 0; p < P.size(); ++p)
        for (int a = 0; a < 3; ++a) V[p][a] += v[p][a] - old[p][a];
    }
    for (std::size_t p = 0; p < P.size(); ++p)
      for (int a = 0; a < 3; ++a) P.v[a][p] = V[p][a];
    if (transfer != Transfer::apic) return;
    const double D = (N == 4 ? 1.0 / 3 : 0.25) * box.spacing * box.spacing;
    for (std::size_t p = 0; p < P.size(); ++p)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          double& C = P.C[3 * a + b][p] = 0;
          for (const Weight& t : weights_[p]) C += (N == 2 ? t.slope[b] : t.w * t.arm[b] / D) * moving[t.node][a];
        }
  }

  void strain(const Field& v, double dt) {
    auto& P = particles;
    for (std::size_t p = 0; p < P.size(); ++p) {
      Matrix A{};
      for (const Weight& t : weights_[p])
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) A[a][b] += dt * v[t.node][a] * t.slope[b];
      textbook::State state{P.J[p], {}, P.strain[p], P.work[p], P.temperature[p]};
      for (int c = 0; c < 6; ++c) state.s[c] = P.s[c][p];
      metal.update(state, A);
      for (int c = 0; c < 6; ++c) P.s[c][p] = state.s[c];
      P.J[p] = state.J, P.strain[p] = state.strain, P.work[p] = state.work, P.temperature[p] = state.temperature;
    }
  }

  void shift(double& x, double by, int a) const {
    x += by;
    if (!box.periodic[a]) return;
    const double from = box.lower[a] * box.spacing, to = box.upper[a] * box.spacing;
    x += x < from ? to - from : (x >= to ? from - to : 0);
  }
};

}  // namespace dense
