#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/task/parallel.hpp"
#include "scene/model/kinds.hpp"

namespace sarsim::scene {

/// Whether the script language has words for all that a scene says.
[[nodiscard]] bool fits_script(const Scene& scene);
[[nodiscard]] bool fits_script(const AnyObject& object);

/// The text of a scene that goes with its products and stands for it in checksums: a script where it can be one, as
/// readers of older editions understand it, otherwise format 2.
[[nodiscard]] std::string recorded_text(const Scene& scene, const core::WorkControl& control = {});
/// The same, piece by piece.
void recorded_text(const Scene& scene, const core::WorkControl& control,
                   const std::function<void(std::string_view)>& take);

}  // namespace sarsim::scene
