#pragma once

#include <string>

#include "core/task/stop.hpp"
#include "picture/figure/figure.hpp"
#include "picture/figure/picture_style.hpp"
#include "picture/figure/sheet.hpp"

namespace sarsim::picture {

/// What needs Cairo and Pango. It is a module of its own, `sarsim_drawing.so`, because loading these libraries takes
/// longer than many a command, and most commands draw nothing.
struct DrawingModule {
  /// See `draw_picture`.
  std::string (*draw)(const Figure& figure, PictureKind kind, const PictureStyle& style, const core::StopFlag* stop);
  /// See `draw_sheet`.
  std::string (*draw_sheet)(const Sheet& sheet, PictureKind kind, const PictureStyle& style,
                            const core::StopFlag* stop);
};

/// The module, which the first call loads and which then stays. May be called from many threads at once.
/// @throws std::runtime_error where the module, or a library that it needs, cannot be loaded
[[nodiscard]] const DrawingModule& drawing_module();

}  // namespace sarsim::picture
