#include "core/os/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace sarsim::core {

void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // Open files get the lowest free number, which is this one.
    const int taken = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (taken >= 0 && taken != stream) ::close(taken);
  }
}

bool output_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

bool errors_are_on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace sarsim::core
