#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "raster/format/text_scanner.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

/// How the numbers of a text make rows.
struct TextLayout {
  TextStyle style = TextStyle::lines;  ///< Not none.
  std::size_t columns = 0;             ///< Above 0: rows of ASCII and BRACKET end after so many samples.
};

/// What numbers of a text have in common.
struct TextValues {
  bool whole = true;
  bool negative = false;
  std::uint64_t highest = 0;  ///< Of the whole ones, without their sign.

  /// Takes one more number into account.
  void note(const TextNumber& number) {
    whole = whole && number.whole;
    negative = negative || number.value < 0.0;
    highest = std::max(highest, number.magnitude);
  }
  /// Whether they may be counts with the offset of a converter.
  [[nodiscard]] bool may_have_offset(const CountRange& range) const {
    return whole && !negative && highest <= range.highest_stored();
  }
};

/// What `parse_row` found.
struct TextRow {
  std::size_t values = 0;  ///< Numbers of the row; 0 at the end of the file.
  std::size_t line = 0;    ///< Place of its last number.
  std::size_t column = 0;
  std::optional<core::Problem> malformed;  ///< With line and column, without the file's name.
};

/// Takes the next row, giving each number to `put(const TextNumber&)`.
template <class Put>
class TextRowParser {
 public:
  TextRowParser(TextScanner& scanner, const TextLayout& layout, Put put)
      : scanner_(scanner), layout_(layout), put_(put) {}

  /// Reads the next row; one without values and without a problem is the end of the file.
  TextRow parse() {
    row_ = {};
    scanner_.skip_white_space();
    if (scanner_.peek() == TextScanner::end) return row_;
    switch (layout_.style) {
      case TextStyle::commas: parse_csv(); break;
      case TextStyle::brackets: parse_bracket(); break;
      default: parse_ascii(); break;
    }
    return row_;
  }

 private:
  [[nodiscard]] bool full() const { return layout_.columns > 0 && row_.values == 2 * layout_.columns; }

  void parse_ascii() {
    while (take_value()) {
      if (full()) return;
      const std::size_t lines = scanner_.skip_white_space();
      if (scanner_.peek() == TextScanner::end) return;
      if (lines > 1 && layout_.columns == 0) return;
    }
  }

  void parse_csv() {
    while (take_value()) {
      scanner_.skip_blanks();
      const int c = scanner_.peek();
      if (c == '\n' || c == TextScanner::end) return;
      if (!take(',', "a comma or the end of the line")) return;
      scanner_.skip_blanks();
      if (scanner_.peek() == '\n' || scanner_.peek() == TextScanner::end) return;  // A comma may end the line.
    }
  }

  void parse_bracket() {
    while (take_pair()) {
      if (full()) return;
      const std::size_t lines = scanner_.skip_white_space();
      if (scanner_.peek() == TextScanner::end) return;
      if (lines > 0 && layout_.columns == 0) return;
    }
  }

  bool take_pair() {
    if (!take('(', "an opening bracket")) return false;
    scanner_.skip_blanks();
    if (!take_value()) return false;
    scanner_.skip_blanks();
    if (!take(',', "a comma")) return false;
    scanner_.skip_blanks();
    if (!take_value()) return false;
    scanner_.skip_blanks();
    return take(')', "a closing bracket");
  }

  bool take_value() {
    const std::size_t line = scanner_.line();
    const std::size_t column = scanner_.column();
    if (!scanner_.take_number(number_, token_)) return fail(line, column, token_, "a number");
    row_.line = line;
    row_.column = column;
    ++row_.values;
    put_(number_);
    return true;
  }

  bool take(char c, const char* expected) {
    if (scanner_.peek() == c) {
      scanner_.advance();
      return true;
    }
    const std::size_t line = scanner_.line();
    const std::size_t column = scanner_.column();
    return fail(line, column, scanner_.take_token(), expected);
  }

  bool fail(std::size_t line, std::size_t column, const std::string& token, const char* expected);

  TextScanner& scanner_;
  TextLayout layout_;
  Put put_;
  TextRow row_;
  TextNumber number_;
  std::string token_;
};

/// The problem of a text that cannot be read on at a place; `token` is made printable, `next` is the byte behind it.
[[nodiscard]] core::Problem malformed_text(std::size_t line, std::size_t column, const std::string& token, int next,
                                           const char* expected);

template <class Put>
bool TextRowParser<Put>::fail(std::size_t line, std::size_t column, const std::string& token, const char* expected) {
  row_.malformed = malformed_text(line, column, token, scanner_.peek(), expected);
  return false;
}

}  // namespace sarsim::raster
