#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/os/raw_file.hpp"

/// Journals: text files that only grow, a line for everything that has been done, so that a later process knows what an
/// ended one has done. A last line without its end was being written when the process ended.
namespace sarsim::core {

/// A line with a checksum of its own behind it, " #" and 16 hexadecimal digits (XXH64), and its end.
[[nodiscard]] std::string sealed_line(std::string_view content);
/// What stands before the seal of a line, which comes without its end; nothing where the two do not fit.
[[nodiscard]] std::optional<std::string_view> unsealed_line(std::string_view line);

/// The lines of a journal's text, as views into it.
struct JournalLines {
  std::vector<std::string_view> whole;  ///< Without their ends.
  std::string_view cut_off;             ///< The last one where it has no end; else empty.
};
[[nodiscard]] JournalLines lines_of_journal(std::string_view text);

/// More than any journal holds: seven million entries of 150 bytes, one a second for eighty days.
inline constexpr std::uint64_t max_journal_bytes = std::uint64_t{1} << 30U;

/// All of a journal, which another process may be adding to.
/// @throws std::system_error "cannot read FILE"; InvalidRequest where it is no regular file or longer than
/// max_journal_bytes
[[nodiscard]] std::string read_journal_file(const std::filesystem::path& path);

/// A journal to which lines are added. Every failure is a std::system_error that names the action and the file. One
/// thread at a time.
class JournalFile {
 public:
  JournalFile() = default;
  /// Lines come behind what the file holds. Each is on the disk when it has been added: a loss of power does not take
  /// it. The file belongs to this process alone (`RawFile::try_lock`).
  explicit JournalFile(RawFile file);

  /// Opens a journal for lines that outlast their process but not a loss of power.
  /// @throws RetryableError where another process has it open so; it is left as it is then
  /// @param keep     what is there; else the journal begins anew
  /// @param heading  the first line, with its end, of a journal that has none
  [[nodiscard]] static JournalFile open(const std::filesystem::path& path, bool keep, std::string_view heading);

  /// Cuts off what follows the whole lines.
  void cut(std::uint64_t whole_bytes);
  /// Adds lines, each with its end.
  void add(std::string_view lines);

  [[nodiscard]] const RawFile& file() const { return file_; }

 private:
  RawFile file_;
  std::uint64_t end_ = 0;
  bool appends_ = false;
};

}  // namespace sarsim::core
