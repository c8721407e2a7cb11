#pragma once

#include <string>

namespace sarsim::core {

/// Whether a number is that of a character which may stand in a text: not 0, no half of a pair of UTF-16, at most
/// 0x10FFFF.
[[nodiscard]] constexpr bool is_character(char32_t code) {
  return code != 0 && code <= 0x10FFFF && (code < 0xD800 || code >= 0xE000);
}

/// Appends a character of at most 0x1FFFFF to a text in UTF-8.
inline void append_utf8(std::string& text, char32_t code) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0U | (code >> 6U));
  } else {
    if (code < 0x10000) {
      add(0xE0U | (code >> 12U));
    } else {
      add(0xF0U | (code >> 18U));
      add(0x80U | ((code >> 12U) & 0x3FU));
    }
    add(0x80U | ((code >> 6U) & 0x3FU));
  }
  add(0x80U | (code & 0x3FU));
}

}  // namespace sarsim::core
