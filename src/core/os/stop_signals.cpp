#include "core/os/stop_signals.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

#include "core/os/temporary_files.hpp"

namespace sarsim::core {

namespace {

StopHooks on;
std::atomic<int> signal_number{0};
std::atomic<bool> may_end_alone{true};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use lock-free atomics only");

// How long work may take to notice a request, and to end once it has: what it keeps has to reach a slow disk.
constexpr timeval to_notice{.tv_sec = 0, .tv_usec = 400'000};
constexpr timeval to_end{.tv_sec = 10, .tv_usec = 0};

void wait_for_the_end(timeval time) {
  const itimerval once{.it_interval = {}, .it_value = time};
  ::setitimer(ITIMER_REAL, &once, nullptr);
}

// What was due at the last signal; handlers do nothing but calls that are safe in them.
extern "C" void on_alarm(int) {
  static std::atomic<bool> waited_for_the_end{false};
  if (on.noticed() && !waited_for_the_end.exchange(true)) {
    wait_for_the_end(to_end);
    return;
  }
  remove_temporary_files();
  constexpr std::string_view text = "\nsarsim: interrupted\n";
  const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  (void)written;  // It is the last action: a failure changes nothing.
  ::_exit(128 + signal_number.load(std::memory_order_relaxed));
}

extern "C" void on_signal(int number) {
  const int error = errno;
  int none = 0;  // A second signal may arrive in this handler, or in another thread.
  if (!signal_number.compare_exchange_strong(none, number, std::memory_order_relaxed)) {
    // A terminal that closes says so more than once: itself, and through its shell.
    if (number == SIGHUP) return;
    remove_temporary_files();
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  on.request();
  if (may_end_alone.load(std::memory_order_relaxed)) wait_for_the_end(to_notice);
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

void install_stop_signals(StopHooks hooks, bool ends_alone) {
  on = hooks;
  may_end_alone = ends_alone;
  install(SIGINT, on_signal);
  install(SIGTERM, on_signal);
  install(SIGALRM, on_alarm);
  struct sigaction hangup = {};
  // Who starts a command with nohup wants it to go on.
  if (sigaction(SIGHUP, nullptr, &hangup) != 0 || hangup.sa_handler != SIG_IGN) install(SIGHUP, on_signal);
  install(SIGPIPE, SIG_IGN);
  install(SIGXFSZ, SIG_IGN);
}

int received_signal() { return signal_number.load(std::memory_order_relaxed); }

}  // namespace sarsim::core
