#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sarsim::core {

/// `text` as valid UTF-8: bytes that are not part of a valid sequence are taken as Latin-1, the coding of old scripts.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// Writes JSON (RFC 8259) member by member, indented by two blanks. Numbers are exact (shortest form that reads back);
/// what JSON cannot hold (NaN, infinity) becomes null. Strings become valid UTF-8, see `valid_utf8`.
class JsonWriter {
 public:
  JsonWriter& begin_object() { return begin('{'); }
  JsonWriter& end_object() { return end('}'); }
  JsonWriter& begin_array() { return begin('['); }
  JsonWriter& end_array() { return end(']'); }
  /// Name of the value that follows, inside an object.
  JsonWriter& key(std::string_view name);

  /// The next value: of an array, or behind `key` of an object.
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  /// The next value, as above.
  JsonWriter& value(double number);
  JsonWriter& value(bool truth) { return literal(truth ? "true" : "false"); }
  template <std::integral Integer>
  JsonWriter& value(Integer number) {
    return literal(std::to_string(number));
  }
  JsonWriter& null() { return literal("null"); }

  /// A member of an object.
  template <class Value>
  JsonWriter& member(std::string_view name, const Value& v) {
    return key(name).value(v);
  }

  /// The whole text, with a line feed at its end.
  [[nodiscard]] std::string text() const { return text_ + "\n"; }

 private:
  JsonWriter& begin(char bracket);
  JsonWriter& end(char bracket);
  JsonWriter& literal(std::string_view text);
  void separate();

  std::string text_;
  std::vector<bool> empty_;  // of each open object or array
  bool after_key_ = false;
};

}  // namespace sarsim::core
