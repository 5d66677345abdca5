/// \file
/// Size of one void (the cavity) in a cloud of particles: volume, width and height, followed through time.
#pragma once

#include <mote/observe/fraction_window.hpp>

namespace mote::observe {

/// What VoidComponent measures. All zero if the void is gone; all nan if it is open.
struct VoidSize {
  double volume = 0;  ///< m^3, of the domain and its mirror images
  double width = 0;   ///< m, largest extent along x
  double height = 0;  ///< m, extent along z on the axis through the initial point
  bool open = false;  ///< connected to the space outside the body
};

/// Follows one void, sub-cell accurate, through a moving cloud of particles.
///
/// - phi(node) = particle volume spread by linear hats / control volume (half as much on a plane, 1/4 where two meet).
/// - Void: nodes with phi < 1/2, joined through their 6 neighbours. The component followed holds most nodes of the
///   last measured one (at first: of the cell around the initial point), or else of that one grown by a node. So of a
///   void that splits the larger part is followed, and a void smaller than about a cell is not seen.
/// - volume = sum of (1 - phi) x control volume over the component and its rim, the nodes at most 2 away along each
///   axis. The hats sum to one, so that this is exact where the material around is full. A rim node closer to another
///   void, or to the space outside, counts there; at equal distance, half. Noise of phi moves
///   volume between nodes and does not make it: only what crosses the rim's outer edge matters.
/// - A surface along a mesh row is where phi = 1/2, with two corrections. phi is not linear between nodes but, across
///   a plane, the integral of the hat: its inverse is interpolated, not phi. On a curved surface of curvatures
///   k1 + k2 the hats move phi = 1/2 by h^2 (k1 + k2)/12 inward: phi - (h^2/12) Laplacian(phi), Laplacian across the
///   row, takes that back. An extent is the longest connected piece of a row; it ends at planes, goes on in the mirror
///   image if there is one, and is at most a period.
/// - Rows miss the thickest place, or the axis, by a part of a cell: extents are interpolated between rows such that
///   (extent)^2 is quadratic (least squares over 3 x 3 rows, if there are), exact for ellipsoids.
///
/// Cost: one look at each particle, a deposit for those near the last component; all if it outgrew that neighbourhood.
/// Not thread safe: one object per thread. After an exception the last component is still known.
class VoidComponent {
 public:
  /// spacing: m, > 0; domain: x, y, z; initial: a point inside the void, m.
  VoidComponent(double spacing, const std::array<Extent, 3>& domain, const Vec<double, 3>& initial)
      : h_(spacing), initial_(initial), phi_(spacing, domain) {
    reset();
  }

  /// Forgets what was followed: the next void is the one at the initial point.
  void reset() {
    open_ = false;
    for (int a = 0; a < 3; ++a) {
      const double u = phi_.index(a, initial_[a]);
      box_.lo[a] = int(std::floor(u + 1e-6));
      box_.hi[a] = int(std::ceil(u - 1e-6));
    }
    followed_.clear();
    for_box(box_, [&](const Node& c) { followed_.push_back(c); });
  }

  /// Measures the void that was followed until now. A void that was found open stays open.
  /// Throws InputError for columns of unequal length, NumericalError if the particles are scattered too far to mesh.
  template <class T>
  VoidSize measure(std::span<const ParticleColumns<T>> chunks) {
    for (const auto& p : chunks) p.validate();
    if (open_) return opened();
    for (const bool all : {false, true}) {
      const NodeBox window = all ? phi_.body(chunks) : grown(box_, margin);
      if (window.lo[0] > window.hi[0]) return opened();
      phi_.fill(window, chunks);
      if (!find_component()) return {};
      if (clear_of_window(all ? 1 : margin - 1)) break;
      if (all) return opened();
    }
    followed_.assign(nodes_.begin() + first_, nodes_.begin() + last_);
    box_ = found_;
    return {volume(), h_ * width(), h_ * height(), false};
  }

  /// The same for particles in one chunk.
  template <class T>
  VoidSize measure(const ParticleColumns<T>& particles) {
    return measure(std::span<const ParticleColumns<T>>(&particles, 1));
  }

 private:
  using Node = IVec<3>;
  static constexpr int margin = 5;  // the rim (2), twice, for the rims of neighbours, and a node to grow
  static constexpr std::uint8_t far = 255;

  VoidSize opened() {
    open_ = true;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, true};
  }

