#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace sarsim::core {

/// Tells the system that memory which is about to be filled may come in large pages: hundreds of megabytes in pages of
/// 4096 bytes take longer to be provided, and to be taken back, than to be written. Only advice, and none of the memory
/// is touched.
///
/// Nothing happens below 33 MB: from 32 MB on, the C library gives an allocation a mapping of its own, which the advice
/// ends with. On its heap the advice would stay, and every growth of the heap by a few pages clear a large one.
inline void prefer_large_pages(void* data, std::size_t bytes) {
  constexpr std::uintptr_t large_page = std::uintptr_t{1} << 21;
  constexpr std::size_t own_mapping = std::size_t{33} << 20;
  if (bytes < own_mapping) return;
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(data) + large_page - 1) / large_page * large_page;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(data) + bytes) / large_page * large_page;
  ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace sarsim::core
