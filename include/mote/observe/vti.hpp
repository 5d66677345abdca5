/// \file
/// Frames of grid fields for viewers: a .vti file per time and a .pvd that lists them.
#pragma once

#include <mote/observe/frame_series.hpp>

namespace mote::observe {

namespace detail {

/// The arrays of one frame on the nodes of a box, x fastest: particles spread by linear hats on the solver's mesh.
template <class Solver>
class NodeFrame {
  static constexpr int D = Solver::dimension;
  using T = typename Solver::number;
  enum Sum { volume, mass, push, heat, heated, momentum, sums = momentum + D };

  const Solver& solver_;
  std::array<std::int64_t, 3> lo_{}, hi_{};
  std::array<std::vector<double>, sums> sums_;
  std::vector<FrameColumn> columns_;

 public:
  /// `whole`: axes on which the box begins at the lower plane, since an image is to join there.
  NodeFrame(const Solver& solver, const std::vector<int>& whole) : solver_(solver) {
    for (int a = 0; a < D; ++a) find_box(a, std::find(whole.begin(), whole.end(), a) != whole.end());
    require(count() < 1e8, "a grid frame of ", count(),
            " nodes is too large: a particle has flown far off; leave Vti out");
    solver.executor().for_each(sums, [&](std::size_t i) { deposit(int(i)); });
    make_columns();
  }

  /// Adds the image about the lower end of the box along an axis.
  void mirror(int axis) {
    const auto a = std::size_t(axis);
    const auto lo = lo_, hi = hi_;
    lo_[a] = 2 * lo[a] - hi[a];
    for (auto& column : columns_) {
      const std::size_t width = column.components();
      FrameNumbers data(false, width * std::size_t(count()));
      std::size_t to = 0;
      for_nodes([&](std::array<std::int64_t, 3> node) {
        const bool image = node[a] < lo[a];
        if (image) node[a] = 2 * lo[a] - node[a];
        const std::size_t from = width * place(node, lo, hi);
        for (std::size_t c = 0; c < width; ++c) {
          const double x = column.data[from + c];
          data.put(to++, image && (column.parities[c] >> axis & 1) ? 0 - x : x);
        }
      });
      column.data = std::move(data);
    }
  }

  void write(const std::filesystem::path& file) const {
    Lattice lattice{};
    for (std::size_t a = 0; a < 3; ++a) {
      lattice.spacing[a] = solver_.spacing();
      lattice.origin[a] = a < std::size_t(D) ? solver_.frame().origin[int(a)] : 0;
      lattice.extent[2 * a] = int(lo_[a]), lattice.extent[2 * a + 1] = int(hi_[a]);
    }
    std::vector<Array> arrays;
    for (const auto& column : columns_) arrays.push_back(column.array());
    write_vti(file, lattice, arrays, {}, solver_.time());
  }

 private:
  using Place = std::array<std::int64_t, 3>;

  double count() const {
    double n = 1;
    for (std::size_t a = 0; a < 3; ++a) n *= double(hi_[a] - lo_[a] + 1);
    return n;
  }
  static std::size_t place(const Place& node, const Place& lo, const Place& hi) {
    std::int64_t i = 0;
    for (std::size_t a = 3; a-- > 0;) i = i * (hi[a] - lo[a] + 1) + (node[a] - lo[a]);
    return std::size_t(i);
  }
  template <class F>
  void for_nodes(const F& f) const {
    Place n;
    for (n[2] = lo_[2]; n[2] <= hi_[2]; ++n[2])
      for (n[1] = lo_[1]; n[1] <= hi_[1]; ++n[1])
        for (n[0] = lo_[0]; n[0] <= hi_[0]; ++n[0]) f(n);
  }

