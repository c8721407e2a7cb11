#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/text/letters.hpp"

namespace sarsim::core {

/// A word as a shell and `workflow::words_of_line` read it back: as it stands, or in quotation marks.
[[nodiscard]] inline std::string shell_word(std::string_view text) {
  const auto plain = [](char c) {
    return is_digit(c) || is_letter(c) || std::string_view("_./:=,+-%@").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return std::string(text);
  std::string word = "'";
  for (const char c : text)
    if (c == '\'')
      word += "'\"'\"'";
    else
      word += c;
  return word + "'";
}

}  // namespace sarsim::core
