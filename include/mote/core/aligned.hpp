/// \file
/// Vectors that start at a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
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

namespace detail {

/// Starts at a cache line, and the lines of different numbers fall on different places of a page.
template <class T>
struct StaggeredAllocator {
  using value_type = T;
  static constexpr std::size_t line = 64, lines_per_page = 64;
  std::size_t lead = 0;  ///< bytes left free before the first element

  StaggeredAllocator() = default;
  explicit StaggeredAllocator(int number) : lead(std::size_t(number) * 5 % lines_per_page * line) {}
  template <class U>
  StaggeredAllocator(const StaggeredAllocator<U>& other) : lead(other.lead) {}

  T* allocate(std::size_t n) {
    return reinterpret_cast<T*>(static_cast<char*>(::operator new(n * sizeof(T) + lead, std::align_val_t(4096))) +
                                lead);
  }
  void deallocate(T* p, std::size_t) { ::operator delete(reinterpret_cast<char*>(p) - lead, std::align_val_t(4096)); }
  friend bool operator==(const StaggeredAllocator& a, const StaggeredAllocator& b) { return a.lead == b.lead; }

  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_copy_assignment = std::true_type;
};

}  // namespace detail

/// A column of numbers. Two dozen columns are read side by side, element by element: if all began at the start of a
/// page, the same element of each would compete for the same twelve lines of the first cache.
template <class T>
using StaggeredVector = std::vector<T, detail::StaggeredAllocator<T>>;

/// Room for n elements and a quarter more, so that a body that grows slowly allocates rarely.
template <class V>
void reserve_amply(V& v, std::size_t n) {
  if (v.capacity() < n) v.reserve(n + n / 4);
}

}  // namespace mote