  // Labels all voids of the window and chooses the one to follow: nodes_[first_, last_), own_, found_.
  bool find_component() {
    label_.assign(phi_.size(), 0);
    nodes_.clear();
    starts_.assign(1, 0);
    for_box(phi_.nodes(), [&](const Node& c) {
      if (phi_[phi_.place(c)] < 0.5 && label_[phi_.place(c)] == 0) flood(c);
    });
    hits_.assign(starts_.size(), 0);
    for (int reach = 0; reach < 2; ++reach) {
      for (const Node& f : followed_)
        for_box(grown({f, f}, reach), [&](const Node& c) {
          if (const auto i = phi_.find(c); i >= 0) ++hits_[label_[i]];
        });
      hits_[0] = 0;
      own_ = int(std::max_element(hits_.begin(), hits_.end()) - hits_.begin());
      if (own_ > 0) break;
    }
    if (own_ == 0) return false;
    first_ = starts_[own_ - 1], last_ = starts_[own_];
    found_ = box_around({nodes_.data() + first_, nodes_.data() + last_});
    return true;
  }

  // Gives the next label to all void nodes connected with `seed` and appends them to nodes_, periods unwrapped.
  void flood(const Node& seed) {
    const auto label = std::int32_t(starts_.size());
    std::size_t next = nodes_.size();
    const auto visit = [&](const Node& c) {
      const auto i = phi_.find(c);
      if (i < 0 || label_[i] != 0 || !(phi_[i] < 0.5)) return;
      label_[i] = label;
      nodes_.push_back(c);
    };
    for (visit(seed); next < nodes_.size(); ++next)
      for (int a = 0; a < 3; ++a)
        for (Node c = nodes_[next]; const int step : {-1, 2}) {
          c[a] += step;
          visit(c);
        }
    starts_.push_back(std::ptrdiff_t(nodes_.size()));
  }

  // Whether the component keeps `gap` nodes from all sides of the window where the domain goes on.
  bool clear_of_window(int gap) const {
    for (int a = 0; a < 3; ++a) {
      if (phi_.whole_period(a)) continue;
      if (!phi_.lower_plane(a) && found_.lo[a] - gap < phi_.nodes().lo[a]) return false;
      if (!phi_.upper_plane(a) && found_.hi[a] + gap > phi_.nodes().hi[a]) return false;
    }
    return true;
  }

  // m^3, of the component and its rim.
  double volume() {
    near_own_.assign(phi_.size(), far);
    near_other_.assign(phi_.size(), far);
    for (const Node& c : nodes_) stamp_rim(c);
    double sum = 0;
    for_box(phi_.nodes(), [&](const Node& c) {
      const auto i = phi_.place(c);
      const auto mine = near_own_[i], other = near_other_[i];
      if (label_[i] == own_ || (label_[i] == 0 && mine < other))
        sum += (1 - phi_[i]) * phi_.share(c);
      else if (label_[i] == 0 && mine == other && mine != far)
        sum += (1 - phi_[i]) * phi_.share(c) / 2;
    });
    for (int a = 0; a < 3; ++a) sum *= phi_.extent(a).mirrored ? 2 : 1;
    return sum * h_ * h_ * h_;
  }

  // Notes the squared distance to the void node c at all nodes around it, if c is on its void's surface.
  void stamp_rim(const Node& c) {
    const auto at = phi_.find(c);
    bool surface = false;
    for (int a = 0; a < 3; ++a) surface |= !label_[at - phi_.stride(a)] || !label_[at + phi_.stride(a)];
    if (!surface) return;
    auto& near = label_[at] == own_ ? near_own_ : near_other_;
    for_box({Node::filled(-2), Node::filled(2)}, [&](const Node& o) {
      if (const auto i = phi_.find(c + o); i >= 0) near[i] = std::min(near[i], std::uint8_t(dot(o, o)));
    });
  }

  // Signed distance of the node at i from the surface, in h, as if the surface were a plane across axis a; < 0 in void.
  double distance(int a, std::ptrdiff_t i) const {
    double phi = phi_[i];
    for (const int b : {(a + 1) % 3, (a + 2) % 3})
      phi -= (phi_[i - phi_.stride(b)] - 2 * phi_[i] + phi_[i + phi_.stride(b)]) / 12;
    return phi < 0.5 ? std::sqrt(2 * std::max(phi, 0.0)) - 1 : 1 - std::sqrt(2 * std::max(1 - phi, 0.0));
  }

  // How far the surface is beyond c, the component's last node on a row along a, in h; `step` (1, -1) leads out of it.
  double beyond(Node c, int a, int step) const {
    double last = 0;
    c[a] -= step;
    for (int k = -1; k <= 2; ++k, c[a] += step) {
      const auto i = phi_.find(c);
      if (i < 0) continue;
      const double d = distance(a, i);
      if (k > -1 && last < 0 && d >= 0) return k - d / (d - last);
      last = d;
    }
    return 0.5;
  }

