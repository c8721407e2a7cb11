#include "cli/shell/signals.hpp"

#include <atomic>
#include <csignal>

namespace sarsim::cli {

namespace {

core::StopFlag stop_flag;
std::atomic<int> signal_number{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use lock-free atomics only");

extern "C" void on_signal(int number) {
  if (stop_flag.requested()) {
    // A terminal that closes says so more than once: itself, and through its shell.
    if (number == SIGHUP) return;
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  signal_number.store(number, std::memory_order_relaxed);
  stop_flag.request();
}

void install(int number, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, nullptr);
}

}  // namespace

const core::StopFlag& handle_signals() {
  install(SIGINT, on_signal);
  install(SIGTERM, on_signal);
  struct sigaction hangup = {};
  // Who starts a command with nohup wants it to go on.
  if (sigaction(SIGHUP, nullptr, &hangup) != 0 || hangup.sa_handler != SIG_IGN) install(SIGHUP, on_signal);
  install(SIGPIPE, SIG_IGN);
  install(SIGXFSZ, SIG_IGN);
  return stop_flag;
}

int received_signal() { return signal_number.load(std::memory_order_relaxed); }

}  // namespace sarsim::cli
