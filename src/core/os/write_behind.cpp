#include "core/os/write_behind.hpp"

#include <fcntl.h>

#include <cerrno>

namespace sarsim::core {

namespace {

// So much is on its way at a time that the disk is never idle; a wait for one block is over soon.
constexpr std::uint64_t blocks_behind = 8;

// Of blocks. Pipes, devices and some file systems cannot be asked, which is no error of a disk.
int sync_blocks(int descriptor, std::uint64_t first, std::uint64_t count, unsigned flags) noexcept {
  const int known = errno;
  int error = 0;
  do {
    const auto begin = static_cast<off_t>(first * write_behind_bytes);
    const auto length = static_cast<off_t>(count * write_behind_bytes);
    error = ::sync_file_range(descriptor, begin, length, flags) == 0 ? 0 : errno;
  } while (error == EINTR);
  errno = known;
  return error == EIO || error == ENOSPC || error == EDQUOT ? error : 0;
}

}  // namespace

int write_behind(int descriptor, std::uint64_t offset, std::size_t bytes) noexcept {
  const std::uint64_t first = offset / write_behind_bytes;
  const std::uint64_t last = (offset + bytes) / write_behind_bytes;
  if (first == last) return 0;
  const int error = sync_blocks(descriptor, first, last - first, SYNC_FILE_RANGE_WRITE);
  if (error != 0 || first < blocks_behind) return error;
  return sync_blocks(descriptor, first - blocks_behind, 1, SYNC_FILE_RANGE_WAIT_BEFORE);
}

}  // namespace sarsim::core
