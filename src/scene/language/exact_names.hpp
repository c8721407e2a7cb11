#pragma once

#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// A scene of the language of 1998 with its references as format 2 wants them: the name of the platform or radar that
/// is meant, letter by letter, where a script may give its beginning, in any letters. Names that mean nothing, or
/// several things, stay as they are.
[[nodiscard]] Scene with_exact_names(Scene scene);

}  // namespace sarsim::scene
