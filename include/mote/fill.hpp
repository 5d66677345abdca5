/// \file
/// From regions to particles.
#pragma once

#include <limits>

#include <mote/core/vector_field.hpp>
#include <mote/geometry/seeds.hpp>
#include <mote/passes/body.hpp>

namespace mote {

/// How Solver::fill places particles.
template <int D>
struct Fill {
  int per_axis = 2;  ///< particles per cell and axis, 1 to 64
  /// Initial velocity, m/s: constant or a function of position, whose gradient field::Affine gets (by differences over a
  /// thousandth of a cell to either side of each particle, where the function must be defined and smooth).
  VectorField<D> velocity{};
  geometry::Method method = geometry::Method::lattice;
  double jitter = 0;       ///< random displacement as a part of the particle distance, 0 to 0.5
  std::uint64_t seed = 0;  ///< of the jitter
};

/// Appends the particles of a region to a body; what lies beyond the domain's boundaries is left out. A region that
/// reaches across a symmetry plane so gives exactly a part of the whole body. A half size is that of the lattice, also
/// of a particle that was cut: a small one at the surface would bring the noise of hats there. \return how many
template <class T, class B, class R, class M, int D>
std::size_t append_fill(B& body, const R& region, const M& material, const Fill<D>& how,
                        const passes::Frame<T, D>& frame, const grid::Domain<D>& domain, std::size_t next_id) {
  static_assert(R::dimension == D, "mote: the region and the grid differ in dimension");
  auto seeds = geometry::seeds(region, geometry::Lattice<D>{frame.spacing, how.per_axis, frame.origin},
                               {.method = how.method, .jitter = how.jitter, .seed = how.seed});
  std::erase_if(seeds, [&](const auto& s) {
    for (int a = 0; a < D; ++a)
      if (!domain.contains(a, s.position[a])) return true;
    return false;
  });
  require(!seeds.empty(), "a region to fill lies wholly beyond the boundaries of the domain");
  auto& particles = body.particles;
  const std::size_t first = particles.size();
  require(next_id + seeds.size() < std::numeric_limits<std::uint32_t>::max(), "a fill of ", seeds.size(),
          " particles makes more than the 4,294,967,294 that a solver can number");
  try {
    particles.resize(first + seeds.size());
    Values<T, D, particle_fields_of<M>> at_rest;
    material.initialise(at_rest);
    using All = typename B::list;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      Values<T, D, All> p{};
      set_fields(p, at_rest, particle_fields_of<M>{});
      get<field::Position>(p) = cast<T>(seeds[i].position);
      get<field::Velocity>(p) = cast<T>(how.velocity(seeds[i].position));
      if constexpr (contains<All, field::Affine>)
        get<field::Affine>(p) = cast<T>(how.velocity.gradient(seeds[i].position, 1e-3 * frame.spacing));
      if constexpr (contains<All, field::HalfSize>)
        get<field::HalfSize>(p) = Vec<T, D>::filled(T(0.5 * frame.spacing / how.per_axis));
      get<field::Mass>(p) = T(material.rho0() * seeds[i].volume);
      particles.set_all(first + i, p);
      particles.template column<field::Id>()[first + i] = std::uint32_t(next_id + i);
    }
  } catch (...) {  // of the user's velocity function, or for want of memory: as if nothing had been asked
    particles.resize(first);
    throw;
  }
  return seeds.size();
}

}  // namespace mote
