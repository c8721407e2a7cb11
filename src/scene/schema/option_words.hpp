#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The choices among the run options as files carry them: a field's id with the word of the script language in small
/// letters, {"cubic_ends", "not_a_knot"}. In the order of the form.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> option_words(const RunOptions& options);

/// Makes a choice from such a word.
/// @returns false where no choice has this id or this word; the options are then unchanged
[[nodiscard]] bool take_option_word(RunOptions& options, std::string_view id, std::string_view word);

}  // namespace sarsim::scene
