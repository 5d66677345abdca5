/// \file
/// What the program tells: the plan of a dry run, summary.json, and the closing words.
#pragma once

#include <string>

#include "result.hpp"

namespace cavity {

/// The configuration, and estimates of particles, steps and memory.
std::string plan(const Options& options, const Combination& combination);

/// Writes summary.json. Throws mote::OutputError.
void write_summary(const Options& options, const Result& result, double wall_seconds);

/// What was done, how fast, and where the results are.
std::string closing_words(const Options& options, const Result& result, double wall_seconds);

}  // namespace cavity