  /// Coordinate x in cells, in the period, and inside of planes: what is a little beyond counts as its mirror image.
  double cells(int a, double x) const {
    const auto& frame = solver_.frame();
    double u = (solver_.domain().wrapped_position(a, x) - frame.origin[a]) / frame.spacing;
    if (const auto& plane = solver_.domain().plane(a, 0)) u = plane->node + std::abs(u - plane->node);
    if (const auto& plane = solver_.domain().plane(a, 1)) u = plane->node - std::abs(plane->node - u);
    return u;
  }

  /// The whole period, or a node more than the particles reach but not beyond planes.
  void find_box(int a, bool whole) {
    const auto& domain = solver_.domain();
    auto &lo = lo_[std::size_t(a)], &hi = hi_[std::size_t(a)];
    if (const auto& period = domain.periodic(a)) {
      lo = period->from, hi = period->from + period->count;
      return;
    }
    double least = std::numeric_limits<double>::infinity(), most = -least;
    solver_.for_each_body([&](const auto&, const auto& particles) {
      for (const T x : particles.template column<field::Position>(a)) {
        const double u = cells(a, double(x));
        least = std::min(least, u), most = std::max(most, u);
      }
    });
    lo = std::int64_t(std::floor(least)) - 1, hi = std::int64_t(std::floor(most)) + 2;
    if (const auto& plane = domain.plane(a, 0)) lo = whole ? plane->node : std::max<std::int64_t>(lo, plane->node);
    if (const auto& plane = domain.plane(a, 1)) hi = std::min<std::int64_t>(hi, plane->node);
  }

  template <class Material, class Particles>
  static double amount(int sum, const Material& material, const Particles& particles, std::size_t p) {
    using State = particle_fields_of<Material>;
    const double m = double(particles.template column<field::Mass>()[p]);
    if (sum == mass) return m;
    if (sum >= momentum) return m * double(particles.template column<field::Velocity>(sum - momentum)[p]);
    if (sum == heat || sum == heated) {
      if constexpr (contains<State, field::Temperature>)
        return sum == heated ? m : m * double(particles.template column<field::Temperature>()[p]);
      return 0;
    }
    const double v = m * double(particles.template column<field::VolumeRatio>()[p]) / material.rho0();
    if (sum == volume) return v;
    Values<T, D, State> values;
    particles.load(p, values);
    return v * double(material.pressure(values));
  }

  void deposit(int sum) {
    auto& nodes = sums_[std::size_t(sum)];
    nodes.assign(std::size_t(count()), 0.0);
    solver_.for_each_body([&](const auto& material, const auto& particles) {
      for (std::size_t p = 0; p < particles.size(); ++p) {
        std::array<double, 3> part{};
        Place base = lo_;
        for (int a = 0; a < D; ++a) {
          const double u = cells(a, double(particles.template column<field::Position>(a)[p]));
          const auto b = std::min(std::int64_t(std::floor(u)), hi_[std::size_t(a)] - 1);
          base[std::size_t(a)] = b, part[std::size_t(a)] = u - double(b);
        }
        const double what = amount(sum, material, particles, p);
        for (unsigned k = 0; k < 1u << D; ++k) {
          double w = what;
          Place at = base;
          for (std::size_t a = 0; a < std::size_t(D); ++a) w *= k >> a & 1 ? part[a] : 1 - part[a], at[a] += k >> a & 1;
          nodes[place(at, lo_, hi_)] += w;
        }
      }
    });
    for (int a = 0; a < D; ++a)
      if (solver_.domain().periodic(a)) join_period(nodes, std::size_t(a));
  }

  /// The first and the last node of a period are the same.
  void join_period(std::vector<double>& nodes, std::size_t a) const {
    for_nodes([&](const Place& n) {
      if (n[a] != lo_[a]) return;
      Place end = n;
      end[a] = hi_[a];
      nodes[place(n, lo_, hi_)] = nodes[place(end, lo_, hi_)] += nodes[place(n, lo_, hi_)];
    });
  }

