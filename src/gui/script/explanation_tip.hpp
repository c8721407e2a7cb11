#pragma once

#include <QString>

#include "scene/language/explanation.hpp"

namespace sarsim::gui {

/// An explanation as a tooltip: what `sarsim explain` says of a word, in rich text. Long lists are names alone.
[[nodiscard]] QString explanation_tip(const scene::language::Explanation& explanation);

}  // namespace sarsim::gui
