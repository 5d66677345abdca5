/// \file
/// The dense grid of the textbook loop, and its planes.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "textbook_metal.hpp"

namespace textbook {

/// A plane on the nodes of index `node` along `axis`; the material is above it, or below if `upper`.
struct Plane {
  int axis, node;
  bool upper = false;
  bool no_slip = true;  ///< a rigid wall; false: a symmetry plane
  double sign(int component) const { return no_slip || component == axis ? -1 : 1; }
};

/// The box of nodes that the material may touch. Nodes lie at index * spacing, from `lower` to `upper`; a periodic axis
/// repeats after upper - lower cells. Mirror planes lie inside the box, at least as many cells apart as there are ghost
/// layers; these are added around it.
struct Box {
  double spacing;
  std::array<int, 3> lower, upper;
  std::array<bool, 3> periodic = {};
  std::vector<Plane> planes = {};
};

/// m: raw mass; p: momentum; f: force; folded: the mass with its images.
struct alignas(64) Node {
  double m, p[3], f[3], folded;
};
/// v: new velocity (after a MUSL step: of the second scatter); old: the velocity before the forces, raw with respect to
/// walls, of the whole body with respect to symmetry planes (FLIP only).
struct Motion {
  double v[3], old[3];
};

/// All nodes with their ghosts, z fastest.
class Grid {
  int ghosts;
  double inertia;

 public:
  Box box;
  std::array<int, 3> first{}, count{};
  std::array<std::size_t, 3> stride{};
  std::vector<Node> nodes;
  std::vector<Motion> motion;

  /// \param layers of ghost nodes: those beyond a plane that a particle may touch
  /// \param variance of the kernel where it is a smooth spline, in cells squared: near walls the field is then a
  ///        parabola that vanishes on them. 0: walls are odd mirrors
  Grid(const Box& where, int layers, double variance) : ghosts(layers), inertia(variance), box(where) {
    for (int a = 0; a < 3; ++a) {
      first[a] = box.lower[a] - (box.periodic[a] ? 0 : ghosts);
      count[a] = box.upper[a] - box.lower[a] + (box.periodic[a] ? 0 : 1 + 2 * ghosts);
    }
    stride = {std::size_t(count[1]) * std::size_t(count[2]), std::size_t(count[2]), 1};
    nodes.resize(std::size_t(count[0]) * stride[0]);
    motion.resize(nodes.size());
    for (const Plane& plane : box.planes)
      if (!plane.no_slip) symmetries.push_back(plane);
  }

  /// The place of node (i, j, k) in `nodes` and `motion`.
  std::size_t at(int i, int j, int k) const {
    return std::size_t(i - first[0]) * stride[0] + std::size_t(j - first[1]) * stride[1] + std::size_t(k - first[2]);
  }

  /// old = p/m of the body with its mirror images beyond the symmetry planes.
  void set_old_velocity() { divide<&Motion::old, true>(symmetries); }

