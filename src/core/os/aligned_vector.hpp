#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace sarsim::core {

/// Gives memory that begins with a cache line.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  /// Room for `count` values.
  [[nodiscard]] T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(::operator new(count * sizeof(T), alignment));
  }
  /// Gives it back.
  void deallocate(T* data, std::size_t) { ::operator delete(data, alignment); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

/// A vector for hot loops in SIMD. The C library begins memory 16 bytes behind a cache line, so that every vector of 64
/// bytes would lie across two lines and take twice as long.
template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace sarsim::core
