#pragma once

namespace sarsim::cli {

/// Ends the process at once, as `_exit` does, without what takes the system long: to take back the memory, and the
/// files that have no name any more and are still open here, which is a second for some gigabytes and holds up whoever
/// waits for the process. A child, which has neither other files nor streams, keeps both until this process is gone.
/// Where there can be no child, it ends as `_exit` does. May be called by a signal handler.
[[noreturn]] void end_process(int status) noexcept;

}  // namespace sarsim::cli
