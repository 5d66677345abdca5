/// \file
/// What main.cpp asks of a compiled combination of parts, and what it gets back. No templates, nothing heavy.
#pragma once

#include <array>
#include <functional>
#include <mote/observe/history.hpp>
#include <span>
#include <string>

#include "options.hpp"

namespace cavity {

/// What a run says while it runs.
struct Voice {
  std::function<void(std::string)> progress;
  double seconds;                                  ///< between two lines of progress
  std::function<void(const std::string&)> notice;  ///< what happens once
};

/// What came out, SI units.
struct Result {
  std::size_t particles = 0, steps = 0;
  int threads = 1;
  double step_seconds = 0;  ///< wall time in steps, without observers
  std::string failure;      ///< the NumericalError that ended the run; empty: none
  mote::observe::Sample first, last;
};

/// One compiled combination of shape function, transfer, update and number type, with or without conduction.
struct Combination {
  Shape shape;
  Transfer transfer;
  Update update;
  Precision precision;
  bool conducts;
  int bytes_per_particle;
  Result (*simulate)(const Options&, const Voice&);
};

/// The one that the options ask for. Throws BadOption if it was not compiled.
const Combination& find_combination(const Options& options);

// Each array is compiled in a file of its own name: all updates of a shape function and a transfer.
extern const std::array<Combination, 2> linear_flip, linear_apic, quadratic_flip, quadratic_apic, linear_aflip,
    quadratic_aflip, cubic_flip, cubic_apic, cubic_aflip;
extern const std::array<Combination, 4> gimp_flip;
extern const std::array<Combination, 1> linear_xpic, quadratic_fmpm;
extern const std::array<Combination, 2> quadratic_xpic;
extern const std::array<Combination, 3> usf;  // with FLIP and APIC
extern const std::array<Combination, 1> linear_flip_float, quadratic_apic_float, quadratic_aflip_float,
    cubic_aflip_float;
extern const std::array<Combination, 4> conducting;

}  // namespace cavity
