#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/encode_rows.hpp"

namespace sarsim::raster {

/// What decides the bytes of a recording, by name: version of the program, script, seed, format ... Parts belong
/// together where all of it is equal.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// What differs between two identities, a sentence for each difference; empty where they fit. What the script says is
/// only named where nothing else explains the difference.
/// @param here, there  whose they are, for the sentences
[[nodiscard]] std::vector<std::string> differences(const Identity& a, const std::string& here, const Identity& b,
                                                   const std::string& there);

/// Where a part keeps its rows until the recording is whole.
enum class RowStore {
  placed,   ///< At their place in the file that all parts share.
  encoded,  ///< As the recording will hold them, one after the other, in a file of the part's own.
  volts,    ///< The same as pairs of doubles in V, because the LSB is only known when all rows are there.
};

/// The first line of every journal.
inline constexpr std::string_view journal_signature = "sarsim journal 1";

/// What the beginning of a journal says.
struct JournalHead {
  Identity identity;
  std::string part;  ///< Name of the part, for people: "3/8".
  RowRange range;    ///< Rows that it is to make; none where they are dealt out as it goes.
  RowStore store = RowStore::placed;
  std::string maker;  ///< Where it is made: "host, process 123".
};

/// Rows that are safe on the disk: one entry of a journal.
struct Claim {
  RowRange rows;
  std::uint64_t offset = 0;  ///< In the file that holds them.
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;  ///< Of these bytes.
  double seconds = 0.0;        ///< From the claim before, or the begin, to this one.
  radar::ConversionTally tally;
};

/// Whether two speak of the same bytes.
[[nodiscard]] bool same_bytes(const Claim& a, const Claim& b);

/// A journal as read.
struct Journal {
  std::filesystem::path path;
  JournalHead head;
  std::vector<Claim> claims;
  std::uint64_t bytes = 0;  ///< Of the whole entries; what follows was being written when the process ended.

  /// Rows of the claims together.
  [[nodiscard]] std::size_t claimed_rows() const;
};

/// The text of a journal's beginning and of one entry: lines that each carry a checksum of their own.
/// docs/formats/parts.md.
[[nodiscard]] std::string text_of(const JournalHead& head);
[[nodiscard]] std::string text_of(const Claim& claim);

/// Understands the text of a journal. A last line without its end was being written when the process ended and is left
/// out; any other damage is a Problem with its line. Claims that meet are damage, too.
[[nodiscard]] std::variant<Journal, core::Problem> parse_journal(const std::filesystem::path& path,
                                                                 const std::string& text);

/// Reads a journal; a Problem, too, for what is no regular file or longer than any journal
/// (`core::max_journal_bytes`). std::system_error where the file cannot be read.
[[nodiscard]] std::variant<Journal, core::Problem> read_journal(const std::filesystem::path& path);

/// Name of the file beside a journal that holds its rows where they are not placed.
[[nodiscard]] std::filesystem::path rows_file_of(const std::filesystem::path& journal);

}  // namespace sarsim::raster
