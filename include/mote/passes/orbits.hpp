/// \file
/// Planes on the grid: the nodes that a plane binds to free ones.
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
/// the particles at the wall are compressed at twice their rate, and pressures keep that (docs/accuracy.md). Kernels of
/// hats (Shape::inertia 0) and bodies thinner than five cells take the odd mirror.
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
  static constexpr std::size_t most_images = D == 1 ? 6 : D == 2 ? 36 : 216;

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
    if (!(inertia_ > 0) || plane->body_beyond || ghosts_ > 3) return false;
    for (const bool odd : plane->odd)
      if (!odd) return false;
    return !opposite || depth(*opposite, axis, 1 - end, {}) + depth(*plane, axis, end, {}) >= 3 + ghosts_;
  }

  template <class T>
  void add(std::uint32_t number, const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain) {
    const IVec<D> node = blocks.coordinates(number);
    Orbit<D> orbit{std::uint32_t(images_.size()), 0, 0, 0, 0, {}};
    if (!concern(node, domain, orbit)) return;
    Places
        place;  // six per axis at most: the layers of a wall; four for a node and its images in two planes and in both
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

}  // namespace mote::passes
