/// \file
/// Frames for viewers: Vtp (particles) and Vti (fields on the grid's nodes), a file per time and a .pvd that lists
/// them.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <mote/grid/domain.hpp>
#include <mote/observe/schedule.hpp>
#include <mote/observe/vtk.hpp>

namespace mote::observe {

namespace detail {

/// Times and names of a series of frames: STEM_0000.EXT, ...
struct FrameSeries {
  Schedule schedule;
  std::filesystem::path stem;
  std::optional<Collection> collection;
  std::size_t count = 0;

  void begin(const std::filesystem::path& to, const Schedule& times) {
    require(to.has_filename(), "the stem of the frames, '", to.string(), "', has no file name");
    *this = {times, to, Collection(std::filesystem::path(to) += ".pvd"), 0};
  }
  std::filesystem::path next(const char* extension) const {
    std::array<char, 32> number;
    std::snprintf(number.data(), number.size(), "_%04zu.", count);
    return (std::filesystem::path(stem) += number.data()) += extension;
  }
  void written(const std::filesystem::path& frame, double time) {
    collection->add(frame, time);
    ++count;
    schedule.done(time);
  }
};

/// Which reflections change the sign of a component: bit a for that along axis a.
inline unsigned parity(int i) { return 1u << i; }
inline unsigned parity(int i, int j) { return parity(i) ^ parity(j); }

/// A named array of a frame and the parities of its components.
template <class Real>
struct FrameColumn {
  std::string name;
  std::vector<unsigned> parities;
  std::vector<Real> data;

  std::size_t components() const { return parities.size(); }
  Array array() const { return {name, int(components()), std::span<const Real>(data)}; }
};

/// Position of the plane at the lower end of an axis, about which a frame is mirrored, m. Throws InputError.
template <class Solver>
double lower_plane(const Solver& solver, int axis) {
  require(axis >= 0 && axis < Solver::dimension && solver.domain().plane(axis, 0), "a frame is mirrored along axis ",
          axis, ", which has no plane at its lower end");
  return solver.frame().node_position(axis, solver.domain().plane(axis, 0)->node);
}

/// Parities of the components that a field has in a frame; vectors and matrices are padded to three dimensions.
template <class Tag>
std::vector<unsigned> parities_of() {
  if constexpr (std::is_same_v<typename Tag::shape, shape_of::Scalar>) {
    return {0};
  } else if constexpr (std::is_same_v<typename Tag::shape, shape_of::Vector>) {
    return {parity(0), parity(1), parity(2)};
  } else if constexpr (std::is_same_v<typename Tag::shape, shape_of::Symmetric>) {
    return {0, 0, 0, parity(0, 1), parity(1, 2), parity(0, 2)};
  } else {
    std::vector<unsigned> p;
    for (int i = 0; i < 9; ++i) p.push_back(parity(i / 3, i % 3));
    return p;
  }
}

/// Place of stored component i of a field among those in a frame.
template <class Tag, int D>
constexpr int place_in_frame(int i) {
  return std::is_same_v<typename Tag::shape, shape_of::Matrix> ? 3 * (i / D) + i % D : i;
}

/// Fields that frames show in another form, or not at all.
template <class Tag>
inline constexpr bool left_out =
    contains<fields<field::Position, field::Mass, field::Id, field::Affine, field::DeviatoricStress>, Tag>;

/// The arrays of one particle frame.
template <class Real, class Solver>
class ParticleFrame {
  static constexpr int D = Solver::dimension;
  using T = typename Solver::number;

  const Solver& solver_;
  std::vector<Real> points_;
  std::vector<std::uint32_t> ids_;
  std::vector<FrameColumn<Real>> columns_;

 public:
  explicit ParticleFrame(const Solver& solver) : solver_(solver), points_(3 * solver.size()), ids_(solver.size()) {
    std::size_t first = 0;
    solver.for_each_body([&](const auto& material, const auto& particles) {
      add_fields(particles, first, list_of<decltype(particles)>{});
      add_derived(material, particles, first);
      first += particles.size();
    });
  }

