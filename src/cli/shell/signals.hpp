#pragma once

#include "core/task/stop.hpp"

namespace sarsim::cli {

/// Whether a process may end by itself, or others wait for it and it for them.
enum class ProcessGroup { alone, team };

/// The flag that SIGINT, SIGTERM and SIGHUP set (core/os/stop_signals.hpp). A process of a team, which waits for the
/// others, has all the time it needs. The only global state of the program.
const core::StopFlag& handle_signals(ProcessGroup company = ProcessGroup::alone);

/// The signal that requested a stop, or 0.
[[nodiscard]] int received_signal();

}  // namespace sarsim::cli
