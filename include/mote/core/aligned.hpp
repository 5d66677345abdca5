/// \file
/// Vectors that start at a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace mote {

namespace detail {

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
  /// Leaves new numbers as they are: what nobody writes is never touched.
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class First, class... Rest>
  void construct(U* p, First&& first, Rest&&... rest) {
    ::new (static_cast<void*>(p)) U(std::forward<First>(first), std::forward<Rest>(rest)...);
  }

  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

}  // namespace detail

/// A vector whose data starts at a cache line, so that a node's record is loaded and stored in one piece: a store that
/// crosses a line is not forwarded to the next load, and the scatter would wait for it.
template <class T>
using AlignedVector = std::vector<T, detail::CacheLineAllocator<T>>;

/// Room for n elements and a quarter more, so that a body that grows slowly allocates rarely.
template <class V>
void reserve_amply(V& v, std::size_t n) {
  if (v.capacity() < n) v.reserve(n + n / 4);
}

}  // namespace mote
