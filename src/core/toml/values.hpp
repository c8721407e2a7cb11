#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/toml/document.hpp"

/// Reads values and keys of a text that `parse` found valid. On any other text, or with a span from elsewhere, nothing
/// bad happens: the result is nothing, empty, or whatever the bytes look like.
namespace sarsim::core::toml {

/// One of the values inside of an array or inline table.
struct Element {
  Span key;  ///< The dotted key as typed, in an inline table; empty in an array.
  Value value;
};

/// Hands out the values inside of an array or inline table one after the other, without storing them. The text must
/// outlive it.
class Elements {
 public:
  /// Stands before the first value; a container of another kind has none.
  Elements(std::string_view text, const Value& container);

  /// The next value; nothing behind the last one.
  [[nodiscard]] std::optional<Element> next();

 private:
  std::string_view text_;  // up to the closing bracket
  std::size_t position_ = 0;
  bool keyed_ = false;
};

/// What a string means: its escapes resolved, the line end behind opening `"""` and what a backslash at a line's end
/// skips left out. Line ends become line feeds. Empty for other kinds.
[[nodiscard]] std::string decoded_string(std::string_view text, const Value& value);

/// The next part of a dotted key, as typed.
/// @param rest  the key; what is behind the part is left in it
/// @returns nothing behind the last part
[[nodiscard]] std::optional<Span> next_key_part(std::string_view text, Span& rest);

/// What one part of a key means: bare, or without its quotes and escapes.
[[nodiscard]] std::string decoded_key_part(std::string_view text, Span part);

/// The parts of a dotted key, decoded: {"a", "b c"} for `a."b c"`.
[[nodiscard]] std::vector<std::string> key_parts(std::string_view text, Span key);

/// An integer or floating number as the nearest double: infinite where it is beyond all doubles. Nothing for other
/// kinds.
[[nodiscard]] std::optional<double> number(std::string_view text, const Value& value);

/// An integer (decimal, hexadecimal, octal or binary). Nothing for other kinds and beyond 64 bits.
[[nodiscard]] std::optional<std::int64_t> integer(std::string_view text, const Value& value);

/// A boolean; nothing for other kinds.
[[nodiscard]] std::optional<bool> boolean(std::string_view text, const Value& value);

/// A date, a time of day or both, in the proleptic Gregorian calendar.
struct DateTime {
  int year = 0;
  int month = 0;  ///< From 1.
  int day = 0;    ///< From 1.
  int hour = 0;
  int minute = 0;
  int second = 0;          ///< Up to 60, in a leap second (RFC 3339): 23:59:60 in UTC.
  int nanosecond = 0;      ///< Further digits are cut off.
  int offset_minutes = 0;  ///< Of the local time before UTC: 60 for `+01:00`.
};

/// A date-time of any of the four kinds; the fields that it does not have are 0. Nothing for other kinds.
[[nodiscard]] std::optional<DateTime> date_time(std::string_view text, const Value& value);

/// What is wrong with a word; all parts are literals.
struct Complaint {
  const char* message = nullptr;  ///< Null where nothing is wrong.
  const char* expected = "";
  const char* hint = "";
};

/// What is wrong with a word that `scalar_kind` took for a number, boolean or date-time.
[[nodiscard]] Complaint complaint_about(std::string_view word, Kind kind);

}  // namespace sarsim::core::toml
