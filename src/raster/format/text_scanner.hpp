#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/os/input_file.hpp"

namespace sarsim::raster {

/// A number as it stands in a text: whole numbers exactly, others as the nearest double.
struct TextNumber {
  bool whole = false;
  bool negative = false;
  std::uint64_t magnitude = 0;  ///< Where whole.
  double value = 0.0;
};

/// The bytes of a file one after the other, with the place of each. Holds a small part of the file at a time.
class TextScanner {
 public:
  static constexpr int end = -1;

  /// Begins at a place of the file, which is said to be the beginning of a line.
  TextScanner(const core::InputFile& file, std::uint64_t offset, std::size_t line);

  /// The next byte, or `end`.
  int peek() {
    if (next_ == filled_ && !fill()) return end;
    return static_cast<unsigned char>(buffer_[next_]);
  }
  /// Goes past the byte that `peek` gave.
  void advance() {
    if (buffer_[next_] == '\n') {
      ++line_;
      line_start_ = offset() + 1;
    }
    ++next_;
  }

  [[nodiscard]] std::uint64_t offset() const { return base_ + next_; }
  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t column() const { return static_cast<std::size_t>(offset() - line_start_) + 1; }

  /// Skips blanks, tabs and carriage returns.
  void skip_blanks() {
    if (!beyond_white()) skip_more_blanks();
  }
  /// Skips all white space and returns the number of line feeds in it.
  std::size_t skip_white_space() { return beyond_white() ? 0 : skip_more_white_space(); }
  /// Skips what is left of the line and its end.
  void skip_line();
  /// Takes everything up to white space, a comma, a bracket or the end; at most `longest_token` bytes.
  [[nodiscard]] std::string take_token();
  /// Takes a number up to the same ends; where there is none, false and `token` holds the text that stands there.
  bool take_number(TextNumber& number, std::string& token);

  static constexpr std::size_t longest_token = 400;

 private:
  // Whether the next byte is in the buffer and certainly no white space.
  [[nodiscard]] bool beyond_white() const { return next_<filled_&& static_cast<unsigned char>(buffer_[next_])> ' '; }
  void skip_more_blanks();
  std::size_t skip_more_white_space();
  bool fill();
  bool take_short_number(TextNumber& number);

  const core::InputFile& file_;
  std::vector<char> buffer_;
  std::size_t next_ = 0;
  std::size_t filled_ = 0;
  std::uint64_t base_;        // Offset of the buffer in the file.
  std::uint64_t line_start_;  // Offset of the current line in the file.
  std::size_t line_;
};

}  // namespace sarsim::raster
