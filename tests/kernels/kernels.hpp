/// \file
/// The passes' kernels for the metal of the scenes. One file here per shape function makes them, compiled as a release
/// is; every other test that has a solver of this material, whatever its numbers, links to them.
#pragma once

#include <vector>

#include <mote/mote.hpp>

namespace mote::passes {

/// The type of a material with these parts.
using TestMetal = decltype(Material{eos::MieGruneisen{}, strength::VonMises{}, heat::Adiabatic{}});
template <class Shape, class Transfer, int D>
using TestBody = Body<TestMetal, double, D, Transfer, Shape>;

// prefix: extern to declare them, nothing to make them. What has other materials, number types or tasks than these is
// compiled where it is used, as ever.
#define MOTE_TEST_GATHER(prefix, task, S, X, D)                                                       \
  prefix template TileReport gather_tile<Task::task, shape::S, transfer::X>(                          \
      TestBody<shape::S, transfer::X, D>&, const transfer::X&, Tile<D>&, const std::vector<Link<D>>&, \
      const grid::Blocks<double, D>&, const Frame<double, D>&, double, double*);
#define MOTE_TEST_KERNELS_OF_DIMENSION(prefix, S, X, D)                                                               \
  MOTE_TEST_GATHER(prefix, velocity_and_deform, S, X, D)                                                              \
  MOTE_TEST_GATHER(prefix, velocity_and_remap, S, X, D)                                                               \
  MOTE_TEST_GATHER(prefix, deform, S, X, D)                                                                           \
  prefix template void scatter_tile<shape::S, transfer::X>(const TestBody<shape::S, transfer::X, D>&, const Tile<D>&, \
                                                           const Frame<double, D>&, double*);                         \
  prefix template TileReport survey_tile<shape::S>(const TestBody<shape::S, transfer::X, D>&, Tile<D>&,               \
                                                   const Frame<double, D>&, const Vec<double, D>&);
#define MOTE_TEST_KERNELS(prefix, S, X)           \
  MOTE_TEST_KERNELS_OF_DIMENSION(prefix, S, X, 1) \
  MOTE_TEST_KERNELS_OF_DIMENSION(prefix, S, X, 2) \
  MOTE_TEST_KERNELS_OF_DIMENSION(prefix, S, X, 3)
// A transfer that sharpens has one more.
#define MOTE_TEST_SHARPENING(prefix, S, X, D)                                                                   \
  prefix template void transfer_and_return<shape::S>(const TestBody<shape::S, transfer::X, D>&, const Tile<D>&, \
                                                     const std::vector<Link<D>>&, const AlignedVector<double>&, \
                                                     const Frame<double, D>&, double*);
#define MOTE_TEST_SHARPENING_KERNELS(prefix, S, X) \
  MOTE_TEST_KERNELS(prefix, S, X)                  \
  MOTE_TEST_SHARPENING(prefix, S, X, 1)            \
  MOTE_TEST_SHARPENING(prefix, S, X, 2)            \
  MOTE_TEST_SHARPENING(prefix, S, X, 3)

// clang-format off
#define MOTE_TEST_LINEAR_KERNELS(prefix)  \
  MOTE_TEST_KERNELS(prefix, Linear, Flip) \
  MOTE_TEST_KERNELS(prefix, Linear, Apic)
#define MOTE_TEST_QUADRATIC_KERNELS(prefix)         \
  MOTE_TEST_KERNELS(prefix, QuadraticBSpline, Flip) \
  MOTE_TEST_KERNELS(prefix, QuadraticBSpline, Apic) \
  MOTE_TEST_SHARPENING_KERNELS(prefix, QuadraticBSpline, AffineFlip)
#define MOTE_TEST_CUBIC_KERNELS(prefix)         \
  MOTE_TEST_KERNELS(prefix, CubicBSpline, Flip) \
  MOTE_TEST_KERNELS(prefix, CubicBSpline, Apic) \
  MOTE_TEST_SHARPENING_KERNELS(prefix, CubicBSpline, AffineFlip)
#define MOTE_TEST_GIMP_KERNELS(prefix)            \
  MOTE_TEST_KERNELS(prefix, Gimp, Flip)           \
  MOTE_TEST_KERNELS(prefix, Gimp, Apic)           \
  MOTE_TEST_KERNELS(prefix, ContiguousGimp, Flip) \
  MOTE_TEST_KERNELS(prefix, ContiguousGimp, Apic)
// clang-format on

MOTE_TEST_LINEAR_KERNELS(extern)
MOTE_TEST_QUADRATIC_KERNELS(extern)
MOTE_TEST_CUBIC_KERNELS(extern)
MOTE_TEST_GIMP_KERNELS(extern)

}  // namespace mote::passes
