/// \file
/// Catch2, v2 or v3, under v2's names: include "catch.hpp" in a test and use Approx, REQUIRE, SECTION, GENERATE.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
namespace Catch::Matchers {
inline auto ContainsSubstring(const std::string& text) { return Contains(text); }  // v3's name
}  // namespace Catch::Matchers
#endif
