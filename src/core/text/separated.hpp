#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "core/text/letters.hpp"

namespace sarsim::core {

/// Gives the pieces of a text between separators to `take`, one after the other and without blanks at their ends: one
/// more than there are separators, empty ones too.
template <class Take>
void each_piece(std::string_view text, char separator, const Take& take) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    take(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
}

/// The same pieces at once; views of the same characters.
[[nodiscard]] inline std::vector<std::string_view> pieces_of(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  each_piece(text, separator, [&](std::string_view piece) { pieces.push_back(piece); });
  return pieces;
}

/// The numbers between commas; nothing where one of them is none (`parse_number`), as in an empty text.
[[nodiscard]] std::optional<std::vector<double>> numbers_between_commas(std::string_view text);

/// The numbers of a list, which may be empty, and behind whose last number a comma may stand.
[[nodiscard]] std::optional<std::vector<double>> numbers_of_list(std::string_view text);

}  // namespace sarsim::core
