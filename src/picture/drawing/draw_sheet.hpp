#pragma once

#include <string>

#include "picture/figure/picture_file.hpp"

namespace sarsim::picture {

/// See `draw_sheet` of picture_file.hpp.
[[nodiscard]] std::string drawn_sheet(const Sheet& sheet, PictureKind kind, const PictureStyle& style,
                                      const core::StopFlag* stop);

}  // namespace sarsim::picture
