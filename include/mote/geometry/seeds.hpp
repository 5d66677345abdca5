/// \file
/// Seeds: the places and volumes of the particles that fill a region.
///
/// Two fills. Method::lattice takes each lattice site whose centre lies inside, whole: equal particles, a surface in
/// stairs. Method::fraction cuts the sites at the surface: each site holds the volume inside the region at that
/// volume's centroid, so that mass and first moments are right; geometry/cut.hpp says how well.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <mote/geometry/concept.hpp>
#include <mote/geometry/cut.hpp>

namespace mote::geometry {

/// A particle to be: where, m, and how large, m^3 (m^2 in two dimensions, m in one).
template <int D>
struct Seed {
  Vec<double, D> position;
  double volume;
};

enum class Method {
  lattice,   ///< whole sites whose centres lie inside
  fraction,  ///< the inside part of every site that meets the region
};

/// Where particles may sit: per_axis sites per cell and axis, site i centred at origin + (i + 1/2) spacing / per_axis.
template <int D>
struct Lattice {
  double spacing = 0;       ///< of the grid's cells, m; positive
  int per_axis = 2;         ///< particles per cell and axis, 1 to 64
  Vec<double, D> origin{};  ///< a node of the grid, m

  double site_size() const { return spacing / per_axis; }

  /// \throws InputError if a number is outside its range.
  void validate() const {
    require(spacing > 0 && std::isfinite(spacing), "Lattice: spacing = ", spacing, " m must be positive and finite");
    require(per_axis >= 1 && per_axis <= 64, "Lattice: per_axis = ", per_axis, " must be from 1 to 64");
    for (int i = 0; i < D; ++i)
      require(std::isfinite(origin[i]), "Lattice: origin[", i, "] = ", origin[i], " m must be finite");
  }
};

struct SeedOptions {
  Method method = Method::lattice;
  double jitter = 0;       ///< each seed moves by up to this times the site size along each axis, 0 to 0.5
  std::uint64_t seed = 0;  ///< of the jitter; the same number, the same places, on every machine

  /// \throws InputError if the jitter is outside its range.
  void validate() const {
    require(jitter >= 0 && jitter <= 0.5, "SeedOptions: jitter = ", jitter, " must be from 0 to 0.5");
  }
};

namespace detail {

/// A seed with less than this of a site costs as much as any other and says next to nothing.
inline constexpr double sliver = 1e-3;

/// The lattice's sites in a region's bounds, numbered along x first.
template <int D>
struct Sites {
  Vec<double, D> origin;
  double size;
  Vec<std::int64_t, D> first{}, count{};  ///< lattice coordinates of site 0, and sites along each axis
  std::int64_t total = 1;

  Sites(const Bounds<D>& bounds, const Lattice<D>& lattice) : origin(lattice.origin), size(lattice.site_size()) {
    double sites = 1;
    for (int k = 0; k < D; ++k) {
      const double from = std::floor((bounds.lower[k] - origin[k]) / size + thinnest);
      const double to = std::ceil((bounds.upper[k] - origin[k]) / size - thinnest);
      require(std::isfinite(from) && std::isfinite(to), "seeds: the region reaches from ", bounds.lower[k], " m to ",
              bounds.upper[k], " m along axis ", k, "; take it together with a Box (region & box)");
      sites *= std::max(0.0, to - from);
      require(std::max({-from, to, sites}) < 0x1p31, "seeds: the region reaches from ", bounds.lower[k], " m to ",
              bounds.upper[k], " m along axis ", k, ", which takes more than 2^31 sites of ", size,
              " m; check the units");
      first[k] = std::int64_t(from);
      count[k] = std::int64_t(std::max(0.0, to - from));
      total *= count[k];
    }
  }

