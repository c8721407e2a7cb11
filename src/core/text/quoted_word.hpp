#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/text/letters.hpp"

namespace sarsim::core {

/// Quotation from a file for a message: the first word, at most 60 bytes of it, with "..." if more follows. All readers
/// of files quote through it, so that no message discloses lines of a file that was not meant to be read. UTF-8 is cut
/// between characters.
[[nodiscard]] inline std::string quoted_word(std::string_view text) {
  constexpr std::size_t longest = 60;
  text = trimmed(text);
  const auto ends_word = [](char c) { return is_blank(c) || c == '\0' || c == '\v' || c == '\f'; };
  std::size_t end = static_cast<std::size_t>(std::ranges::find_if(text, ends_word) - text.begin());
  if (end > longest) {
    end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80) --end;
  }
  return std::string(text.substr(0, end)) + (end < text.size() ? "..." : "");
}

}  // namespace sarsim::core
