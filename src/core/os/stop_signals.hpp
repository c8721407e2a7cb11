#pragma once

namespace sarsim::core {

/// What signals call; both have to be safe in a handler.
struct StopHooks {
  void (*request)() noexcept = nullptr;  ///< Asks the work to end.
  bool (*noticed)() noexcept = nullptr;  ///< Whether the work knows.
};

/// Makes SIGINT, SIGTERM and SIGHUP request a stop. Where the process may end alone, work that has not noticed the
/// request after 0.4 s, waiting for a pipe or deep in a calculation, is ended, as is work that has noticed it and takes
/// 10 s more. A second SIGINT or SIGTERM ends the process at once. Unfinished files are removed in every case. SIGHUP
/// that was ignored (nohup) stays so. SIGPIPE and SIGXFSZ are ignored, so that a reader that has gone and a file that
/// grows too large show as failed writes.
void install_stop_signals(StopHooks hooks, bool ends_alone);

/// The signal that requested a stop, or 0.
[[nodiscard]] int received_signal();

}  // namespace sarsim::core
