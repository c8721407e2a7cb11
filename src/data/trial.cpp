#include "data/trial.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <system_error>

namespace sarsim {

namespace {

constexpr rlim_t more_bytes = rlim_t{512} << 20U;

// Address space of this process in bytes; 0 where the system does not say.
rlim_t mapped_bytes() {
  std::ifstream statm("/proc/self/statm");
  unsigned long pages = 0;
  if (!(statm >> pages)) return 0;
  return static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t most) {
  rlimit value{};
  if (::getrlimit(resource, &value) != 0) return;
  if (value.rlim_max != RLIM_INFINITY && value.rlim_max < most) return;
  value.rlim_cur = most;
  ::setrlimit(resource, &value);
}

// Writes what fits into the pipe's own buffer, so that nobody has to read meanwhile.
void send(int pipe_end, const std::string& text) {
  constexpr std::size_t most = 60'000;
  const ssize_t sent = ::write(pipe_end, text.data(), std::min(text.size(), most));
  (void)sent;  // A lost text is an empty one.
}

[[noreturn]] void child(const std::function<std::string()>& work, unsigned seconds, rlim_t mapped, int pipe_end) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM, SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  limit(RLIMIT_CORE, 0);
  if (mapped > 0) limit(RLIMIT_AS, mapped + more_bytes);
  ::alarm(seconds);
  try {
    send(pipe_end, work());
  } catch (...) {
    // An exception is an answer too.
  }
  ::_exit(0);
}

std::string everything_from(int pipe_end) {
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t got = ::read(pipe_end, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(got));
  }
}

// The lock is open again in both processes.
pid_t fork_under(std::mutex* lock) {
  if (lock == nullptr) return ::fork();
  const std::scoped_lock hold(*lock);
  return ::fork();
}

}  // namespace

TrialReport run_trial(const std::function<std::string()>& work, unsigned seconds, std::mutex* lock) {
  const auto fail = [](const char* what) { throw std::system_error(errno, std::generic_category(), what); };
  const rlim_t mapped = mapped_bytes();
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot make a pipe to try a file");
  const pid_t process = fork_under(lock);
  if (process < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    fail("cannot start a process to try a file in");
  }
  if (process == 0) child(work, seconds, mapped, ends[1]);
  ::close(ends[1]);
  TrialReport report;
  report.text = everything_from(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) fail("cannot wait for the process that tries a file");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return report;
  const bool late = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  return {late ? TrialResult::timed_out : TrialResult::crashed, {}};
}

}  // namespace sarsim
