#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/text/letters.hpp"

namespace sarsim::scene::ephemeris {

/// A text without the byte order mark of UTF-8 at its beginning; a view of the same characters.
[[nodiscard]] constexpr std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

/// The lines of a text, one after the other.
class TextLines {
 public:
  /// Keeps a view of the text; a byte order mark is passed over.
  explicit TextLines(std::string_view text) : rest_(without_mark(text)) {}

  /// The next line without the characters that end it; false behind the last.
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return true;
  }

  /// The next line that is not blank, without blanks at its ends.
  bool next_filled(std::string_view& line) {
    while (next(line)) {
      line = core::trimmed(line);
      if (!line.empty()) return true;
    }
    return false;
  }

  /// What has not been given yet.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// Splits a line at blanks and tabs.
/// @param[out] cells  the first words
/// @returns the number of words, which may be more than there are cells
inline std::size_t split_words(std::string_view line, std::span<std::string_view> cells) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && core::is_blank(line[at])) ++at;
    const std::size_t begin = at;
    while (at < line.size() && !core::is_blank(line[at])) ++at;
    if (at == begin) break;
    if (count < cells.size()) cells[count] = line.substr(begin, at - begin);
    ++count;
  }
  return count;
}

/// The columns [first, last] of a line, from 1, as far as it has them; for formats whose columns are fixed.
[[nodiscard]] constexpr std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  return first > line.size() ? line.substr(line.size()) : line.substr(first - 1, last - first + 1);
}

}  // namespace sarsim::scene::ephemeris