  /// Part of a cell that belongs to a node, in m^D.
  double control_volume(const Place& n) const {
    double v = 1;
    for (int a = 0; a < D; ++a) {
      v *= solver_.spacing();
      for (int end = 0; end < 2; ++end)
        if (const auto& plane = solver_.domain().plane(a, end); plane && n[std::size_t(a)] == plane->node) v /= 2;
    }
    return v;
  }
  /// Whether component c of the velocity vanishes on a node by symmetry.
  bool held(const Place& n, int c) const {
    for (int end = 0; end < 2; ++end)
      if (const auto& plane = solver_.domain().plane(c, end))
        if (plane->body_beyond && n[std::size_t(c)] == plane->node) return true;
    return false;
  }

  void make_columns() {
    const std::size_t n = std::size_t(count());
    const auto add = [&](const char* name, const std::vector<unsigned>& parities) {
      columns_.push_back({name, parities, FrameNumbers(false, parities.size() * n)});
    };
    add("volume_fraction", {0});
    add("density", {0});
    add("pressure", {0});
    add("velocity", {parity(0), parity(1), parity(2)});
    const bool warm = std::any_of(sums_[heated].begin(), sums_[heated].end(), [](double m) { return m > 0; });
    if (warm) add("temperature", {0});
    for_nodes([&](const Place& node) {
      const std::size_t i = place(node, lo_, hi_);
      const auto over = [&](int a, int b) {
        const double below = sums_[std::size_t(b)][i];
        return below > 0 ? sums_[std::size_t(a)][i] / below : 0;
      };
      columns_[0].data.put(i, sums_[volume][i] / control_volume(node));
      columns_[1].data.put(i, over(mass, volume));
      columns_[2].data.put(i, over(push, volume));
      for (int c = 0; c < D; ++c)
        columns_[3].data.put(3 * i + std::size_t(c), held(node, c) ? 0 : over(momentum + c, mass));
      if (warm) columns_[4].data.put(i, over(heat, heated));
    });
  }
};

}  // namespace detail

/// Writes fields on the nodes of the grid at each frame time to STEM_0000.vti, ..., listed in STEM.pvd.
///
/// The nodes of the smallest box that holds the body (on periodic axes the whole period, its end included). Particles
/// are spread by linear hats; Float32 arrays: volume_fraction (volume over control volume, which is half a cell's on a
/// plane: free surfaces, a cavity's too, are its isosurface 0.5), density (mass over volume of the material), pressure
/// (volume-weighted mean, Pa), velocity and temperature (mass-weighted, the latter over bodies that have one, if any
/// has); 0 where there is nothing to take a mean of. All bodies count alike. Throws OutputError; InputError if the
/// particles are scattered too far for a box.
struct Vti {
  std::filesystem::path stem = {};  ///< e.g. "frames/grid"; directories are made
  double every = 0.5e-9;            ///< s, > 0
  std::optional<int> frames = {};   ///< instead of `every`: so many, evenly spaced, first and last included; 0: none
  std::vector<int> mirror = {};     ///< axes along which the body is completed by its image about the lower plane
  static constexpr bool only_when_due = true;

  template <class Solver, class Run>
  void begin(const Solver& solver, const Run& run) {
    for (const int axis : mirror) detail::lower_plane(solver, axis);
    series_.begin(stem, Schedule::of(every, frames, solver.time(), run.until));
    observe(solver);
  }
  double due() const { return series_.schedule.due(); }
  template <class Solver>
  void observe(const Solver& solver) {
    if (series_.schedule.wants(solver.time())) write(solver);
  }
  template <class Solver>
  void end(const Solver& solver) {
    if (series_.schedule.wants_end(solver.time())) write(solver);
  }

  template <class Solver>
  void write(const Solver& solver) {
    const auto file = series_.next("vti");
    detail::NodeFrame<Solver> frame(solver, mirror);
    for (const int axis : mirror) frame.mirror(axis);
    frame.write(file);
    series_.written(file, solver.time());
  }

  // What it remembers; not to be set.
  detail::FrameSeries series_ = {};
};

}  // namespace mote::observe