  Vec<std::int64_t, D> coordinates(std::int64_t n) const {
    Vec<std::int64_t, D> i{};
    for (int k = 0; k < D; n /= count[k++]) i[k] = first[k] + n % count[k];
    return i;
  }
  Vec<double, D> centre(std::int64_t n) const {
    auto x = cast<double>(coordinates(n));
    for (int k = 0; k < D; ++k) x[k] = origin[k] + (x[k] + 0.5) * size;
    return x;
  }
};

/// A seed and the number of its site.
template <int D>
struct Placed {
  Seed<D> seed;
  std::int64_t site;
};

template <Region R, int D>
std::vector<Placed<D>> fill_lattice(const R& region, const Sites<D>& sites) {
  std::vector<Placed<D>> result;
  for (std::int64_t n = 0; n < sites.total; ++n) {
    const auto centre = sites.centre(n);
    if (region.contains(centre)) result.push_back({{centre, power<D>(sites.size)}, n});
  }
  return result;
}

template <Region R, int D>
std::vector<Placed<D>> fill_fraction(const R& region, const Sites<D>& sites) {
  std::vector<Placed<D>> result;
  for (std::int64_t n = 0; n < sites.total; ++n) {
    const auto centre = sites.centre(n);
    Piece<D> piece;
    Cut<R>{region, centre}.add_inside({}, sites.size / 2, 0, piece);
    if (piece.volume > thinnest * power<D>(sites.size))
      result.push_back({{centre + piece.moment * (1 / piece.volume), piece.volume}, n});
  }
  return result;
}

/// The seeds of at least the volume `least` across the faces of the site of seed p.
template <int D>
std::vector<std::size_t> full_neighbours(const std::vector<Placed<D>>& placed, const Sites<D>& sites, std::size_t p,
                                         double least) {
  std::vector<std::size_t> result;
  const auto here = sites.coordinates(placed[p].site) - sites.first;
  std::int64_t stride = 1;
  for (int k = 0; k < D; stride *= sites.count[k++])
    for (const int step : {-1, 1}) {
      if (here[k] + step < 0 || here[k] + step >= sites.count[k]) continue;
      const auto site = placed[p].site + step * stride;
      const auto q = std::lower_bound(placed.begin(), placed.end(), site,
                                      [](const auto& one, std::int64_t number) { return one.site < number; });
      if (q != placed.end() && q->site == site && q->seed.volume >= least)
        result.push_back(std::size_t(q - placed.begin()));
    }
  return result;
}

/// Hands every sliver's volume to the seeds across its site's faces, in proportion to theirs and where it lies, so that
/// volume and first moments stay. All neighbours share: picking one would break mirror symmetry. A sliver without such
/// neighbours stays a seed.
template <int D>
void merge_slivers(std::vector<Placed<D>>& placed, const Sites<D>& sites) {
  struct Gift {
    std::size_t to;
    Seed<D> part;
  };
  const double least = sliver * power<D>(sites.size);
  std::vector<Gift> gifts;  // given only when all are known: the shares must not depend on the order
  std::vector<std::size_t> gone;
  for (std::size_t p = 0; p < placed.size(); ++p) {
    if (placed[p].seed.volume >= least) continue;
    const auto neighbours = full_neighbours(placed, sites, p, least);
    double all = 0;
    for (const auto q : neighbours) all += placed[q].seed.volume;
    for (const auto q : neighbours)
      gifts.push_back({q, {placed[p].seed.position, placed[p].seed.volume * placed[q].seed.volume / all}});
    if (!neighbours.empty()) gone.push_back(p);
  }
  for (const auto& [to, part] : gifts) {
    Seed<D>& seed = placed[to].seed;
    seed.volume += part.volume;
    seed.position += (part.volume / seed.volume) * (part.position - seed.position);
  }
  for (const auto p : gone) placed[p].seed.volume = 0;
  std::erase_if(placed, [](const auto& p) { return p.seed.volume == 0; });
}

/// One step of splitmix64 (Steele, Lea, Flood 2014, OOPSLA, "Fast splittable pseudorandom number generators").
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// The displacement of the seed of a site, uniform in [-reach, reach) along each axis. It depends on the lattice
/// coordinates and the seed number only, not on the region or on the order.
template <int D>
Vec<double, D> jitter_at(const Vec<std::int64_t, D>& coordinates, std::uint64_t number, double reach) {
  std::uint64_t state = mix(number);
  for (int k = 0; k < D; ++k) state = mix(state ^ std::uint64_t(coordinates[k]));
  Vec<double, D> result{};
  for (int k = 0; k < D; ++k) {
    state = mix(state);
    result[k] = reach * (double(state >> 11) * 0x1p-52 - 1);
  }
  return result;
}

}  // namespace detail

/// The seeds that fill a region, sorted by site, x fastest.
///
/// With Method::fraction, pieces below 1e-3 of a site join the seeds across the site's faces (detail::merge_slivers):
/// they would be harmless, since nodes see ratios of momentum and mass, but would cost a particle each for nothing.
/// A seed whose jittered place lies outside the region keeps the place without jitter.
/// \throws InputError if a number is outside its range, the region is unbounded, spans 2^31 sites or holds no seed.
template <Region R>
std::vector<Seed<R::dimension>> seeds(const R& region, const Lattice<R::dimension>& lattice,
                                      const SeedOptions& options = {}) {
  constexpr int D = R::dimension;
  validate(region);
  lattice.validate();
  options.validate();
  const detail::Sites<D> sites(region.bounds(), lattice);
  auto placed =
      options.method == Method::lattice ? detail::fill_lattice(region, sites) : detail::fill_fraction(region, sites);
  require(!placed.empty(), "seeds: the region holds no particle on a lattice of ", lattice.site_size(), " m");
  if (options.method == Method::fraction) detail::merge_slivers(placed, sites);

  std::vector<Seed<D>> result;
  result.reserve(placed.size());
  for (auto [seed, site] : placed) {
    if (options.jitter > 0) {
      const auto shift = detail::jitter_at(sites.coordinates(site), options.seed, options.jitter * sites.size);
      if (region.contains(seed.position + shift)) seed.position += shift;
    }
    result.push_back(seed);
  }
  return result;
}

}  // namespace mote::geometry
