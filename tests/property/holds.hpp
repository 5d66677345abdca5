/// \file
/// rc::check for properties that draw their inputs themselves. RapidCheck's machinery is compiled once for all of them,
/// not once for each.
#pragma once

#include <rapidcheck.h>

#include <functional>

inline bool holds(const std::function<void()>& property) { return rc::check(property); }
