/// \file
/// Planes on the grid: the nodes that a plane binds to free ones, and the velocity fields that it allows.
///
/// At a symmetry plane a node beyond carries the velocity of its image, up to signs. A wall asks for one thing, that
/// the field vanish on the plane: near it, we let it be a parabola that does,
///
///   v(xi) = b xi + c xi^2,  v_k = b k + c (k^2 - s),
///
/// xi and k counted in cells from the plane inwards, s = Shape::inertia (what B-splines of coefficients k^2 are above
/// xi^2). The nodes 1 and 2 are free; they bind node 0 and those beyond. An odd mirror would also take the curvature on
/// the plane away. In one dimension waves have none there, but where metal slides along a wall that it sticks to it is
/// the first term of the normal velocity: nearly incompressible flow thins with the square of the height. Without it
/// the particles of the wall's cell strain by turns too much and too little, which pressures keep
/// (docs/accuracy.md). Kernels of hats (Shape::inertia 0) and bodies thinner than five cells take the odd mirror.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <mote/core/vec.hpp>
#include <mote/grid/blocks.hpp>
#include <mote/grid/domain.hpp>
#include <mote/passes/tiles.hpp>

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

/// A node that carries a combination of the velocities of free ones, up to signs.
template <int D>
struct Image {
  std::uint32_t node;
  std::uint8_t odd;                  ///< bit c: component c changes its sign
  std::uint8_t walls;                ///< bits of the mirrors without a body beyond them between the free node and it
  std::array<std::int8_t, D> layer;  ///< cells from a wall inwards; 1 along other axes
};

/// A free node near planes (and its neighbour from each wall inwards), and all that they bind, whether particles reach
/// it or not.
template <int D>
struct Orbit {
  std::uint32_t images_begin;
  std::uint8_t images;              ///< the free node itself comes first
  std::uint8_t walls;               ///< bit a: a wall's parabola goes along axis a
  std::uint8_t zero;                ///< bit c: component c vanishes, since the node lies on a plane that flips it
  std::uint8_t zero_by_symmetry;    ///< the same for planes with a body beyond them alone
  std::array<std::int8_t, D> held;  ///< per component: the boundary part that flips it, or -1
};

/// The orbits of all nodes near planes, by block; they change with the blocks, at sorts alone.
template <int D>
class Orbits {
  std::vector<std::uint32_t> blocks_, begin_;  ///< blocks near planes; their first orbits, and one more
  std::vector<Orbit<D>> orbits_;
  std::vector<Image<D>> images_;
  int ghosts_ = 0;
  double inertia_ = 0;

 public:
  static constexpr std::size_t most_images = D == 1 ? 5 : D == 2 ? 25 : 125;

  std::size_t blocks() const { return blocks_.size(); }
  std::uint32_t block(std::size_t i) const { return blocks_[i]; }
  std::span<const Orbit<D>> of_block(std::size_t i) const {
    return {orbits_.data() + begin_[i], orbits_.data() + begin_[i + 1]};
  }
  std::span<const Image<D>> images(const Orbit<D>& orbit) const {
    return {images_.data() + orbit.images_begin, orbit.images};
  }
  double inertia() const { return inertia_; }

  /// \param inertia Shape::inertia; 0: all planes are mirrors
  template <class T>
  void find(const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain, int support, double inertia) {
    for (auto* numbers : {&blocks_, &begin_}) numbers->clear();
    orbits_.clear();
    images_.clear();
    ghosts_ = ghosts(support);
    inertia_ = inertia;
    for (std::uint32_t b = 0; b < blocks.index.size(); ++b) {
      if (!near_plane(blocks.index[b], domain)) continue;
      const auto before = std::uint32_t(orbits_.size());
      for (std::uint32_t i = 0; i < std::uint32_t(grid::block_nodes<D>); ++i)
        add(b * std::uint32_t(grid::block_nodes<D>) + i, blocks, domain);
      if (orbits_.size() == before) continue;
      blocks_.push_back(b);
      begin_.push_back(before);
    }
    begin_.push_back(std::uint32_t(orbits_.size()));
  }

 private:
  struct Place {
    IVec<D> at;
    Image<D> image;
  };
  using Places = std::array<Place, most_images>;

  bool near_plane(const IVec<D>& block, const grid::Domain<D>& domain) const {
    bool near = false;
    for (int a = 0; a < D; ++a)
      for (int end = 0; end < 2; ++end)
        if (const auto& plane = domain.plane(a, end)) {
          const std::int32_t first = block[a] * grid::block_edge;
          near |= first <= plane->node + ghosts_ && first + grid::block_edge > plane->node - ghosts_;
        }
    return near;
  }

