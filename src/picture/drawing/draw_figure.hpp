#pragma once

#include <string>

#include "picture/figure/picture_file.hpp"

namespace sarsim::picture {

/// See `draw_picture`: title, panels one below the other, note; axes below each other begin and end at the same place.
[[nodiscard]] std::string drawn_figure(const Figure& figure, PictureKind kind, const PictureStyle& style,
                                       const core::StopFlag* stop);

}  // namespace sarsim::picture
