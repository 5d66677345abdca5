/// \file
/// Frames of particles for viewers: a .vtp file per time and a .pvd that lists them.
#pragma once

#include <mote/observe/frame_series.hpp>

namespace mote::observe {

namespace detail {

/// Parities of the components that a field has in a frame; vectors and matrices are padded to three dimensions.
template <class Tag>
std::vector<unsigned> parities_of() {
  if constexpr (std::is_same_v<typename Tag::shape, shape_of::Scalar>) {
    return {0};
  } else if constexpr (std::is_same_v<Tag, field::HalfSize>) {
    return {0, 0, 0};  // a size has no direction
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
  std::vector<std::uint32_t> ids_, bodies_;  // of one body only, the latter is left out
  std::vector<FrameColumn<Real>> columns_;

 public:
  explicit ParticleFrame(const Solver& solver) : solver_(solver), points_(3 * solver.size()), ids_(solver.size()) {
    std::size_t first = 0;
    std::uint32_t body = 0;
    solver.for_each_body([&](const auto& material, const auto& particles) {
      add_fields(particles, first, list_of<decltype(particles)>{});
      add_derived(material, particles, first);
      first += particles.size();
      if (Solver::bodies > 1) bodies_.resize(first, body++);
    });
  }

  /// Adds the image about the lower plane of an axis.
  void mirror(int axis) {
    const double plane = lower_plane(solver_, axis);
    append(ids_, 1, [](std::size_t, std::uint32_t id) { return id; });
    append(bodies_, 1, [](std::size_t, std::uint32_t body) { return body; });
    append(points_, 3, [&](std::size_t c, Real x) { return c == std::size_t(axis) ? Real(2 * plane - double(x)) : x; });
    for (auto& column : columns_)
      append(column.data, column.components(),
             [&](std::size_t c, Real x) { return column.parities[c] >> axis & 1 ? 0 - x : x; });
  }

  void write(const std::filesystem::path& file) const {
    std::vector<Array> arrays{{"id", 1, std::span<const std::uint32_t>(ids_)}};
    if (Solver::bodies > 1) arrays.push_back({"body", 1, std::span<const std::uint32_t>(bodies_)});
    for (const auto& column : columns_) arrays.push_back(column.array());
    write_vtp(file, std::span<const Real>(points_), arrays, solver_.time());
  }

 private:
  template <class Number, class F>
  static void append(std::vector<Number>& data, std::size_t components, const F& image) {
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
/// parts declare, yours too, under its name; but for mass, the affine matrix and the stress deviator. With several
/// bodies there is `body` too, 0 for the first material given to the solver, and what a body lacks is nan (threshold by
/// `body`, or let ParaView paint nan in a colour of its own). Two- and one-dimensional vectors are padded with zeros.
/// Images carry the id of their particle; a vector is mirrored as velocity is, but for half_size. Throws OutputError.
struct Vtp {
  std::filesystem::path stem = {};  ///< e.g. "frames/particles"; directories are made
  double every = 0.5e-9;            ///< s, > 0
  std::optional<int> frames = {};   ///< instead of `every`: so many, evenly spaced, first and last included; 0: none
  std::vector<int> mirror = {};     ///< axes along which the body is completed by its image about the lower plane
  bool doubles = false;             ///< Float64 instead of Float32
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

}  // namespace mote::observe
