#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/ephemeris/ephemeris_file.hpp"
#include "scene/ephemeris/file_problems.hpp"
#include "scene/ephemeris/said_times.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene::ephemeris {

/// One line of a CCSDS message in the form keyword = value; views of the text.
struct KvnLine {
  std::string_view line;  ///< Without blanks at its ends.
  std::string_view key;   ///< Empty where the line has no '='.
  std::string_view value;
  std::string_view unit;  ///< Of "6655.9 [km]" the km; empty where there is none.
};

/// The lines of such a message but for blank ones and comments.
class KvnLines {
 public:
  /// Keeps a view of the text.
  explicit KvnLines(std::string_view text) : lines_(text) {}
  /// The next line; false behind the last.
  bool next(KvnLine& line);

 private:
  TextLines lines_;
};

/// The lines of a block of metadata, each keyword once.
class KvnBlock {
 public:
  /// @param known  the keywords that are kept; must outlive the block
  explicit KvnBlock(std::span<const std::string_view> known) : known_(known) {}

  /// Forgets all lines; a new block begins.
  /// @param at  the line that begins it, for what will be missing
  void begin(std::string_view at);
  /// Keeps a line. Reports a keyword that stands twice, and one that is not known: as an error where `strict`,
  /// otherwise as a warning.
  void add(const KvnLine& line, bool strict, FileProblems& problems);
  /// The value of a keyword; empty where it is missing.
  [[nodiscard]] std::string_view value(std::string_view key) const;
  /// The same; reports a keyword that is missing or has no value.
  [[nodiscard]] std::string_view required(std::string_view key, FileProblems& problems) const;
  /// The line that begins the block.
  [[nodiscard]] std::string_view at() const { return at_; }

 private:
  std::span<const std::string_view> known_;
  std::vector<KvnLine> lines_;
  std::string_view at_;
};

/// Reads START_TIME and STOP_TIME.
[[nodiscard]] TypedTimes read_typed_times(const KvnBlock& block, std::optional<radar::TimeScale> scale,
                                          FileProblems& problems);

/// Reads USEABLE_START_TIME and USEABLE_STOP_TIME.
[[nodiscard]] UsableRange read_usable(const KvnBlock& block, std::optional<radar::TimeScale> scale,
                                      FileProblems& problems);

/// Reads a method and a degree of interpolation.
/// @param method_key  "INTERPOLATION"; the degree's is INTERPOLATION_DEGREE
[[nodiscard]] InterpolationHint read_interpolation_hint(const KvnBlock& block, std::string_view method_key,
                                                        FileProblems& problems);

/// Reports a centre that is not the Earth.
/// @param at  the name in the text
void check_centre(std::string_view at, FileProblems& problems);

/// Whether a line within metadata belongs behind them: data, or the begin of the next block. Reports that META_STOP is
/// missing.
[[nodiscard]] bool misses_stop(const KvnLine& line, FileProblems& problems);

/// The number before the point of a version "2.0"; 0, and a report, where it is not among 1 to `newest`.
[[nodiscard]] int read_version(const KvnLine& line, int newest, FileProblems& problems);

}  // namespace sarsim::scene::ephemeris
