/// \file
/// Mirror planes on the grid: the images of a node, and what it shares with them.
#pragma once

#include <array>
#include <cstdint>

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

/// A node and its images beyond the planes, which carry the same velocity up to signs.
template <int D>
struct Images {
  struct Image {
    std::size_t node;
    std::array<bool, D> odd;
    unsigned walls;  ///< planes without a body beyond them that lie between the node and the image
  };
  std::array<Image, 64> image;  ///< four per axis with two planes at most: itself, in each of them, and in both
  int count = 0;
  std::array<int, D> held;   ///< per component: the boundary part that flips it in some image or on its plane, or -1
  std::array<bool, D> zero;  ///< per component: vanishes, since the node lies on a plane that flips it
  std::array<bool, D> zero_by_symmetry;  ///< the same for planes with a body beyond them alone
  Vec<double, D> frame_velocity{};       ///< velocity of the planes, m/s; what they carry and demand is meant beside it

  /// False if the node is itself beyond a plane, or if no plane concerns it.
  template <class T>
  bool find(std::size_t number_of_node, const grid::Domain<D>& domain, const grid::Blocks<T, D>& blocks, int support) {
    return find(number_of_node, domain, blocks, blocks.mass, support);
  }
  /// The same where another node field than the mass says which images count.
  template <class T>
  bool find(std::size_t number_of_node, const grid::Domain<D>& domain, const grid::Blocks<T, D>& blocks,
            const AlignedVector<T>& mass, int support) {
    const IVec<D> node = blocks.coordinates(number_of_node);
    if (!concern(node, domain, support)) return false;
    count = 1;
    image[0] = {number_of_node, {}, 0};
    Places at;
    at[0] = node;
    for (int a = 0; a < D; ++a) {
      // A node on a plane is its own image in it, but its images in the opposite plane are not: that one comes first.
      const auto& lower = domain.plane(a, 0);
      const int first = lower && lower->node == node[a] ? 1 : 0;
      for (int end : {first, 1 - first})
        if (const auto& plane = domain.plane(a, end); plane && depth(*plane, a, end, node) <= ghosts(support))
          mirror(*plane, a, end, at);
    }
    drop_massless(at, blocks, mass);
    return true;
  }

  template <class T>
  Vec<T, D> reflect(Vec<T, D> v, const Image& i) const {
    for (int c = 0; c < D; ++c) v[c] = i.odd[std::size_t(c)] ? -v[c] : v[c];
    return v;
  }

  /// Mass-weighted mean of a velocity over the images, beside that of the planes: the field's projection on what the
  /// planes allow.
  template <class T>
  Vec<T, D> mean(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, T& mass) const {
    return mean_over(blocks, field, mass, zero, [](const Image&) { return true; });
  }

  /// The same over symmetry planes only, seen from image k: what a whole body would have on its node.
  template <class T>
  Vec<T, D> symmetric_mean(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, int k) const {
    const Image& from = image[std::size_t(k)];
    T mass;
    return reflect(
        mean_over(blocks, field, mass, zero_by_symmetry, [&](const Image& i) { return i.walls == from.walls; }), from);
  }

 private:
  using Places = std::array<IVec<D>, 64>;

  /// Layers from a plane into the domain.
  static std::int32_t depth(const grid::Plane<D>& plane, int axis, int end, const IVec<D>& node) {
    return end ? plane.node - node[axis] : node[axis] - plane.node;
  }

  /// What the planes demand of a node's components. \return whether it lies near one and beyond none
  bool concern(const IVec<D>& node, const grid::Domain<D>& domain, int support) {
    held.fill(-1);
    zero.fill(false);
    zero_by_symmetry.fill(false);
    bool concerned = false;
    for (int a = 0; a < D; ++a)
      for (int end = 0; end < 2; ++end) {
        const auto& plane = domain.plane(a, end);
        if (!plane) continue;
        const std::int32_t layer = depth(*plane, a, end, node);
        if (layer < 0) return false;
        if (layer > ghosts(support)) continue;
        concerned = true;
        for (std::size_t c = 0; c < std::size_t(D); ++c)
          if (plane->odd[c]) {
            if (held[c] < 0) held[c] = plane->part;
            zero[c] |= layer == 0;
            zero_by_symmetry[c] |= layer == 0 && plane->body_beyond;
          }
      }
    return concerned;
  }

  /// Adds the images in a plane of all images so far.
  void mirror(const grid::Plane<D>& plane, int axis, int end, Places& at) {
    for (int i = 0, before = count; i < before; ++i) {
      const Image& from = image[std::size_t(i)];
      if (at[std::size_t(i)][axis] == plane.node) continue;
      at[std::size_t(count)] = at[std::size_t(i)];
      at[std::size_t(count)][axis] = 2 * plane.node - at[std::size_t(i)][axis];
      Image& to = image[std::size_t(count++)];
      to = {0, from.odd, from.walls ^ (plane.body_beyond ? 0u : 1u << (2 * axis + end))};
      for (std::size_t c = 0; c < std::size_t(D); ++c) to.odd[c] = from.odd[c] != plane.odd[c];
    }
  }

  /// Leaves the node itself and the images that particles reach. Not before all are there: an image with mass may be
  /// that of one without.
  template <class T>
  void drop_massless(const Places& at, const grid::Blocks<T, D>& blocks, const AlignedVector<T>& mass) {
    int left = 1;
    for (int i = 1; i < count; ++i) {
      const std::size_t number = blocks.find(at[std::size_t(i)]);
      if (number == blocks.none || mass[number] == T(0)) continue;
      image[std::size_t(left)] = image[std::size_t(i)];
      image[std::size_t(left++)].node = number;
    }
    count = left;
  }

  template <class T, class Counts>
  Vec<T, D> mean_over(const grid::Blocks<T, D>& blocks, const AlignedVector<T>& field, T& mass,
                      const std::array<bool, D>& vanishes, const Counts& counts) const {
    Vec<T, D> momentum{};
    const Vec<T, D> frame = cast<T>(frame_velocity);
    mass = T(0);
    for (int i = 0; i < count; ++i) {
      const Image& im = image[std::size_t(i)];
      if (!counts(im)) continue;
      mass += blocks.mass[im.node];
      momentum += blocks.mass[im.node] * reflect(node_vector<T, D>(field.data(), im.node) - frame, im);
    }
    for (int c = 0; c < D; ++c) momentum[c] = vanishes[std::size_t(c)] || !(mass > T(0)) ? T(0) : momentum[c] / mass;
    return momentum;
  }
};

}  // namespace mote::passes
