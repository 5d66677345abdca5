/// \file
/// What the frames of particles (vtp.hpp) and of grid fields (vti.hpp) share: names, times, mirroring.
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

namespace mote::observe::detail {

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

}  // namespace mote::observe::detail
