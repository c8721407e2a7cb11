#include "core/os/isolated.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

namespace sarsim::core {

namespace {

// What terminals and operators send to end programs. A terminal sends it to the child as well.
constexpr std::array<int, 3> requests{SIGINT, SIGTERM, SIGHUP};

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

// What the process has used already counts: a child begins at 0. The system ends one that ignores the first signal.
void limit_processor_time(unsigned seconds) {
  rlimit value{};
  if (::getrlimit(RLIMIT_CPU, &value) != 0) return;
  if (value.rlim_cur != RLIM_INFINITY && value.rlim_cur <= seconds) return;
  value.rlim_cur = seconds;
  ::setrlimit(RLIMIT_CPU, &value);
}

// Writes what fits into the pipe's own buffer, so that nobody has to read meanwhile.
void send(int pipe_end, const std::string& text) {
  constexpr std::size_t most = 60'000;
  const ssize_t sent = ::write(pipe_end, text.data(), std::min(text.size(), most));
  (void)sent;  // A lost text is an empty one.
}

// Handlers of the parent would only tell its copy of a flag. What it ignores, under nohup, is ignored here too.
void obey_requests() {
  for (const int signal : requests) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_IGN) std::signal(signal, SIG_DFL);
  }
}

// Nobody waits for the result when the parent is gone.
void end_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
}

struct ChildRules {
  unsigned seconds = 0;
  rlim_t mapped = 0;  // By the parent; 0 where that is not known.
  pid_t parent = 0;
};

[[noreturn]] void child(const std::function<std::string()>& work, const ChildRules& rules, int pipe_end) {
  end_with(rules.parent);
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU}) std::signal(signal, SIG_DFL);
  obey_requests();
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  limit(RLIMIT_CORE, 0);
  if (rules.mapped > 0) limit(RLIMIT_AS, rules.mapped + isolated_bytes);
  limit_processor_time(rules.seconds);
  try {
    send(pipe_end, work());
  } catch (...) {
    // An exception is an answer too.
  }
  ::_exit(0);
}

// Nothing where it is asked to end meanwhile.
std::optional<std::string> everything_from(int pipe_end, const std::function<bool()>& ends) {
  constexpr int between_questions_ms = 20;
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    pollfd ready{.fd = pipe_end, .events = POLLIN, .revents = 0};
    while (ends && ::poll(&ready, 1, between_questions_ms) <= 0)
      if (ends()) return std::nullopt;
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

// Of a child that has not passed.
IsolatedResult result_of(int status) {
  if (!WIFSIGNALED(status)) return IsolatedResult::crashed;
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU) return IsolatedResult::too_much_work;
  return std::ranges::find(requests, signal) != requests.end() ? IsolatedResult::stopped : IsolatedResult::crashed;
}

}  // namespace

std::uint64_t own_memory_limit_bytes() {
  rlimit value{};
  const rlim_t mapped = mapped_bytes();
  if (mapped == 0 || ::getrlimit(RLIMIT_AS, &value) != 0 || value.rlim_max == RLIM_INFINITY) return 0;
  return value.rlim_max < mapped + isolated_bytes ? value.rlim_max : 0;
}

IsolatedReport run_isolated(const std::function<std::string()>& work, unsigned seconds, std::mutex* lock,
                            const std::function<bool()>& ends) {
  const auto fail = [](const char* what) { throw std::system_error(errno, std::generic_category(), what); };
  const ChildRules rules{seconds, mapped_bytes(), ::getpid()};
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail("cannot make a pipe to try a file");
  const pid_t process = fork_under(lock);
  if (process < 0) {
    ::close(pipe[0]);
    ::close(pipe[1]);
    fail("cannot start a process to try a file in");
  }
  if (process == 0) child(work, rules, pipe[1]);
  ::close(pipe[1]);
  std::optional<std::string> text = everything_from(pipe[0], ends);
  ::close(pipe[0]);
  if (!text) ::kill(process, SIGKILL);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) fail("cannot wait for the process that tries a file");
  if (!text) return {IsolatedResult::stopped, {}};
  IsolatedReport report;
  report.text = std::move(*text);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return report;
  return {result_of(status), {}};
}

}  // namespace sarsim::core
