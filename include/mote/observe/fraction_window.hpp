/// \file
/// Volume fraction of a cloud of particles on the mesh nodes of a window, with planes and periodic axes.
#pragma once

#include <mote/core/error.hpp>
#include <mote/core/vec.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace mote::observe {

/// One axis of the simulated domain, m. A plane (wall or symmetry plane) lies on a mesh node, no material is beyond it.
/// A free side does not bound the body; there `from` (or `to`) only says where the mesh's nodes are.
struct Extent {
  enum Kind { free_, plane, periodic };  ///< periodic: both sides or none
  double from, to;
  Kind lower = free_, upper = free_;
  bool mirrored = false;  ///< the lower side is a symmetry plane through the void: measure its mirror image too
};

/// Columns of some particles, all of the same length: positions, m, at most two cells beyond a periodic side, and
/// current volumes, m^3, as volume, or as scale * volume * ratio (1/rho0, mass, J) where there is a ratio.
template <class T>
struct ParticleColumns {
  std::span<const T> x, y, z, volume, ratio = {};
  double scale = 1;

  double volume_of(std::size_t p) const { return scale * double(volume[p]) * (ratio.empty() ? 1.0 : double(ratio[p])); }
  void validate() const {
    require(y.size() == x.size() && z.size() == x.size() && volume.size() == x.size() &&
                (ratio.empty() || ratio.size() == x.size()),
            "the columns of the particles have unequal lengths");
  }
};

/// A box of mesh nodes, both ends included; empty where lo > hi.
struct NodeBox {
  IVec<3> lo, hi;
};

/// The box with `by` more nodes on each side.
inline NodeBox grown(const NodeBox& b, int by) { return {b.lo - IVec<3>::filled(by), b.hi + IVec<3>::filled(by)}; }

/// The smallest box that holds the nodes, at least one.
inline NodeBox box_around(std::span<const IVec<3>> nodes) {
  NodeBox b{nodes[0], nodes[0]};
  for (const auto& c : nodes)
    for (int a = 0; a < 3; ++a) {
      b.lo[a] = std::min(b.lo[a], c[a]);
      b.hi[a] = std::max(b.hi[a], c[a]);
    }
  return b;
}

/// Calls f(node) for all nodes of the box, x fastest.
template <class F>
void for_box(const NodeBox& b, F&& f) {
  IVec<3> c{};
  for (c[2] = b.lo[2]; c[2] <= b.hi[2]; ++c[2])
    for (c[1] = b.lo[1]; c[1] <= b.hi[1]; ++c[1])
      for (c[0] = b.lo[0]; c[0] <= b.hi[0]; ++c[0]) f(c);
}

/// The particles' volume fraction phi on the nodes of a window: volume spread by linear hats over control volume, which
/// is half a cell's on a plane, a quarter where two meet. Particles just beyond a plane count as their mirror image.
///
/// The window is a dense array with one more layer of nodes around it, which holds images at planes and where a whole
/// period is in the window, and is incomplete elsewhere. Node i of axis a is at origin + i h; a lower plane is node 0.
class FractionWindow {
 public:
  using Node = IVec<3>;

  /// spacing: h, m, > 0; domain: x, y, z.
  FractionWindow(double spacing, const std::array<Extent, 3>& domain) : h_(spacing), domain_(domain) {
    require(spacing > 0 && std::isfinite(spacing), "the mesh spacing is ", spacing, " m; it must be > 0");
    for (int a = 0; a < 3; ++a) {
      const Extent& e = domain[a];
      const double cells = (e.to - e.from) / h_;
      require(cells > 0 && cells < 1e8, "the domain reaches from ", e.from, " to ", e.to, " m; it must have a length");
      period_[a] = int(std::lround(cells));
      require((e.lower == Extent::periodic) == (e.upper == Extent::periodic), "one side is periodic, the other not");
      require(e.lower == Extent::free_ || e.upper == Extent::free_ || std::abs(cells - period_[a]) < 1e-6,
              "the domain is ", cells, " cells long between two planes; it must be a whole number");
      require(!e.mirrored || e.lower == Extent::plane, "a mirrored axis must have a plane at its lower side");
      origin_[a] = e.upper == Extent::plane ? e.to - period_[a] * h_ : e.from;
    }
  }

  /// Fills the window with the particles that reach it; it is clipped at planes, and widened to a period if almost one.
  template <class T>
  void fill(const NodeBox& wanted, std::span<const ParticleColumns<T>> chunks) {
    set_window(wanted);
    deposit(chunks);
    finish();
  }

