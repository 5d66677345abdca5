/// \file
/// One thread.
#pragma once

#include <cstddef>

#include <mote/core/role.hpp>

namespace mote::execution {

/// Calls one after the other, on the caller's thread.
///
/// A host's own executor is a copyable type with this role and these two members. for_each(n, f) calls f(i) for
/// every i < n, in any order and on any thread, returns when all are done, and rethrows what an f threw.
struct Serial {
  using role = mote::role::Execution;

  int concurrency() const { return 1; }

  template <class F>
  void for_each(std::size_t n, const F& f) const {
    for (std::size_t i = 0; i < n; ++i) f(i);
  }
};

}  // namespace mote::execution
