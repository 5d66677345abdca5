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
template <class Solver>
class ParticleFrame {
  static constexpr int D = Solver::dimension;

  const Solver& solver_;
  bool doubles_;
  FrameNumbers points_;
  std::vector<std::uint32_t> ids_, bodies_;  // of one body only, the latter is left out
  std::vector<FrameColumn> columns_;

 public:
  ParticleFrame(const Solver& solver, bool doubles)
      : solver_(solver), doubles_(doubles), points_(doubles, 3 * solver.size()), ids_(solver.size()) {
    std::size_t first = 0;
    std::uint32_t body = 0;
    solver.for_each_body([&](const auto& material, const auto& particles) {
      add(material, particles, first, list_of<decltype(particles)>{});
      first += particles.size();
      if (Solver::bodies > 1) bodies_.resize(first, body++);
    });
  }

  /// Adds the image about the lower plane of an axis.
  void mirror(int axis) {
    const double plane = lower_plane(solver_, axis);
    const std::size_t n = ids_.size();
    points_.grow(6 * n);
    for (std::size_t i = 0; i < 3 * n; ++i)
      points_.put(3 * n + i, i % 3 == std::size_t(axis) ? 2 * plane - points_[i] : points_[i]);
    for (auto* numbers : {&ids_, &bodies_}) {
      const std::size_t before = numbers->size();
      numbers->resize(2 * before);
      std::copy_n(numbers->begin(), before, numbers->begin() + std::ptrdiff_t(before));
    }
    for (auto& column : columns_) column.mirror(axis);
  }

  void write(const std::filesystem::path& file) const {
    std::vector<Array> arrays{{"id", 1, std::span<const std::uint32_t>(ids_)}};
    if (Solver::bodies > 1) arrays.push_back({"body", 1, std::span<const std::uint32_t>(bodies_)});
    for (const auto& column : columns_) arrays.push_back(column.array());
    write_vtp(file, points_.numbers(), arrays, solver_.time());
  }

 private:
  /// The number of the column of that name; nan where no body has set it.
  std::size_t column(const char* name, const std::vector<unsigned>& parities) {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].name == name && columns_[i].parities == parities) return i;
    columns_.push_back({name, parities, FrameNumbers(doubles_, parities.size() * solver_.size(), nan)});
    return columns_.size() - 1;
  }

  template <class Material, class Particles, class... Tags>
  void add(const Material& material, const Particles& particles, std::size_t first, fields<Tags...>) {
    using State = particle_fields_of<Material>;
    constexpr bool strong =
        contains<State, field::DeviatoricStress> || requires(Values<typename Solver::number, D, State> values) {
      material.strength.stress(values);
    };
    std::vector<std::size_t> of_fields;
    const auto find = [&]<class Tag>(Tag) {
      if constexpr (!left_out<Tag>) of_fields.push_back(column(Tag::name, parities_of<Tag>()));
    };
    (find(Tags{}), ...);
    const std::size_t pressure = column("pressure", {0}), density = column("density", {0});
    [[maybe_unused]] const std::size_t mises = strong ? column("von_mises_stress", {0}) : 0;
    for_chunks(solver_.executor(), particles.size(), [&](std::size_t from, std::size_t to) {
      add_points(particles, first, from, to);
      const std::size_t* next = of_fields.data();
      const auto copy = [&]<class Tag>(Tag) {
        if constexpr (!left_out<Tag>) copy_field<Tag>(particles, first, from, to, columns_[*next++].data);
      };
      (copy(Tags{}), ...);
      for (std::size_t p = from; p < to; ++p) {
        Values<typename Solver::number, D, State> values;
        particles.load(p, values);
        columns_[pressure].data.put(first + p, double(material.pressure(values)));
        columns_[density].data.put(first + p, material.rho0() / double(get<field::VolumeRatio>(values)));
        if constexpr (strong) {
          SymTensor<typename Solver::number> s{};
          if constexpr (contains<State, field::DeviatoricStress>)
            s = get<field::DeviatoricStress>(values);
          else
            s = deviator(material.strength.stress(values));
          columns_[mises].data.put(first + p, std::sqrt(1.5 * double(ddot(s, s))));
        }
      }
    });
  }

  template <class Particles>
  void add_points(const Particles& particles, std::size_t first, std::size_t from, std::size_t to) {
    for (std::size_t p = from; p < to; ++p) {
      ids_[first + p] = particles.template column<field::Id>()[p];
      for (int a = 0; a < D; ++a)
        points_.put(3 * (first + p) + std::size_t(a),
                    solver_.domain().wrapped_position(a, double(particles.template column<field::Position>(a)[p])));
    }
  }

  template <class Tag, class Particles>
  static void copy_field(const Particles& particles, std::size_t first, std::size_t from, std::size_t to,
                         FrameNumbers& numbers) {
    const std::size_t width = parities_of<Tag>().size();
    for (std::size_t i = width * (first + from); i < width * (first + to); ++i) numbers.put(i, 0);
    for (int i = 0; i < Tag::shape::template components<D>; ++i) {
      const auto column = particles.template column<Tag>(i);
      const std::size_t at = std::size_t(place_in_frame<Tag, D>(i));
      for (std::size_t p = from; p < to; ++p) numbers.put(width * (first + p) + at, double(column[p]));
    }
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
    detail::ParticleFrame<Solver> frame(solver, doubles);
    for (const int axis : mirror) frame.mirror(axis);
    frame.write(file);
    series_.written(file, solver.time());
  }

  // What it remembers; not to be set.
  detail::FrameSeries series_ = {};
};

}  // namespace mote::observe
