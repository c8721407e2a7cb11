#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/text/letters.hpp"

namespace sarsim::core {

/// Whether a cell of a table is what programs write for a number that is missing or not finite: "NA", "nan", "-inf",
/// "null", in any case. Such a cell stands for a number and is no name.
[[nodiscard]] inline bool is_missing_word(std::string_view cell) {
  constexpr std::array<std::string_view, 7> words{"na", "n/a", "#n/a", "nan", "null", "inf", "infinity"};
  cell = trimmed(cell);
  if (cell.starts_with('+') || cell.starts_with('-')) cell.remove_prefix(1);
  return std::ranges::find(words, lower_case(cell)) != words.end();
}

}  // namespace sarsim::core
