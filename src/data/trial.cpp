#include "data/trial.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

[[noreturn]] void child(const std::function<void()>& work, unsigned seconds, rlim_t mapped) {
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
    work();
  } catch (...) {
    // An exception is an answer: the same call in the parent gives it again.
  }
  ::_exit(0);
}

}  // namespace

TrialResult run_trial(const std::function<void()>& work, unsigned seconds) {
  const rlim_t mapped = mapped_bytes();
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process to try a file in");
  if (process == 0) child(work, seconds, mapped);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "cannot wait for the process that tries a file");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return TrialResult::passed;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? TrialResult::timed_out : TrialResult::crashed;
}

}  // namespace sarsim