  /// Adds the image about the lower plane of an axis.
  void mirror(int axis) {
    const double plane = lower_plane(solver_, axis);
    const std::size_t n = ids_.size();
    ids_.resize(2 * n);
    std::copy_n(ids_.begin(), n, ids_.begin() + std::ptrdiff_t(n));
    append(points_, 3, [&](std::size_t c, Real x) { return c == std::size_t(axis) ? Real(2 * plane - double(x)) : x; });
    for (auto& column : columns_)
      append(column.data, column.components(),
             [&](std::size_t c, Real x) { return column.parities[c] >> axis & 1 ? 0 - x : x; });
  }

  void write(const std::filesystem::path& file) const {
    std::vector<Array> arrays{{"id", 1, std::span<const std::uint32_t>(ids_)}};
    for (const auto& column : columns_) arrays.push_back(column.array());
    write_vtp(file, std::span<const Real>(points_), arrays, solver_.time());
  }

 private:
  template <class F>
  static void append(std::vector<Real>& data, std::size_t components, const F& image) {
    const std::size_t n = data.size();
    data.resize(2 * n);
    for (std::size_t i = 0; i < n; ++i) data[n + i] = image(i % components, data[i]);
  }

  /// The data of the column of that name; nan where no body has set it.
  Real* column(const std::string& name, const std::vector<unsigned>& parities) {
    for (auto& c : columns_)
      if (c.name == name && c.parities == parities) return c.data.data();
    columns_.push_back({name, parities, std::vector<Real>(parities.size() * solver_.size(), Real(nan))});
    return columns_.back().data.data();
  }

  template <class Particles, class... Tags>
  void add_fields(const Particles& particles, std::size_t first, fields<Tags...>) {
    for (int a = 0; a < D; ++a) {
      const auto x = particles.template column<field::Position>(a);
      each(particles, [&](std::size_t p) {
        points_[3 * (first + p) + std::size_t(a)] = Real(solver_.domain().wrapped_position(a, double(x[p])));
      });
    }
    const auto id = particles.template column<field::Id>();
    std::copy(id.begin(), id.end(), ids_.begin() + std::ptrdiff_t(first));
    const auto add = [&]<class Tag>(Tag) {
      if constexpr (!left_out<Tag>) add_field<Tag>(particles, first);
    };
    (add(Tags{}), ...);
  }

  template <class Tag, class Particles>
  void add_field(const Particles& particles, std::size_t first) {
    const auto parities = parities_of<Tag>();
    const std::size_t width = parities.size();
    Real* to = column(Tag::name, parities) + width * first;
    std::fill_n(to, width * particles.size(), Real(0));
    for (int i = 0; i < Tag::shape::template components<D>; ++i) {
      const auto from = particles.template column<Tag>(i);
      const std::size_t at = std::size_t(place_in_frame<Tag, D>(i));
      each(particles, [&](std::size_t p) { to[width * p + at] = Real(from[p]); });
    }
  }

  template <class Material, class Particles>
  void add_derived(const Material& material, const Particles& particles, std::size_t first) {
    using State = particle_fields_of<Material>;
    constexpr bool strong = contains<State, field::DeviatoricStress>;
    Real* pressure = column("pressure", {0}) + first;
    Real* density = column("density", {0}) + first;
    Real* mises = strong ? column("von_mises_stress", {0}) + first : nullptr;
    each(particles, [&](std::size_t p) {
      Values<T, D, State> values;
      particles.load(p, values);
      pressure[p] = Real(material.pressure(values));
      density[p] = Real(material.rho0() / double(get<field::VolumeRatio>(values)));
      if constexpr (strong) {
        const auto& s = get<field::DeviatoricStress>(values);
        mises[p] = Real(std::sqrt(1.5 * double(ddot(s, s))));
      }
    });
  }

