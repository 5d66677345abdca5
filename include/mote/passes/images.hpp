/// \file
/// Planes on the grid: the velocity fields that they allow (passes/orbits.hpp says which).
#pragma once

#include <array>
#include <cstdint>

#include <mote/core/vec.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/passes/orbits.hpp>

namespace mote::passes {

template <class T, int D>
Vec<T, D> node_vector(const T* field, std::size_t node) {
  Vec<T, D> v{};
  for (int i = 0; i < D; ++i) v[i] = field[node * grid::node_width<D> + std::size_t(i)];
  return v;
}
template <class T, int D>
void set_node_vector(T* field, std::size_t node, const Vec<T, D>& v) {
  for (int i = 0; i < D; ++i) field[node * grid::node_width<D> + std::size_t(i)] = v[i];
}

/// Of a free node near planes, it and those that it binds and particles reach in this step.
template <int D>
struct Images {
  static constexpr std::size_t most = Orbits<D>::most_images;

  std::array<Image<D>, most> image;
  int count = 0;
  Orbit<D> orbit;
  double inertia = 0;               ///< of the kernel
  Vec<double, D> frame_velocity{};  ///< velocity of the planes, m/s; what they carry and demand is meant beside it

  /// \param mass that of the nodes, or another field that is zero where no particle reaches
  template <class T>
  void take(const Orbits<D>& orbits, const Orbit<D>& from, const AlignedVector<T>& mass) {
    orbit = from;
    inertia = orbits.inertia();
    count = 0;
    for (const Image<D>& i : orbits.images(from))
      if (count == 0 || mass[i.node] != T(0)) image[std::size_t(count++)] = i;
  }
  /// Whether the planes change anything of it.
  bool bound() const { return count > 1 || orbit.zero != 0; }
  bool holds(int component) const { return orbit.held[std::size_t(component)] >= 0; }
  std::size_t holder(int component) const { return std::size_t(orbit.held[std::size_t(component)]); }

  template <class T>
  static Vec<T, D> reflect(Vec<T, D> v, const Image<D>& i) {
    for (int c = 0; c < D; ++c) v[c] = i.odd >> c & 1 ? -v[c] : v[c];
    return v;
  }

  /// The velocities nearest to a field's, by the kinetic energy of the difference, among those that the planes allow:
  /// of each image, beside the velocity of the planes. For mirrors alone it is the mean that masses weigh.
  template <class T>
  void project(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, Vec<T, D>* allowed) const {
    if (orbit.walls != 0) return project_on_parabolas(blocks, field, allowed);
    const Vec<T, D> mean = mean_over(blocks, field, orbit.zero, [](const Image<D>&) { return true; });
    for (int k = 0; k < count; ++k) allowed[k] = reflect(mean, image[std::size_t(k)]);
  }

  /// The mean over symmetry planes only, seen from image k: what a whole body would have on its node.
  template <class T>
  Vec<T, D> symmetric_mean(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, int k) const {
    const Image<D>& from = image[std::size_t(k)];
    return reflect(mean_over(blocks, field, orbit.zero_by_symmetry,
                             [&](const Image<D>& i) { return i.walls == from.walls && i.layer == from.layer; }),
                   from);
  }

 private:
  static constexpr int most_free = 1 << D;

  /// The parts of the free nodes in an image. Along the axis of a wall v_k = k v_1 + q (v_2 - 2 v_1), with q = 0 for
  /// k = 1 and q = 1 for k = 2. \return how many they are
  int parts(const Image<D>& i, double (&part)[most_free]) const {
    int free = 1;
    part[0] = 1;
    for (int a = 0; a < D; ++a) {
      if (!(orbit.walls >> a & 1)) continue;
      const double k = i.layer[std::size_t(a)], q = (k * k - inertia - k * (1 - inertia)) / (2 + inertia);
      for (int f = 0; f < free; ++f) {
        part[free + f] = q * part[f];
        part[f] *= k - 2 * q;
      }
      free *= 2;
    }
    return free;
  }

  /// Least squares with the masses as weights.
  template <class T>
  void project_on_parabolas(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, Vec<T, D>* allowed) const {
    double masses[most_free][most_free] = {}, part[most_free];
    Vec<double, D> velocity[most_free] = {};  // their momenta until they are solved for
    int free = 1;
    for (int k = 0; k < count; ++k) {
      const Image<D>& i = image[std::size_t(k)];
      free = parts(i, part);
      const double m = double(blocks.mass[i.node]);
      const Vec<double, D> v = reflect(cast<double>(node_vector<T, D>(field.data(), i.node)) - frame_velocity, i);
      for (int f = 0; f < free; ++f) {
        velocity[f] += m * part[f] * v;
        for (int g = 0; g < free; ++g) masses[f][g] += m * part[f] * part[g];
      }
    }
    solve(free, masses, velocity);
    for (int k = 0; k < count; ++k) {
      const Image<D>& i = image[std::size_t(k)];
      parts(i, part);
      Vec<double, D> v{};
      for (int f = 0; f < free; ++f) v += part[f] * velocity[f];
      for (int c = 0; c < D; ++c) v[c] = orbit.zero >> c & 1 ? 0.0 : v[c];
      allowed[k] = cast<T>(reflect(v, i));
    }
  }

  /// Gaussian elimination for a symmetric matrix that is positive definite, but for rows of zeros: free nodes that
  /// nothing reaches nor needs, which stay at rest.
  static void solve(int n, double (&a)[most_free][most_free], Vec<double, D> (&x)[most_free]) {
    for (int p = 0; p < n; ++p)
      for (int f = p + 1; f < n && a[p][p] > 0; ++f) {
        const double times = a[f][p] / a[p][p];
        for (int g = p; g < n; ++g) a[f][g] -= times * a[p][g];
        x[f] -= times * x[p];
      }
    for (int p = n - 1; p >= 0; --p) {
      for (int g = p + 1; g < n; ++g) x[p] -= a[p][g] * x[g];
      x[p] = a[p][p] > 0 ? (1 / a[p][p]) * x[p] : Vec<double, D>{};
    }
  }

  template <class T, class Counts>
  Vec<T, D> mean_over(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, unsigned vanishes,
                      const Counts& counts) const {
    Vec<T, D> momentum{};
    const Vec<T, D> frame = cast<T>(frame_velocity);
    T mass = T(0);
    for (int i = 0; i < count; ++i) {
      const Image<D>& im = image[std::size_t(i)];
      if (!counts(im)) continue;
      mass += blocks.mass[im.node];
      momentum += blocks.mass[im.node] * reflect(node_vector<T, D>(field.data(), im.node) - frame, im);
    }
    for (int c = 0; c < D; ++c) momentum[c] = vanishes >> c & 1 || !(mass > T(0)) ? T(0) : momentum[c] / mass;
    return momentum;
  }
};

}  // namespace mote::passes
