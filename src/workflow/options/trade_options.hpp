#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What radar engineers and other programs call commands, options and their choices: the words of the trade for scenes
/// (scene/schema/trade_words.hpp) are another list. Stated once, in one table (trade_options.cpp).
namespace sarsim::workflow {

/// The choice of an option that a word means: of `--algorithm` and "bp", "back-projection"; empty where it means none
/// of `choices`. Hyphens, underscores and capitals do not matter.
/// @param option  with its hyphens: "--algorithm"
[[nodiscard]] std::string meant_choice(std::string_view option, const std::string& word,
                                       const std::vector<std::string>& choices);

/// What to do about a word that is no choice of an option, where the program does it in another way; empty for others.
[[nodiscard]] std::string_view other_way_than_choice(std::string_view option, std::string_view word);

/// What to do about an option, a command or an argument that nothing has: "sarsim --version prints it". Empty for
/// others.
/// @param command  in which it was met; empty: in place of one
[[nodiscard]] std::string_view other_way_than_word(std::string_view command, std::string_view word);

}  // namespace sarsim::workflow
