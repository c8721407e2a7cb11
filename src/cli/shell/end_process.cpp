#include "cli/shell/end_process.hpp"

#include <sched.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <ctime>

namespace sarsim::cli {

namespace {

constexpr int max_descriptors = 4096;
constexpr std::size_t stack_bytes = std::size_t{64} << 10U;

// The child shares the memory of the process, and so what the C library keeps for the thread that made it: it makes
// bare calls of the system, and none that sanitizers see.
#define SARSIM_BARE [[gnu::no_sanitize("thread", "address", "undefined")]]

SARSIM_BARE bool is_removed_file(int descriptor) noexcept {
  struct stat status;
  return ::syscall(SYS_fstat, descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 0;
}

// Whoever reads from a pipe of the process waits for its last descriptor, and locks are held as long as their files are
// open: nothing but files without a name is kept.
SARSIM_BARE void keep_removed_files_alone() noexcept {
  for (int descriptor = 0; descriptor < max_descriptors; ++descriptor)
    if (!is_removed_file(descriptor)) ::syscall(SYS_close, descriptor);
  ::syscall(SYS_close_range, static_cast<unsigned>(max_descriptors), ~0U, 0U);
}

SARSIM_BARE int outlive(void* parent) noexcept {
  constexpr int max_waits = 1000;
  keep_removed_files_alone();
  const timespec moment{.tv_sec = 0, .tv_nsec = 1'000'000};
  for (int i = 0; i < max_waits && ::syscall(SYS_getppid) == *static_cast<const long*>(parent); ++i)
    ::syscall(SYS_nanosleep, &moment, nullptr);
  ::syscall(SYS_exit_group, 0);
  return 0;
}

#undef SARSIM_BARE

}  // namespace

void end_process(int status) noexcept {
  alignas(64) static std::array<std::byte, stack_bytes> stack;
  static long self = 0;
  self = ::syscall(SYS_getpid);
  ::clone(outlive, stack.data() + stack.size(), CLONE_VM, &self);
  ::_exit(status);
}

}  // namespace sarsim::cli
