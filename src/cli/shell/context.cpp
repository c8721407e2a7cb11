#include "cli/shell/context.hpp"

#include <cerrno>
#include <ostream>
#include <system_error>

#include "core/report/retryable.hpp"

namespace sarsim::cli {

namespace {

void expect_good(const std::ostream& out) {
  if (out.good()) return;
  if (errno == EPIPE) throw OutputClosed();
  throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), "cannot write to standard output");
}

void write_bytes(Streams& streams, std::string_view bytes) {
  errno = 0;
  streams.written = true;
  streams.out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  expect_good(streams.out);
}

}  // namespace

ExitStatus status_of(const core::InvalidRequest& refused) {
  return core::is_retryable(refused) ? exit_try_again : exit_bad_input;
}

ExitStatus status_of(const std::error_code& failure) {
  return core::is_retryable(failure) ? exit_try_again : exit_failed;
}

const char* word_of(ExitStatus status) {
  switch (status) {
    case exit_done: return "done";
    case exit_bad_input: return "bad input";
    case exit_try_again: return "try again";
    case exit_failed: break;
  }
  return "failed";
}

void write_out(Streams& streams, std::string_view text) { write_bytes(streams, core::printable(text)); }

void write_data(Streams& streams, std::string_view data) {
  streams.out_terminal ? write_out(streams, data) : write_bytes(streams, data);
}

void write_err(Streams& streams, std::string_view text) { streams.err << core::printable(text); }

void flush_out(Streams& streams) {
  errno = 0;
  streams.out.flush();
  expect_good(streams.out);
}

void print_problems(Streams& streams, const core::Problems& problems) {
  for (const core::Problem& problem : problems) write_err(streams, core::to_string(problem) + '\n');
}

}  // namespace sarsim::cli
