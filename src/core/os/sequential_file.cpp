#include "core/os/sequential_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace sarsim::core {

// Without O_NONBLOCK the opening of a pipe would wait for a writer.
SequentialFile::SequentialFile(const std::filesystem::path& path, std::function<void()> ask)
    : ask_(std::move(ask)), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (descriptor_ < 0) failure_ = errno;
}

SequentialFile::~SequentialFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t SequentialFile::read(std::span<char> bytes) {
  while (failure_ == 0) {
    ask_();
    const ssize_t got = ::read(descriptor_, bytes.data(), bytes.size());
    if (got > 0) return begun_ = true, static_cast<std::size_t>(got);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno != EAGAIN) return failure_ = errno, 0;
    // A pipe that has no writer yet ends like one that its writer has left.
    if (got == 0 && (begun_ || !waits())) return 0;
    if (got < 0) static_cast<void>(waits());
  }
  return 0;
}

bool SequentialFile::waits() const {
  constexpr int patience_ms = 20;
  pollfd wanted{.fd = descriptor_, .events = POLLIN, .revents = 0};
  static_cast<void>(::poll(&wanted, 1, patience_ms));
  struct stat status {};
  const bool pipe = ::fstat(descriptor_, &status) == 0 && S_ISFIFO(status.st_mode);
  return pipe && (wanted.revents & (POLLHUP | POLLERR)) == 0;
}

}  // namespace sarsim::core
