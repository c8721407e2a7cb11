#pragma once

#include <string>

#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

/// The options that say the same as overrides, in a line: "--seed 3 --set Radar1.bandwidth=10MHz"; empty for none. The
/// format of files is left out.
[[nodiscard]] std::string words_of_overrides(const SceneOverrides& overrides);

/// Reads such a line. Throws core::InvalidRequest where it says something else.
[[nodiscard]] SceneOverrides overrides_from_words(const std::string& line);

}  // namespace sarsim::workflow
