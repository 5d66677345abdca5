/// \file
/// The three kinds of trouble, as three types.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace mote {

/// A parameter is outside its allowed range. Thrown before anything runs; the text names the value and the range.
struct InputError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The calls came in the wrong order, e.g. a step before any particle was filled in.
struct UsageError : std::logic_error {
  using std::logic_error::logic_error;
};

/// The computation itself failed: not-a-number, a lost particle, a collapsed time step, a state that the equation of
/// state does not cover. The text names the particle, its position, the step and what to try.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be written completely. What was written before stays as it is.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The arguments, streamed one after the other, as one string.
template <class... Args>
std::string text(const Args&... args) {
  std::ostringstream out;
  (out << ... << args);
  return out.str();
}

/// Throws InputError("mote: " + the arguments streamed) unless `ok` holds.
template <class... Args>
void require(bool ok, const Args&... args) {
  if (!ok) throw InputError(text("mote: ", args...));
}

}  // namespace mote