  // Longest piece of the component, in h, on the row along a through c.
  double row(int a, Node c) const {
    const Extent& e = phi_.extent(a);
    const int n = phi_.period(a);
    for (int b = 0; b < 3; ++b) {
      if (b != a && phi_.lower_plane(b)) c[b] = std::abs(c[b]);
      if (b != a && phi_.upper_plane(b)) c[b] = phi_.period(b) - std::abs(phi_.period(b) - c[b]);
    }
    double longest = 0;
    const auto own_at = [&](int i) {
      c[a] = i;
      const auto at = phi_.find(c);
      return at >= 0 && label_[at] == own_;
    };
    for (int i = found_.lo[a]; i <= found_.hi[a]; ++i) {
      if (!own_at(i) || (own_at(i - 1) && i > found_.lo[a])) continue;
      int j = i;
      while (own_at(j + 1) && j < found_.hi[a]) ++j;
      if (phi_.whole_period(a) && j - i + 1 >= n) return n;
      const bool low = phi_.lower_plane(a) && i == 0, high = phi_.upper_plane(a) && j == n;
      double length = j - i;
      if (!low) c[a] = i, length += beyond(c, a, -1);
      if (!high) c[a] = j, length += beyond(c, a, 1);
      longest = std::max(longest, length * (e.mirrored && low ? 2 : 1));
    }
    return longest;
  }

  // Least squares quadratic through the squares of the 3 x 3 rows along a around c; not ok if a row is nil.
  struct Quadratic {
    bool ok = true;
    double value = 0, slope[2] = {}, bend[2] = {};  // value + slope.t + bend.t^2, t in h along the two other axes
    double own = 0;                                 // the square of the row at c itself
    // At c; the fit alone is rough on stairs, the row alone on noise.
    double centre() const { return (value + own) / 2; }
  };
  Quadratic fit(int a, const Node& c) const {
    Quadratic q;
    for (int i = 0; i < 9; ++i) {
      const int t[2] = {i % 3 - 1, i / 3 - 1};
      Node at = c;
      at[a == 0 ? 1 : 0] += t[0];
      at[a == 2 ? 1 : 2] += t[1];
      const double length = row(a, at), s = length * length;
      q.ok = q.ok && length > 0;
      q.value += s * (5 - 3 * t[0] * t[0] - 3 * t[1] * t[1]) / 9;
      if (i == 4) q.own = s;
      for (int k = 0; k < 2; ++k) {
        q.slope[k] += s * t[k] / 6;
        q.bend[k] += s * (3 * t[k] * t[k] - 2) / 6;
      }
    }
    return q;
  }

  // Largest row along x, in h: the top of the fit around the best of the long rows.
  double width() const {
    NodeBox rows = found_;
    rows.hi[0] = rows.lo[0];
    double longest = 0, best = 0, top = 0;
    for_box(rows, [&](const Node& c) { longest = std::max(longest, row(0, c)); });
    for_box(rows, [&](const Node& c) {
      if (row(0, c) < 0.9 * longest) return;
      const Quadratic q = fit(0, c);
      if (!q.ok || q.value <= best) return;
      best = q.value, top = q.centre();
      for (int k = 0; k < 2; ++k)
        if (q.bend[k] < 0) top += std::min(q.slope[k] * q.slope[k] / (-4 * q.bend[k]), -q.bend[k]);
    });
    return best > 0 ? std::sqrt(top) : longest;
  }

  // Row along z on the axis through the initial point, in h.
  double height() const {
    Node c = found_.lo;
    for (int b = 0; b < 2; ++b) c[b] = int(std::lround(phi_.index(b, initial_[b])));
    const Quadratic q = fit(2, c);
    if (!q.ok) return row(2, c);
    double squared = q.centre();
    for (int b = 0; b < 2; ++b) {
      const double t = phi_.index(b, initial_[b]) - c[b];
      squared += t * (q.slope[b] + t * q.bend[b]);
    }
    return std::sqrt(std::max(squared, 0.0));
  }

  double h_;
  Vec<double, 3> initial_;
  FractionWindow phi_;
  bool open_ = false;
  std::vector<Node> followed_;                       // the component last measured
  NodeBox box_{};                                    // and the box around it
  std::vector<std::int32_t> label_;                  // of nodes: 0 material, else the number of a void
  std::vector<Node> nodes_;                          // of all voids, one after the other
  std::vector<std::ptrdiff_t> starts_, hits_;        // where each void ends in nodes_; how much of followed_ it holds
  int own_ = 0;                                      // label of the component,
  std::ptrdiff_t first_ = 0, last_ = 0;              // its nodes in nodes_
  NodeBox found_{};                                  // and the box around them
  std::vector<std::uint8_t> near_own_, near_other_;  // squared distance of nodes to the nearest void node
};

}  // namespace mote::observe
