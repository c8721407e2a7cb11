#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sarsim::core::toml {

/// Bytes [begin, end) of a text.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend bool operator==(const Span&, const Span&) = default;
};

/// The bytes of a span; what lies outside of the text is left out.
[[nodiscard]] constexpr std::string_view piece(std::string_view text, Span span) {
  const std::size_t begin = std::min<std::size_t>(span.begin, text.size());
  return text.substr(begin, std::max<std::size_t>(span.end, begin) - begin);
}

/// What a value is, as its notation tells.
enum class Kind : std::uint8_t {
  string,
  integer,
  floating,
  boolean,
  offset_date_time,
  local_date_time,
  local_date,
  local_time,
  array,
  table,  ///< An inline table.
};

/// One value as it stands in the text, with its quotes or brackets.
struct Value {
  Kind kind = Kind::string;
  Span span;
};

/// One line `key = value`.
struct Entry {
  Span key;  ///< The whole key as typed, with its dots and quotes.
  Value value;
};

/// A header with the entries behind it, up to the next header.
struct Table {
  Span header;           ///< From `[` to `]`; empty for the root, at the first byte behind a byte order mark.
  Span name;             ///< Inside of the brackets, without blanks at its ends.
  bool element = false;  ///< `[[name]]`: one more element of an array of tables.
  bool broken = false;   ///< The header has a mistake: nobody knows where the entries belong.
  std::uint32_t first_entry = 0;
  std::uint32_t entries = 0;
};

/// One thing that is wrong with a text, in words for people.
struct Mistake {
  Span at;               ///< The bytes to blame; of the rest of a line the first 100.
  std::string message;   ///< What is wrong: "string is not closed".
  std::string found;     ///< The text to blame, at most 60 bytes of one line; may be empty.
  std::string expected;  ///< What would have been right: "a closing \""; may be empty.
  std::string hint;      ///< How to mend it; may be empty.
};

/// A TOML text taken apart. It refers to the text by offsets and holds no part of it.
struct Document {
  std::vector<Table> tables;      ///< The root first, then in the order of the text.
  std::vector<Entry> entries;     ///< In the order of the text; those with a mistake are left out.
  std::vector<Mistake> mistakes;  ///< By position; a text without any is valid TOML 1.0.0.
};

/// Longest text that `parse` takes, in bytes.
inline constexpr std::size_t longest_text = std::size_t{1} << 30U;

/// Arrays and inline tables nest at most so deep.
inline constexpr std::size_t deepest_nesting = 100;

}  // namespace sarsim::core::toml
