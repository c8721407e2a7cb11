#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/toml/document.hpp"

/// The smallest parts of TOML: bytes, escapes, and where a string, key or value ends. None of these functions reads
/// outside of the text, whatever the position.
namespace sarsim::core::toml {

/// Classes of bytes, to be combined with `|`.
enum ByteClass : std::uint8_t {
  bare_byte = 1,     ///< Of a bare key: ASCII letters, digits, `_`, `-`.
  scalar_byte = 2,   ///< Of a number, boolean or date-time: also `+`, `.`, `:`.
  plain_byte = 4,    ///< Stands for itself in comments and strings: tab and printable ASCII.
  blank_byte = 8,    ///< Blank and tab.
  bracket_byte = 16  ///< What matters where brackets are counted: brackets, braces, quotes and `#`.
};

/// The classes of every byte.
constexpr std::array<std::uint8_t, 256> make_byte_classes() {
  std::array<std::uint8_t, 256> classes{};
  const auto add = [&](std::string_view bytes, unsigned kinds) {
    for (const char c : bytes) classes[static_cast<unsigned char>(c)] |= static_cast<std::uint8_t>(kinds);
  };
  for (std::size_t c = 0x20; c < 0x7F; ++c) classes[c] = plain_byte;
  add("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-", bare_byte | scalar_byte);
  add("+.:", scalar_byte);
  add("\t", plain_byte);
  add(" \t", blank_byte);
  add("[]{}\"'#", bracket_byte);
  return classes;
}
inline constexpr std::array<std::uint8_t, 256> byte_classes = make_byte_classes();

/// Whether a byte is of one of the classes.
[[nodiscard]] constexpr bool is(char c, unsigned classes) {
  return (byte_classes[static_cast<unsigned char>(c)] & classes) != 0;
}

/// The first position from `at` on whose byte is of none of the classes; the text's size where there is none.
[[nodiscard]] constexpr std::size_t skip(std::string_view text, std::size_t at, unsigned classes) {
  while (at < text.size() && is(text[at], classes)) ++at;
  return at;
}

/// The byte at a position, 0 behind the end of the text.
[[nodiscard]] constexpr char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? text[at] : '\0';
}

/// Length of the line end at a position: 1 for a line feed, 2 for one behind a carriage return, otherwise 0.
[[nodiscard]] constexpr std::size_t line_end_length(std::string_view text, std::size_t at) {
  if (byte_at(text, at) == '\n') return 1;
  return byte_at(text, at) == '\r' && byte_at(text, at + 1) == '\n' ? 2 : 0;
}

/// Position of the line feed that ends the line of `at`, or the text's size.
[[nodiscard]] std::size_t line_feed(std::string_view text, std::size_t at);

/// A span of positions in a text of at most `longest_text` bytes.
[[nodiscard]] constexpr Span span_of(std::size_t begin, std::size_t end) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// A backslash with what belongs to it.
struct Escape {
  std::size_t length = 0;   ///< In bytes, with the backslash; 0 where it is none of TOML.
  char32_t character = 0;   ///< What it stands for.
  bool line_break = false;  ///< It ends its line and stands for nothing: the blanks and lines behind it are skipped.
};

/// The escape that begins at a backslash.
/// @param multi_line  whether a backslash may end a line here
[[nodiscard]] Escape read_escape(std::string_view text, std::size_t at, bool multi_line);

/// A string as its quotes show it.
struct Quotes {
  std::size_t end = 0;  ///< Behind the closing quotes; 0 where they are missing.
  Span inner;           ///< What is between the quotes, without a line end directly behind three opening ones.
  bool triple = false;  ///< Three quotes: the string may have several lines.
  bool basic = false;   ///< Double quotes: a backslash begins an escape.
};

/// The string that begins at a quote.
/// @param may_be_triple  false for keys, where `""` is all of it
[[nodiscard]] Quotes read_quotes(std::string_view text, std::size_t at, bool may_be_triple);

/// Behind the part of a key, bare or in quotes, that begins at `at`; `at` itself where none does.
[[nodiscard]] std::size_t key_part_end(std::string_view text, std::size_t at);

/// Behind the dotted key that begins at `at`, without blanks behind it; `at` itself where none does.
[[nodiscard]] std::size_t key_end(std::string_view text, std::size_t at);

/// Behind the number, boolean, date-time or word that begins at `at`; `at` itself where none does.
[[nodiscard]] std::size_t scalar_end(std::string_view text, std::size_t at);

/// What such a word is, told by its look alone; it need not be valid.
[[nodiscard]] Kind scalar_kind(std::string_view word);

/// Behind the array or inline table that begins at `at`, found by counting brackets; the text's size where it is open.
[[nodiscard]] std::size_t bracket_end(std::string_view text, std::size_t at);

/// The first byte sequence of `span` that a comment or string must not hold: control characters, what is not UTF-8, a
/// carriage return without a line feed, and with `basic` a wrong escape.
/// @param lines  whether line ends are allowed
[[nodiscard]] std::optional<Span> find_forbidden(std::string_view text, Span span, bool basic, bool lines);

}  // namespace sarsim::core::toml
