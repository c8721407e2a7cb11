#pragma once

#include <vector>

#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

/// Keeps words from lying on each other: names go up or down by lines to where there is room, and distances and degrees
/// are left out where there is none, or where the edge of the picture would cut them. Names that find no room stay
/// where they are. How long words are is estimated.
/// More than 500 words stay as they are.
void place_labels(std::vector<Drawing::Text>& texts, const Camera& camera, double pixel_scale);

}  // namespace sarsim::picture
