/// \file
/// What an executor offers.
#pragma once

#include <concepts>
#include <cstddef>

#include <mote/core/role.hpp>

namespace mote {

/// See execution::Serial for the two members and what they promise.
template <class E>
concept Execution = HasRole<E, role::Execution> && requires(const E& e, void (*f)(std::size_t)) {
  { e.concurrency() } -> std::convertible_to<int>;
  e.for_each(std::size_t(1), f);
};

}  // namespace mote
