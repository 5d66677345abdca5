/// \file
/// A solver of the library and the textbook loop of the same scheme and scene, side by side.
#pragma once

#include "../../../bench/textbook.hpp"
#include "schemes.hpp"

namespace beside {

using namespace schemes;

inline constexpr double dt = 3e-11, speed = 500;  // s, m/s

template <class Shape>
inline constexpr auto book_shape = std::is_same_v<Shape, shape::Linear>             ? textbook::Shape::linear
                                   : std::is_same_v<Shape, shape::QuadraticBSpline> ? textbook::Shape::quadratic
                                   : std::is_same_v<Shape, shape::Gimp>             ? textbook::Shape::gimp
                                   : std::is_same_v<Shape, shape::ContiguousGimp>   ? textbook::Shape::contiguous_gimp
                                                                                    : textbook::Shape::cubic;

template <class Scheme>
using Book = textbook::Loop<book_shape<typename Scheme::Shape>,
                            Scheme::flip          ? textbook::Transfer::flip
                            : Scheme::affine_flip ? textbook::Transfer::affine_flip
                                                  : textbook::Transfer::apic,
                            std::is_same_v<typename Scheme::Update, update::Usl> ? textbook::Update::usl
                                                                                 : textbook::Update::musl>;

/// The particles of a solver whose columns are still in the order of their ids, as the textbook's.
template <class P, class B>
void copy_particles(const P& from, B& book) {
  for (std::size_t p = 0; p < from.size(); ++p) {
    const auto x = from.template get<field::Position>(p), v = from.template get<field::Velocity>(p);
    book.add({x[0], x[1], x[2]}, {v[0], v[1], v[2]}, from.template column<field::Mass>()[p]);
    if constexpr (contains<typename P::list, field::Affine>)
      for (int c = 0; c < 9; ++c) book.particles.C[std::size_t(c)][p] = from.template column<field::Affine>(c)[p];
    if constexpr (contains<typename P::list, field::HalfSize>)
      for (int a = 0; a < 3; ++a) book.particles.l[std::size_t(a)][p] = from.template column<field::HalfSize>(a)[p];
  }
}

/// The largest differences of any particle, each over its own scale.
struct Difference {
  double position = 0, velocity = 0, volume = 0, stress = 0, plastic = 0, temperature = 0, affine = 0, size = 0;
  double largest() const { return std::max({position, velocity, volume, stress, plastic, temperature, affine, size}); }
};

inline void take(double& largest, double a, double b, double scale, double period = 0) {
  double d = (a - b) / scale;
  if (period > 0) d -= period * std::round(d / period);
  if (!(std::abs(d) <= largest)) largest = std::abs(d);
}

/// \param period along x and y, in cells; 0: none
template <class P, class B>
Difference compare(const P& mine, const B& book, double period) {
  const auto& theirs = book.particles;
  Difference d;
  for (std::size_t p = 0; p < mine.size(); ++p) {
    const std::size_t q = mine.template column<field::Id>()[p];
    for (int a = 0; a < 3; ++a) {
      const auto u = std::size_t(a);
      take(d.position, mine.template column<field::Position>(a)[p], theirs.x[u][q], h, a < 2 ? period : 0);
      take(d.velocity, mine.template column<field::Velocity>(a)[p], theirs.v[u][q], speed);
    }
    take(d.volume, mine.template column<field::VolumeRatio>()[p], theirs.J[q], 1);
    for (int c = 0; c < 6; ++c)
      take(d.stress, mine.template column<field::DeviatoricStress>(c)[p], theirs.s[std::size_t(c)][q], 120e6);
    take(d.plastic, mine.template column<field::PlasticStrain>()[p], theirs.strain[q], 1);
    take(d.plastic, mine.template column<field::PlasticWork>()[p], theirs.work[q], 120e6 / 2700);
    take(d.temperature, mine.template column<field::Temperature>()[p], theirs.temperature[q], 300);
    if constexpr (contains<typename P::list, field::Affine>)
      for (int c = 0; c < 9; ++c)
        take(d.affine, mine.template column<field::Affine>(c)[p], theirs.C[std::size_t(c)][q], speed / h);
    if constexpr (contains<typename P::list, field::HalfSize>)
      for (int a = 0; a < 3; ++a)
        take(d.size, mine.template column<field::HalfSize>(a)[p], theirs.l[std::size_t(a)][q], h);
  }
  return d;
}

}  // namespace beside
