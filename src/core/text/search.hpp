#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sarsim::core {

/// Ranks texts by how well they match what was typed: all letters in order, best at word beginnings and in a row,
/// without regard to case; an empty search keeps all in order.
/// @returns positions of the texts that match, best first; equals keep their order
[[nodiscard]] std::vector<std::size_t> ranked_matches(std::string_view typed, const std::vector<std::string>& texts);

}  // namespace sarsim::core
