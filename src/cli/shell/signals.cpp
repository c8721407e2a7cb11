#include "cli/shell/signals.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>

#include "cli/shell/end_process.hpp"
#include "core/os/temporary_files.hpp"

namespace sarsim::cli {

namespace {

core::StopFlag stop_flag;
std::atomic<int> signal_number{0};
std::atomic<bool> ends_alone{true};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use lock-free atomics only");

// When the work is looked at that was told to end, and how long what it keeps may take to reach a slow disk.
constexpr long first_look_ns = 100'000'000;
constexpr long between_looks_ns = 50'000'000;
constexpr int max_looks = 200;
// Of the time between two looks, processor time of work that goes on; others wait for a disk, or for a processor.
constexpr long working_ns = between_looks_ns / 2;

std::atomic<int> looks{0};
std::atomic<long> used_before_ns{0};
std::atomic<const std::string*> last_answer{nullptr};

// Processor time of all threads.
long used_ns() {
  timespec used{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return 1'000'000'000 * static_cast<long>(used.tv_sec) + used.tv_nsec;
}

void look_after(long ns) {
  const itimerval once{.it_interval = {}, .it_value = {.tv_sec = 0, .tv_usec = ns / 1000}};
  ::setitimer(ITIMER_REAL, &once, nullptr);
}

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written <= 0) return;  // Nobody is left to be told.
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void end_at_once() {
  core::remove_temporary_files();
  write_all(STDERR_FILENO, "\nsarsim: interrupted; nothing unfinished was left behind\n");
  if (const std::string* const answer = last_answer.exchange(nullptr)) write_all(STDOUT_FILENO, *answer);
  end_process(128 + signal_number.load(std::memory_order_relaxed));
}

// What was due at the last signal; handlers do nothing but calls that are safe in them. Looks at the work twice before
// it ends it: whether it was told at all, and whether it works on although it was.
extern "C" void on_alarm(int) {
  const int error = errno;
  const int number = looks.fetch_add(1);
  const long used = used_ns();
  const long before = used_before_ns.exchange(used);
  const bool works = used - before >= working_ns;
  if (number > 0 && (!stop_flag.noticed() || works || number > max_looks)) end_at_once();
  look_after(between_looks_ns);
  errno = error;
}

extern "C" void on_signal(int number) {
  const int error = errno;
  if (signal_number.load(std::memory_order_relaxed) != 0) {
    // A terminal that closes says so more than once: itself, and through its shell.
    if (number == SIGHUP) return;
    core::remove_temporary_files();
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  signal_number.store(number, std::memory_order_relaxed);
  stop_flag.request();
  if (ends_alone.load(std::memory_order_relaxed)) look_after(first_look_ns);
  errno = error;
}

void install(int number, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, nullptr);
}

}  // namespace

const core::StopFlag& handle_signals(Company company) {
  ends_alone = company == Company::alone;
  install(SIGINT, on_signal);
  install(SIGTERM, on_signal);
  install(SIGALRM, on_alarm);
  struct sigaction hangup = {};
  // Who starts a command with nohup wants it to go on.
  if (sigaction(SIGHUP, nullptr, &hangup) != 0 || hangup.sa_handler != SIG_IGN) install(SIGHUP, on_signal);
  install(SIGPIPE, SIG_IGN);
  install(SIGXFSZ, SIG_IGN);
  return stop_flag;
}

void answer_at_sudden_end(std::string text) {
  static std::string kept;
  last_answer = nullptr;
  kept = std::move(text);
  last_answer = &kept;
}

void answer_is_given() { last_answer = nullptr; }

void work_is_over() {
  const itimerval never{};
  ::setitimer(ITIMER_REAL, &never, nullptr);
}

int received_signal() { return signal_number.load(std::memory_order_relaxed); }

}  // namespace sarsim::cli
