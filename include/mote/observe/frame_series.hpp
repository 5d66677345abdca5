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

/// Numbers of a frame, in single or double precision: chosen when the program runs, so that what fills them is compiled
/// once.
class FrameNumbers {
  std::vector<float> single_;
  std::vector<double> double_;
  bool doubles_;

 public:
  FrameNumbers(bool doubles, std::size_t n, double value = 0) : doubles_(doubles) {
    if (doubles)
      double_.assign(n, value);
    else
      single_.assign(n, float(value));
  }
  std::size_t size() const { return doubles_ ? double_.size() : single_.size(); }
  double operator[](std::size_t i) const { return doubles_ ? double_[i] : double(single_[i]); }
  void put(std::size_t i, double x) {
    if (doubles_)
      double_[i] = x;
    else
      single_[i] = float(x);
  }
  void grow(std::size_t n) { doubles_ ? double_.resize(n) : single_.resize(n); }
  Coordinates numbers() const {
    if (doubles_) return std::span<const double>(double_);
    return std::span<const float>(single_);
  }
};

/// A named array of a frame and the parities of its components.
struct FrameColumn {
  std::string name;
  std::vector<unsigned> parities;
  FrameNumbers data;

  std::size_t components() const { return parities.size(); }
  Array array() const {
    Array a{name, int(components()), {}};
    std::visit([&](auto numbers) { a.data = numbers; }, data.numbers());
    return a;
  }
  /// Adds the image of each tuple in a mirror across an axis.
  void mirror(int axis) {
    const std::size_t n = data.size(), width = components();
    data.grow(2 * n);
    for (std::size_t i = 0; i < n; ++i) data.put(n + i, parities[i % width] >> axis & 1 ? 0 - data[i] : data[i]);
  }
};

/// Position of the plane at the lower end of an axis, about which a frame is mirrored, m. Throws InputError.
template <class Solver>
double lower_plane(const Solver& solver, int axis) {
  require(axis >= 0 && axis < Solver::dimension && solver.domain().plane(axis, 0), "a frame is mirrored along axis ",
          axis, ", which has no plane at its lower end");
  return solver.frame().node_position(axis, solver.domain().plane(axis, 0)->node);
}

}  // namespace mote::observe::detail
