#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "core/os/journal_file.hpp"
#include "workflow/sweep/sweep_request.hpp"
#include "workflow/sweep/sweep_row.hpp"

namespace sarsim::workflow {

/// A text file in which a sweep notes every product as soon as it is complete, so that a later run can leave it out. A
/// line for each; a last line that was cut off is as good as none.
class SweepJournal {
 public:
  /// Opens the journal for additions, or begins it anew.
  /// @throws std::system_error "cannot write FILE"; core::RetryableError where another process has it
  SweepJournal(const std::filesystem::path& path, bool keep);

  /// Notes a product; from any thread.
  void add(const SweepRow& row);
  /// Notes that a row's file is begun: from then on a file of its name may be the sweep's own.
  void add_begun(const SweepRow& row);

 private:
  std::mutex lock_;
  core::JournalFile file_;
};

/// Whether a sweep may add lines to a file: it is missing or empty, or its first line is that of a journal of a sweep.
[[nodiscard]] bool takes_journal_lines(const std::filesystem::path& path);

/// Looks whether other processes are making variations of a part of a sweep, which shows in the journals of
/// `read_journals`.
/// @throws core::RetryableError where one does
void expect_nobody_at_work(const std::filesystem::path& folder, const std::string& stem, const SweepPart& part);

/// What the journals of a sweep say, by the name of the product: those of all its parts, which are `stem`.journal and
/// `stem`-....journal in its folder. Of several lines about a product the latest is kept, but one without a file does
/// not take the place of one with a file that is otherwise the same.
[[nodiscard]] std::map<std::string, SweepRow> read_journals(const std::filesystem::path& folder,
                                                            const std::string& stem);

/// A line of a journal, without its end, and back; false where it is none.
[[nodiscard]] std::string journal_line(const SweepRow& row);
[[nodiscard]] bool read_journal_line(const std::string& line, SweepRow& row);

/// When a file's content was last changed, as a number that only serves to be compared; nothing where there is none.
[[nodiscard]] std::optional<std::int64_t> modification_time(const std::filesystem::path& file);

}  // namespace sarsim::workflow
