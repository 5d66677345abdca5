/// \file
/// Mirror planes on the grid: the images of a node, and what it shares with them.
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

/// A node that carries the velocity of another one, up to signs.
template <int D>
struct Image {
  std::uint32_t node;
  std::uint8_t odd;    ///< bit c: component c changes its sign
  std::uint8_t walls;  ///< bits of the planes without a body beyond them that lie between the node and the image
};

/// A node near planes and all its places beyond them, whether particles reach them or not.
template <int D>
struct Orbit {
  std::uint32_t images_begin;
  std::uint8_t images;              ///< the node itself comes first
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

 public:
  std::size_t blocks() const { return blocks_.size(); }
  std::uint32_t block(std::size_t i) const { return blocks_[i]; }
  std::span<const Orbit<D>> of_block(std::size_t i) const {
    return {orbits_.data() + begin_[i], orbits_.data() + begin_[i + 1]};
  }
  std::span<const Image<D>> images(const Orbit<D>& orbit) const {
    return {images_.data() + orbit.images_begin, orbit.images};
  }

  template <class T>
  void find(const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain, int support) {
    for (auto* numbers : {&blocks_, &begin_}) numbers->clear();
    orbits_.clear();
    images_.clear();
    for (std::uint32_t b = 0; b < blocks.index.size(); ++b) {
      if (!near_plane(blocks.index[b], domain, support)) continue;
      const auto before = std::uint32_t(orbits_.size());
      for (std::uint32_t i = 0; i < std::uint32_t(grid::block_nodes<D>); ++i)
        add(b * std::uint32_t(grid::block_nodes<D>) + i, blocks, domain, support);
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

  static bool near_plane(const IVec<D>& block, const grid::Domain<D>& domain, int support) {
    bool near = false;
    for (int a = 0; a < D; ++a)
      for (int end = 0; end < 2; ++end)
        if (const auto& plane = domain.plane(a, end)) {
          const std::int32_t first = block[a] * grid::block_edge;
          near |= first <= plane->node + ghosts(support) && first + grid::block_edge > plane->node - ghosts(support);
        }
    return near;
  }

  /// Layers from a plane into the domain.
  static std::int32_t depth(const grid::Plane<D>& plane, int axis, int end, const IVec<D>& node) {
    return end ? plane.node - node[axis] : node[axis] - plane.node;
  }

  template <class T>
  void add(std::uint32_t number, const grid::Blocks<T, D>& blocks, const grid::Domain<D>& domain, int support) {
    const IVec<D> node = blocks.coordinates(number);
    Orbit<D> orbit{std::uint32_t(images_.size()), 0, 0, 0, {}};
    if (!concern(node, domain, support, orbit)) return;
    std::array<Place, 64> place;  // four per axis with two planes at most: itself, in each of them, and in both
    std::size_t count = 1;
    place[0] = {node, {number, 0, 0}};
    for (int a = 0; a < D; ++a) {
      // A node on a plane is its own image in it, but its images in the opposite plane are not: that one comes first.
      const auto& lower = domain.plane(a, 0);
      const int first = lower && lower->node == node[a] ? 1 : 0;
      for (int end : {first, 1 - first})
        if (const auto& plane = domain.plane(a, end); plane && depth(*plane, a, end, node) <= ghosts(support))
          mirror(*plane, a, end, place, count);
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

  /// What the planes demand of a node's components. \return whether it lies near one and beyond none
  static bool concern(const IVec<D>& node, const grid::Domain<D>& domain, int support, Orbit<D>& orbit) {
    orbit.held.fill(-1);
    bool concerned = false;
    for (int a = 0; a < D; ++a)
      for (int end = 0; end < 2; ++end) {
        const auto& plane = domain.plane(a, end);
        if (!plane) continue;
        const std::int32_t layer = depth(*plane, a, end, node);
        if (layer < 0) return false;
        if (layer > ghosts(support)) continue;
        concerned = true;
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
  static void mirror(const grid::Plane<D>& plane, int axis, int end, std::array<Place, 64>& place, std::size_t& count) {
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
};

/// Of a node near planes, itself and those of its images that particles reach in this step.
template <int D>
struct Images {
  std::array<Image<D>, 64> image;
  int count = 0;
  Orbit<D> orbit;
  Vec<double, D> frame_velocity{};  ///< velocity of the planes, m/s; what they carry and demand is meant beside it

  /// \param mass that of the nodes, or another field that is zero where no particle reaches
  template <class T>
  void take(const Orbits<D>& orbits, const Orbit<D>& from, const AlignedVector<T>& mass) {
    orbit = from;
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

  /// Mass-weighted mean of a velocity over the images, beside that of the planes: the field's projection on what the
  /// planes allow.
  template <class T>
  Vec<T, D> mean(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, T& mass) const {
    return mean_over(blocks, field, mass, orbit.zero, [](const Image<D>&) { return true; });
  }

  /// The same over symmetry planes only, seen from image k: what a whole body would have on its node.
  template <class T>
  Vec<T, D> symmetric_mean(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, int k) const {
    const Image<D>& from = image[std::size_t(k)];
    T mass;
    return reflect(mean_over(blocks, field, mass, orbit.zero_by_symmetry,
                             [&](const Image<D>& i) { return i.walls == from.walls; }),
                   from);
  }

 private:
  template <class T, class Counts>
  Vec<T, D> mean_over(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, T& mass, unsigned vanishes,
                      const Counts& counts) const {
    Vec<T, D> momentum{};
    const Vec<T, D> frame = cast<T>(frame_velocity);
    mass = T(0);
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
