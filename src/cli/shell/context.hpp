#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "core/report/invalid_request.hpp"
#include "core/task/stop.hpp"

namespace sarsim::cli {

/// What the process answers to its caller. A command that ends after a signal answers 128 + its number.
enum ExitStatus : int {
  exit_done = 0,
  exit_failed = 1,      ///< The world's failures: disk, memory.
  exit_bad_input = 2,   ///< A mistake in a script, a data file or the arguments.
  exit_try_again = 75,  ///< Nobody's mistake: the same command may succeed later (EX_TEMPFAIL of sysexits.h).
};

/// How a command ends that was refused, or for which the system failed: whoever starts it may try again, or not.
[[nodiscard]] ExitStatus status_of(const core::InvalidRequest& refused);
[[nodiscard]] ExitStatus status_of(const std::error_code& failure);

/// How reports in JSON call an exit status: "done", "failed", "bad input", "try again".
[[nodiscard]] const char* word_of(ExitStatus status);

/// What a command works with.
struct Streams {
  std::ostream& out;      ///< Data and JSON.
  std::ostream& err;      ///< Everything else.
  bool terminal = false;  ///< `err` is a terminal: progress is drawn in place.
  const core::StopFlag* stop = nullptr;
  bool written = false;       ///< Something went to `out`.
  bool out_terminal = false;  ///< `out` is a terminal: control characters are escaped in data, too (`write_data`).
};

/// Thrown where nobody reads standard output any more; ends the command without a message.
struct OutputClosed : std::runtime_error {
  OutputClosed() : std::runtime_error("nobody reads the output") {}
};

/// Writes a text for people, or JSON, to standard output, with control characters in names escaped (`core::printable`):
/// the only place that does so. Throws OutputClosed if the reader has closed the pipe and std::system_error for other
/// failures.
void write_out(Streams& streams, std::string_view text);
/// Writes data for other programs (scenes, tables) byte for byte, except to a terminal; throws like `write_out`.
void write_data(Streams& streams, std::string_view data);
/// Brings what was written to its reader; throws like `write_out`.
void flush_out(Streams& streams);

/// Writes messages to standard error, with control characters escaped as by `write_out`.
void write_err(Streams& streams, std::string_view text);

/// Prints every problem, one paragraph each, to stderr.
void print_problems(Streams& streams, const core::Problems& problems);

}  // namespace sarsim::cli