  /// The nodes around all material and a few of the empty space; empty without particles.
  template <class T>
  NodeBox body(std::span<const ParticleColumns<T>> chunks) const {
    NodeBox b{Node::filled(1), Node::filled(0)};
    for (int a = 0; a < 3; ++a) {
      double lo = std::numeric_limits<double>::infinity(), hi = -lo;
      for (const auto& p : chunks)
        for (const T& x : a == 0 ? p.x : a == 1 ? p.y : p.z) {
          lo = x < lo ? double(x) : lo;
          hi = x > hi ? double(x) : hi;
        }
      if (lo > hi) return {Node::filled(1), Node::filled(0)};
      const double u = (lo - origin_[a]) / h_, v = (hi - origin_[a]) / h_;
      if (!(std::abs(u) < 1e8 && std::abs(v) < 1e8))
        throw NumericalError(text("mote: a particle left for ", std::abs(u) < 1e8 ? hi : lo, " m; no void is found"));
      b.lo[a] = periodic(a) ? 0 : int(std::floor(u)) - 3;
      b.hi[a] = periodic(a) ? period_[a] : int(std::ceil(v)) + 3;
      if (domain_[a].lower == Extent::plane) b.lo[a] = 0;
      if (domain_[a].upper == Extent::plane) b.hi[a] = period_[a];
    }
    return b;
  }

  bool periodic(int a) const { return domain_[a].lower == Extent::periodic; }
  bool lower_plane(int a) const { return domain_[a].lower == Extent::plane && window_.lo[a] == 0; }
  bool upper_plane(int a) const { return domain_[a].upper == Extent::plane && window_.hi[a] == period_[a]; }

  bool whole_period(int a) const { return whole_[a]; }
  int period(int a) const { return period_[a]; }
  const NodeBox& nodes() const { return window_; }
  const Extent& extent(int a) const { return domain_[a]; }
  std::ptrdiff_t stride(int a) const { return stride_[a]; }
  std::size_t size() const { return fraction_.size(); }
  double operator[](std::ptrdiff_t i) const { return fraction_[i]; }
  /// Coordinate x of axis a in mesh units, from node 0.
  double index(int a, double x) const { return (x - origin_[a]) / h_; }

  /// Place of a node of the window, or of the layer around it, in the arrays.
  std::ptrdiff_t place(const Node& c) const {
    std::ptrdiff_t i = 0;
    for (int a = 0; a < 3; ++a) i += stride_[a] * (c[a] - window_.lo[a] + 1);
    return i;
  }

  /// The same for a node or one of its periodic images; -1 outside the window.
  std::ptrdiff_t find(Node c) const {
    for (int a = 0; a < 3; ++a) {
      const int lo = window_.lo[a], hi = window_.hi[a], n = period_[a];
      if (periodic(a)) {
        while (c[a] < lo) c[a] += n;
        while (c[a] > hi && c[a] - n >= lo) c[a] -= n;
      }
      if (c[a] < lo || c[a] > hi) return -1;
    }
    return place(c);
  }

  /// Part of a full cell that belongs to the node c (1, or 1/2 on a plane, 1/4 ...).
  double share(const Node& c) const {
    double s = 1;
    for (int a = 0; a < 3; ++a) {
      if (lower_plane(a) && c[a] == 0) s *= 0.5;
      if (upper_plane(a) && c[a] == period_[a]) s *= 0.5;
    }
    return s;
  }

 private:
  // Clips the window at planes, or takes the whole period; around it the arrays have one more layer of nodes.
  void set_window(const NodeBox& wanted) {
    window_ = wanted;
    double nodes = 1;
    for (int a = 0; a < 3; ++a) {
      int &lo = window_.lo[a], &hi = window_.hi[a];
      if (domain_[a].lower == Extent::plane) lo = std::max(lo, 0);
      if (domain_[a].upper == Extent::plane) hi = std::min(hi, period_[a]);
      whole_[a] = periodic(a) && hi - lo + 2 > period_[a];
      if (periodic(a)) {  // the image that starts in the domain
        const int n = period_[a], start = (lo % n + n) % n;
        hi += start - lo;
        lo = start;
      }
      if (whole_[a]) lo = 0, hi = period_[a] - 1;
      hi = std::max(lo, hi);
      size_[a] = hi - lo + 3;
      nodes *= size_[a];
    }
    if (nodes > 1e8) throw NumericalError(text("mote: the particles are scattered over ", nodes, " nodes; no void"));
    stride_ = {1, size_[0], std::ptrdiff_t(size_[0]) * size_[1]};
    fraction_.assign(std::size_t(nodes), 0.0);
  }

