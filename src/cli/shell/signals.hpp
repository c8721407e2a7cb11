#pragma once

#include "core/task/stop.hpp"

namespace sarsim::cli {

/// Whether a process may end by itself, or others wait for it and it for them.
enum class Company { alone, team };

/// Makes SIGINT, SIGTERM and SIGHUP request a stop. Work that has not noticed the request after 0.4 s, waiting for a
/// pipe or deep in a calculation, is ended, as is work that has noticed it and takes 10 s more; a second SIGINT or
/// SIGTERM ends the process at once. A process of a team, which waits for the others, has all the time it needs. Files
/// that mean nothing yet are removed in every case. SIGHUP that was ignored (nohup) stays so. SIGPIPE and SIGXFSZ are
/// ignored, so that a reader that has gone and a file that grows too large show as failed writes. The only global state
/// of the program.
const core::StopFlag& handle_signals(Company company = Company::alone);

/// The signal that requested a stop, or 0.
[[nodiscard]] int received_signal();

}  // namespace sarsim::cli