  template <class Particles, class F>
  void each(const Particles& particles, const F& f) const {
    for_chunks(solver_.executor(), particles.size(), [&](std::size_t from, std::size_t to) {
      for (std::size_t p = from; p < to; ++p) f(p);
    });
  }
};

}  // namespace detail

/// Writes the particles at each frame time to STEM_0000.vtp, ..., listed in STEM.pvd.
///
/// Arrays: velocity, pressure (Pa), von_mises_stress sqrt(3/2 s:s) (Pa), density (kg/m^3), id, and every field that the
/// parts declare, yours too, under its name; but for mass, the affine matrix and the stress deviator. What a body lacks
/// is nan. Two- and one-dimensional vectors are padded with zeros. Images carry the id of their particle; a vector is
/// mirrored as velocity is. Throws OutputError.
struct Vtp {
  std::filesystem::path stem = {};  ///< e.g. "frames/particles"; directories are made
  double every = 0.5e-9;            ///< s, > 0
  std::optional<int> frames = {};   ///< instead of `every`: so many, evenly spaced, first and last included; 0: none
  std::vector<int> mirror = {};     ///< axes along which the body is completed by its image about the lower plane
  bool doubles = false;             ///< Float64 instead of Float32

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
    const auto file = series_.next("vtp");
    const auto put = [&](auto frame) {
      for (const int axis : mirror) frame.mirror(axis);
      frame.write(file);
    };
    if (doubles)
      put(detail::ParticleFrame<double, Solver>(solver));
    else
      put(detail::ParticleFrame<float, Solver>(solver));
    series_.written(file, solver.time());
  }

  // What it remembers; not to be set.
  detail::FrameSeries series_ = {};
};

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
  std::vector<FrameColumn<float>> columns_;

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
      std::vector<float> data;
      data.reserve(width * std::size_t(count()));
      for_nodes([&](std::array<std::int64_t, 3> node) {
        const bool image = node[a] < lo[a];
        if (image) node[a] = 2 * lo[a] - node[a];
        const float* from = column.data.data() + width * place(node, lo, hi);
        for (std::size_t c = 0; c < width; ++c)
          data.push_back(image && (column.parities[c] >> axis & 1) ? 0 - from[c] : from[c]);
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
      columns_.push_back({name, parities, std::vector<float>(parities.size() * n)});
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
        return float(below > 0 ? sums_[std::size_t(a)][i] / below : 0);
      };
      columns_[0].data[i] = float(sums_[volume][i] / control_volume(node));
      columns_[1].data[i] = over(mass, volume);
      columns_[2].data[i] = over(push, volume);
      for (int c = 0; c < D; ++c)
        columns_[3].data[3 * i + std::size_t(c)] = held(node, c) ? 0 : over(momentum + c, mass);
      if (warm) columns_[4].data[i] = over(heat, heated);
    });
  }
};

}  // namespace detail

/// Writes fields on the nodes of the grid at each frame time to STEM_0000.vti, ..., listed in STEM.pvd.
///
/// The nodes of the smallest box that holds the body (on periodic axes the whole period, its end included). Particles
/// are spread by linear hats; Float32 arrays: volume_fraction (volume over control volume, which is half a cell's on a
/// plane: free surfaces, a cavity's too, are its isosurface 0.5), density (mass over volume of the material), pressure
/// (volume-weighted mean, Pa), velocity and temperature (mass-weighted; the latter if there is one); 0 where there is
/// no material. Throws OutputError; InputError if the particles are scattered too far for a box.
struct Vti {
  std::filesystem::path stem = {};  ///< e.g. "frames/grid"; directories are made
  double every = 0.5e-9;            ///< s, > 0
  std::optional<int> frames = {};   ///< instead of `every`: so many, evenly spaced, first and last included; 0: none
  std::vector<int> mirror = {};     ///< axes along which the body is completed by its image about the lower plane

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
