#pragma once

#include "core/task/stop.hpp"

namespace sarsim::cli {

/// Makes SIGINT, SIGTERM and SIGHUP request a stop; a second SIGINT or SIGTERM ends the process at once. SIGHUP that
/// was ignored (nohup) stays so. SIGPIPE and SIGXFSZ are ignored, so that a reader that has gone and a file that grows
/// too large show as failed writes. The only global state of the program.
const core::StopFlag& handle_signals();

/// The signal that requested a stop, or 0.
[[nodiscard]] int received_signal();

}  // namespace sarsim::cli
