#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/task/parallel.hpp"

namespace sarsim::scene::script {

/// What a piece of script text is: a value, a value in quotes, `$` with its word, or the end of the text.
enum class TokenKind : std::uint8_t { word, quoted, command, end };

/// One piece of a script; a view into the text, which must outlive it.
struct Token {
  std::string_view text;   ///< Without quotes and without `$`.
  std::size_t line = 0;    ///< From 1.
  std::size_t column = 0;  ///< From 1, in bytes; a line of commas and blanks counts each of them.
  TokenKind kind = TokenKind::end;
  bool comment_follows = false;  ///< A comment begins directly behind it, without a separator.
  bool open_quote = false;       ///< Its closing quote is missing on its line.
  bool doubled_quotes = false;   ///< Holds `""`, which stands for one quote.

  [[nodiscard]] bool is_value() const { return kind == TokenKind::word || kind == TokenKind::quoted; }
};

/// The text of a name as it is stored: the token's text with doubled quotes made single.
[[nodiscard]] std::string name_text(const Token& token);

/// Whether a character parts values: blank, tab, comma, carriage return, line feed.
[[nodiscard]] constexpr bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n';
}

/// The name as a script must show it: as it is, or in quotes where blanks, commas, `!` and the like demand it.
[[nodiscard]] std::string quoted_where_needed(std::string_view name);

/// Position of the first byte that no text file has (controls other than tab and line ends); npos for none. One or more
/// end-of-file marks (0x1A) at the very end are tolerated.
[[nodiscard]] std::size_t find_control_byte(std::string_view text, const core::WorkControl& control = {});

/// Line and column, from 1, of a byte of the text.
[[nodiscard]] Token token_at(std::string_view text, std::size_t offset);

/// Splits a script or data file into tokens, one at a time and without allocating. Copying is cheap and is how callers
/// look further ahead than one token.
///
/// Separators are blank, tab, comma, carriage return and line feed. `!` begins a comment up to the end of the line,
/// also within a word. Lines end with a line feed; in a text without any, with a carriage return.
class Tokens {
 public:
  /// Stands before the first token of a text, which must outlive it.
  explicit Tokens(std::string_view text);

  /// The tokens of the same text from the beginning of one of its lines on.
  /// @param offset  of the first byte of the line
  /// @param line    its number, from 1
  [[nodiscard]] Tokens from_line(std::size_t offset, std::size_t line) const;

  /// The text without marks at its end; what offsets count in.
  [[nodiscard]] std::string_view text() const { return text_; }
  /// What ends a line of this text.
  [[nodiscard]] char line_end() const { return line_end_; }

  /// The token that `take` would return.
  [[nodiscard]] const Token& peek() const { return slots_[ahead_]; }

  /// The token that was handed out last; an empty one before the first.
  [[nodiscard]] const Token& last() const { return slots_[1 - ahead_]; }

  /// Hands out the next token; at the end, again and again the end.
  Token take() { return pass(); }
  /// The same without a copy: the token stands until the next one is handed out.
  const Token& pass();

  /// Goes on to the next command or the end, leaving it to be taken.
  void skip_values();

  /// An upper bound for what is still to come, in bytes.
  [[nodiscard]] std::size_t remaining_bytes() const { return text_.size() - position_ + peek().text.size(); }

 private:
  void skip_separators();
  void skip_comment();
  // These fill the token ahead where it stands: a copy of what was just written would wait for it.
  void scan();
  void scan_word(TokenKind kind, std::size_t start);
  void scan_quoted();
  void scan_command();
  Token& begin_token(TokenKind kind, std::size_t start);

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
  char line_end_ = '\n';
  Token slots_[2];  // the token ahead and the one before it
  unsigned ahead_ = 0;
};

}  // namespace sarsim::scene::script
