#include "core/text/json.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::core {

namespace {

unsigned char byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

// Length of the valid UTF-8 sequence at `i`; 0 where there is none (Unicode 15, table 3-7).
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const unsigned char first = byte_at(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte_at(text, i + k) & 0xC0) != 0x80) return 0;
  const unsigned char second = byte_at(text, i + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second > 0x9F;
  const bool beyond = first == 0xF4 && second > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

// A character of two or three bytes that gives a terminal orders (C1) or turns the direction of what follows; 0 for any
// other.
unsigned order_to_terminal(std::string_view text, std::size_t i) {
  const unsigned char lead = byte_at(text, i);
  if (lead == 0xC2 && byte_at(text, i + 1) < 0xA0) return byte_at(text, i + 1);
  if (lead == 0xD8 && byte_at(text, i + 1) == 0x9C) return 0x061C;
  if (lead != 0xE2) return 0;
  const unsigned code = 0x2000U + ((byte_at(text, i + 1) & 0x3FU) << 6U) + (byte_at(text, i + 2) & 0x3FU);
  const bool orders =
      code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return orders ? code : 0;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  const std::string valid = valid_utf8(text);
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const char c = valid[i];
    if (const unsigned order = order_to_terminal(valid, i); order != 0) {
      result += fmt::format("\\u{:04x}", order);
      i += order < 0x800 ? 1 : 2;
      continue;
    }
    switch (c) {
      case '"': result += "\\\""; break;
      case '\\': result += "\\\\"; break;
      case '\n': result += "\\n"; break;
      case '\r': result += "\\r"; break;
      case '\t': result += "\\t"; break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
          result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
          result += c;
    }
  }
  return result + "\"";
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    if (length > 0) {
      result += text.substr(i, length);
      i += length;
      continue;
    }
    const unsigned char latin1 = byte_at(text, i++);
    result += static_cast<char>(0xC0 | (latin1 >> 6U));
    result += static_cast<char>(0x80 | (latin1 & 0x3FU));
  }
  return result;
}

void JsonWriter::separate() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (empty_.empty()) return;
  if (!empty_.back()) text_ += ',';
  empty_.back() = false;
  text_ += '\n';
  text_.append(2 * empty_.size(), ' ');
}

JsonWriter& JsonWriter::begin(char bracket) {
  separate();
  text_ += bracket;
  empty_.push_back(true);
  return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
  const bool was_empty = empty_.back();
  empty_.pop_back();
  if (!was_empty) {
    text_ += '\n';
    text_.append(2 * empty_.size(), ' ');
  }
  text_ += bracket;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  text_ += quoted(name) + ": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) { return literal(quoted(text)); }

JsonWriter& JsonWriter::value(double number) { return std::isfinite(number) ? literal(format_number(number)) : null(); }

JsonWriter& JsonWriter::literal(std::string_view text) {
  separate();
  text_ += text;
  return *this;
}

}  // namespace sarsim::core