  /// Layers from a plane into the domain.
  static std::int32_t depth(const grid::Plane<D>& plane, int axis, int end, const IVec<D>& node) {
    return end ? plane.node - node[axis] : node[axis] - plane.node;
  }

  /// Whether the field near a plane is a parabola rather than mirrored: at walls that hold all components, with room
  /// for the two free nodes and for the images in the plane opposite.
  bool parabola(const grid::Domain<D>& domain, int axis, int end) const {
    const auto &plane = domain.plane(axis, end), &opposite = domain.plane(axis, 1 - end);
    if (!(inertia_ > 0) || plane->body_beyond) return false;
    for (const bool odd : plane->odd)
      if (!odd) return false;
    return !opposite || depth(*opposite, axis, 1 - end, {}) + depth(*plane, axis, end, {}) >= 3 + ghosts_;
  }

  template <class T>
  void add(std::uint32_t number, const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain) {
    const IVec<D> node = blocks.coordinates(number);
    Orbit<D> orbit{std::uint32_t(images_.size()), 0, 0, 0, 0, {}};
    if (!concern(node, domain, orbit)) return;
    Places place;  // five per axis at most: the layers of a wall, or a node and its images in two planes and in both
    std::size_t count = 1;
    place[0] = {node, {number, 0, 0, {}}};
    place[0].image.layer.fill(1);
    for (int a = 0; a < D; ++a) {
      // A node on a plane is its own image in it, but its images in the opposite plane are not: that one comes first.
      const auto& lower = domain.plane(a, 0);
      const int first = lower && lower->node == node[a] ? 1 : 0;
      for (int end : {first, 1 - first})
        if (const auto& plane = domain.plane(a, end); plane && depth(*plane, a, end, node) <= ghosts_) {
          if (parabola(domain, a, end))
            layers(*plane, a, end, place, count);
          else
            mirror(*plane, a, end, place, count);
        }
    }
    // not before all are there: a place that has a block may be the image of one that has none
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t found = blocks.find(place[i].at);
      if (found == blocks.none) continue;
      place[i].image.node = std::uint32_t(found);
      images_.push_back(place[i].image);
      ++orbit.images;
    }
    orbits_.push_back(orbit);
  }

  /// What the planes demand of a node's components. \return whether it lies near one and beyond none, and is the first
  /// of a wall's free nodes where it is near a wall
  bool concern(const IVec<D>& node, const grid::Domain<D>& domain, Orbit<D>& orbit) const {
    orbit.held.fill(-1);
    bool concerned = false;
    for (int a = 0; a < D; ++a)
      for (int end = 0; end < 2; ++end) {
        const auto& plane = domain.plane(a, end);
        if (!plane) continue;
        const std::int32_t layer = depth(*plane, a, end, node);
        if (layer < 0) return false;
        const bool bends = parabola(domain, a, end);
        if (layer > (bends ? 2 : ghosts_)) continue;
        if (bends && layer != 1) return false;
        concerned = true;
        if (bends) orbit.walls |= std::uint8_t(1u << a);
        for (std::size_t c = 0; c < std::size_t(D); ++c) {
          if (!plane->odd[c]) continue;
          if (orbit.held[c] < 0) orbit.held[c] = std::int8_t(plane->part);
          if (layer == 0) orbit.zero |= std::uint8_t(1u << c);
          if (layer == 0 && plane->body_beyond) orbit.zero_by_symmetry |= std::uint8_t(1u << c);
        }
      }
    return concerned;
  }

  /// Adds the images in a plane of all images so far.
  static void mirror(const grid::Plane<D>& plane, int axis, int end, Places& place, std::size_t& count) {
    for (std::size_t i = 0, before = count; i < before; ++i) {
      if (place[i].at[axis] == plane.node) continue;
      Place& to = place[count++];
      to = place[i];
      to.at[axis] = 2 * plane.node - to.at[axis];
      if (!plane.body_beyond) to.image.walls ^= std::uint8_t(1u << (2 * axis + end));
      for (std::size_t c = 0; c < std::size_t(D); ++c)
        if (plane.odd[c]) to.image.odd ^= std::uint8_t(1u << c);
    }
  }

  /// Adds the other nodes of a wall's parabola for all images so far, which lie in layer 1.
  void layers(const grid::Plane<D>& plane, int axis, int end, Places& place, std::size_t& count) const {
    for (std::size_t i = 0, before = count; i < before; ++i)
      for (int layer = 2; layer >= -ghosts_; --layer) {
        if (layer == 1) continue;
        Place& to = place[count++];
        to = place[i];
        to.at[axis] = plane.node + (end ? -layer : layer);
        to.image.layer[std::size_t(axis)] = std::int8_t(layer);
      }
  }
};

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