  /// From momentum and force to the new velocity. Leaves p = 0 for a second scatter.
  /// \param kept the part of its own velocity that a particle keeps \return the momentum that the planes gave
  Vector move(double dt, const Vector& gravity, double kept) {
    Vector impulse{};
    const bool bounded = !box.planes.empty();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Node& n = nodes[i];
      for (int a = 0; a < 3; ++a) {
        if (bounded && kept > 0) impulse[a] -= kept * (n.m * motion[i].old[a] - n.p[a]);
        n.p[a] += dt * (n.f[a] + n.m * gravity[a]);
        if (bounded) impulse[a] -= n.p[a];
      }
    }
    set_velocity<true>();
    if (!bounded) return impulse;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int a = 0; a < 3; ++a) impulse[a] += nodes[i].m * motion[i].v[a];
    return impulse;
  }

  /// v = p/m of the body with its mirror images beyond all planes. Leaves p = 0 for a second scatter.
  /// FoldMass: false if the masses are those of the last call.
  template <bool FoldMass>
  void set_velocity() {
    divide<&Motion::v, FoldMass>(box.planes);
  }

 private:
  std::vector<Plane> symmetries;

  bool bends(const Plane& plane) const { return plane.no_slip && inertia > 0; }

  /// The lines of nodes across a wall: the field b k + c (k^2 - inertia) of layers k that is nearest to what layers up
  /// to 2 have, as their masses weigh it.
  template <double (Motion::*V)[3]>
  void fit_parabolas(const Plane& plane) {
    const int a = plane.axis, b = (a + 1) % 3, c = (a + 2) % 3, on_plane = plane.node - first[a];
    for (int i = 0; i < count[b]; ++i)
      for (int j = 0; j < count[c]; ++j) {
        const auto at = [&](int k) {
          return std::size_t(plane.upper ? on_plane - k : on_plane + k) * stride[a] + std::size_t(i) * stride[b] +
                 std::size_t(j) * stride[c];
        };
        double kk = 0, kq = 0, qq = 0, kv[3] = {}, qv[3] = {};
        bool felt = false;
        for (int k = -ghosts; k <= 2; ++k) {
          const double m = nodes[at(k)].folded, q = k * k - inertia;
          felt |= k <= 0 && m > 0;
          kk += m * k * k, kq += m * k * q, qq += m * q * q;
          for (int x = 0; x < 3; ++x) kv[x] += m * k * (motion[at(k)].*V)[x], qv[x] += m * q * (motion[at(k)].*V)[x];
        }
        if (!felt) continue;
        const double det = kk * qq - kq * kq;
        for (int k = -ghosts; k <= 2; ++k)
          for (int x = 0; x < 3; ++x) {
            const double slope = (qq * kv[x] - kq * qv[x]) / det, bend = (kk * qv[x] - kq * kv[x]) / det;
            (motion[at(k)].*V)[x] = slope * k + bend * (k * k - inertia);
          }
      }
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

  /// The same for all ghosts of a plane.
  template <class F>
  void each_ghost(const Plane& plane, F f) const {
    for (int layer = 1; layer <= ghosts; ++layer) each_pair(plane, layer, f);
  }

  /// p/m with the images folded onto the real nodes (one axis after the other, so all products of planes come in),
  /// zero where a plane holds the node, a parabola near walls, mirrored back onto the ghosts.
  template <double (Motion::*V)[3], bool FoldMass>
  void divide(const std::vector<Plane>& planes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Node& n = nodes[i];
      if (FoldMass) n.folded = n.m;
      const double over_m = !planes.empty() ? 1 : (n.folded > 0 ? 1 / n.folded : 0);
      for (int a = 0; a < 3; ++a) {
        (motion[i].*V)[a] = n.p[a] * over_m;
        if (V == &Motion::v) n.p[a] = 0;
      }
    }
    if (planes.empty()) return;
    std::vector<Plane> mirrors, walls;
    for (const Plane& plane : planes) (bends(plane) ? walls : mirrors).push_back(plane);
    for (const Plane& plane : mirrors)
      each_ghost(plane, [&](std::size_t real, std::size_t image) {
        if (FoldMass) nodes[real].folded += nodes[image].folded;
        for (int a = 0; a < 3; ++a) (motion[real].*V)[a] += plane.sign(a) * (motion[image].*V)[a];
      });
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (double& v : motion[i].*V) v = nodes[i].folded > 0 ? v / nodes[i].folded : 0;
    for (const Plane& plane : mirrors)
      each_pair(plane, 0, [&](std::size_t real, std::size_t) {
        for (int a = 0; a < 3; ++a)
          if (plane.sign(a) < 0) (motion[real].*V)[a] = 0;
      });
    for (const Plane& plane : walls) fit_parabolas<V>(plane);
    for (const Plane& plane : mirrors)
      each_ghost(plane, [&](std::size_t real, std::size_t image) {
        for (int a = 0; a < 3; ++a) (motion[image].*V)[a] = plane.sign(a) * (motion[real].*V)[a];
      });
  }
};

}  // namespace textbook
