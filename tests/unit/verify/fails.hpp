/// \file
/// What a report should say: that all is well, or exactly what is not.
#pragma once

#include <mote/verify/report.hpp>
#include <string>
#include <vector>

#include "catch.hpp"

namespace verdict {

inline void passes(const mote::verify::Report& report) {
  INFO(report.text());
  CHECK(report.passed());
}
/// These checks fail, named in the text, and no others.
inline void fails(const mote::verify::Report& report, const std::vector<std::string>& checks) {
  INFO(report.text());
  CHECK(report.failures() == checks);
  CHECK(!report.passed());
  for (const auto& check : checks) CHECK(report.text().find("FAIL  " + check) != std::string::npos);
}

}  // namespace verdict