  // A cheap test by position that lets through all particles near the window, and some others.
  template <class T>
  struct Sieve {
    T lo, hi;
    bool outside;
    unsigned operator()(T x) const { return (unsigned(x >= lo) & unsigned(x < hi)) ^ unsigned(outside); }
  };

  template <class T>
  Sieve<T> sieve(int a) const {
    const double from = window_.lo[a] - 2, to = window_.hi[a] + 2, n = period_[a];
    const auto at = [&](double u) { return T(origin_[a] + h_ * u); };
    if (!periodic(a)) return {at(from), at(to), false};
    if (whole_[a] || to - from >= n) return {T(0), T(0), true};
    const double start = from - n * std::floor(from / n), end = start + (to - from);
    if (end > n) return {at(end - n), at(start), true};
    constexpr double beyond = 2;  // particles up to so many cells beyond a side pass, since they stand for their images
    if (start >= beyond && end <= n - beyond) return {at(start), at(end), false};
    if (start < beyond) return {at(end), at(end > n - beyond ? end : n), true};
    return {at(0), at(start), true};
  }

  template <class T>
  void deposit(std::span<const ParticleColumns<T>> chunks) {
    constexpr std::size_t block = 1024;
    std::array<std::uint32_t, block> chosen;
    const Sieve<T> in_x = sieve<T>(0), in_y = sieve<T>(1), in_z = sieve<T>(2);
    for (const auto& p : chunks)
      for (std::size_t begin = 0; begin < p.x.size(); begin += block) {
        const std::size_t n = std::min(block, p.x.size() - begin);
        const T *x = p.x.data() + begin, *y = p.y.data() + begin, *z = p.z.data() + begin;
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i) {
          if (!in_z(z[i])) continue;  // predictable where particles are sorted, and spares reading x and y
          chosen[count] = std::uint32_t(i);
          count += in_x(x[i]) & in_y(y[i]);
        }
        for (std::size_t i = 0; i < count; ++i)
          spread({double(x[chosen[i]]), double(y[chosen[i]]), double(z[chosen[i]])}, p.volume_of(begin + chosen[i]));
      }
  }

  // Adds one particle's volume to the eight nodes around it, if they are in the window.
  void spread(const Vec<double, 3>& x, double volume) {
    std::ptrdiff_t at = 0;
    double w[3][2];
    for (int a = 0; a < 3; ++a) {
      double r = (x[a] - origin_[a]) * per_h_ - (window_.lo[a] - 1);
      if (periodic(a)) r = r < 0 ? r + period_[a] : r >= period_[a] ? r - period_[a] : r;
      if (!(r >= 0 && r < size_[a] - 1)) return;
      const int cell = int(r);
      w[a][1] = r - cell;
      w[a][0] = 1 - w[a][1];
      at += cell * stride_[a];
    }
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 2; ++j) {
        double* f = fraction_.data() + at + k * stride_[2] + j * stride_[1];
        const double v = volume * w[2][k] * w[1][j];
        f[0] += v * w[0][0];
        f[1] += v * w[0][1];
      }
  }

  // Calls f(i, ghost, image) for all pairs of a layer outside the domain and the nodes that it stands for.
  template <class F>
  void for_ghosts(int a, F&& f) {
    const int last = size_[a] - 1;
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    for (int j = 0; j < size_[b]; ++j)
      for (int k = 0; k < size_[c]; ++k) {
        double* row = fraction_.data() + j * stride_[b] + k * stride_[c];
        if (lower_plane(a)) f(row[0], row[2 * stride_[a]]);
        if (upper_plane(a)) f(row[last * stride_[a]], row[(last - 2) * stride_[a]]);
        if (whole_[a]) f(row[0], row[(last - 1) * stride_[a]]);
        if (whole_[a]) f(row[last * stride_[a]], row[stride_[a]]);
      }
  }

  // Volumes become fractions, the layer around the window is filled where it has images.
  void finish() {
    for (int a = 0; a < 3; ++a) for_ghosts(a, [](double& ghost, double& image) { image += ghost; });
    const double per_cell = 1 / (h_ * h_ * h_);
    for_box(window_, [&](const Node& c) { fraction_[place(c)] *= per_cell / share(c); });
    for (int a = 0; a < 3; ++a) for_ghosts(a, [](double& ghost, double& image) { ghost = image; });
  }

  double h_, per_h_ = 1 / h_;
  std::array<Extent, 3> domain_;
  Vec<double, 3> origin_{};
  Node period_{};  // nodes from one end of the axis to the other
  NodeBox window_{};
  bool whole_[3] = {};  // the window holds the whole period
  Node size_{};
  std::array<std::ptrdiff_t, 3> stride_{};
  std::vector<double> fraction_;
};

}  // namespace mote::observe
