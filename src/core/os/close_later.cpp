#include "core/os/close_later.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <exception>
#include <thread>
#include <vector>

#include "core/os/temporary_files.hpp"
#include "core/os/temporary_names.hpp"

namespace sarsim::core {

namespace {

constexpr off_t piece_bytes = off_t{64} << 20U;  // Given back in some ten milliseconds.

off_t size_of(int descriptor) noexcept {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 0 ? status.st_size : 0;
}

// A file that cannot be cut off, because it is open for reading alone, is given back as a whole.
void give_back(int descriptor) noexcept {
  for (off_t size = size_of(descriptor); size > piece_bytes;) {
    size -= piece_bytes;
    if (::ftruncate(descriptor, size) != 0 && errno != EINTR) break;
  }
  ::close(descriptor);
}

}  // namespace

void close_later(std::span<const int> descriptors) noexcept {
  off_t bytes = 0;
  for (const int descriptor : descriptors) bytes += size_of(descriptor);
  std::atomic<int>& at_work = temporary_names().closing;
  if (bytes > piece_bytes) try {
      at_work.fetch_add(1);
      std::thread([own = std::vector<int>(descriptors.begin(), descriptors.end()), &at_work] {
        for (const int descriptor : own) give_back(descriptor);
        at_work.fetch_sub(1);
      }).detach();
      return;
    } catch (const std::exception&) {
      at_work.fetch_sub(1);  // No thread is to be had: the caller waits.
    }
  for (const int descriptor : descriptors) ::close(descriptor);
}

bool closes_later() noexcept { return temporary_names().closing.load() > 0; }

}  // namespace sarsim::core
