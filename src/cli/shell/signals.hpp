#pragma once

#include <string>

#include "core/task/stop.hpp"

namespace sarsim::cli {

/// Whether a process may end by itself, or others wait for it and it for them.
enum class Company { alone, team };

/// Makes SIGINT, SIGTERM and SIGHUP request a stop. Work that has not noticed the request after 0.15 s, waiting for a
/// pipe or deep in a calculation, is ended, as is work that has noticed it and computes on; where it waits instead, for
/// a disk that takes what it keeps, or for a processor, it has 10 s. A second SIGINT or SIGTERM ends the process at
/// once. A process of a team, which waits for the others, has all the time it needs. Files that mean nothing yet are
/// removed in every case. SIGHUP that was ignored (nohup) stays so. SIGPIPE and SIGXFSZ are ignored, so that a reader
/// that has gone and a file that grows too large show as failed writes. The only global state of the program.
const core::StopFlag& handle_signals(Company company = Company::alone);

/// What the command answers on standard output where it is ended at once, until it has answered something itself.
void answer_at_sudden_end(std::string text);

/// The command has answered: nothing is added to that.
void answer_is_given();

/// The command has ended by itself, and nothing ends it any more.
void work_is_over();

/// The signal that requested a stop, or 0.
[[nodiscard]] int received_signal();

}  // namespace sarsim::cli
