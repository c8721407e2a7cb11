#pragma once

#include "picture/drawing/panel_layout.hpp"

namespace sarsim::picture {

/// Draws a panel in its place: image, grid, curves, marks, axes, legend, colour bar.
void draw_panel(const Canvas& canvas, const FigurePanel& panel, const PlacedPanel& placed);

}  // namespace sarsim::picture
