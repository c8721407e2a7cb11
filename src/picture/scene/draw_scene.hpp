#pragma once

#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

/// Draws a snapshot, whose objects are in the order of their lists, after the rules of the thesis (4.1.2): main axes
/// 200 px long with a mark at a round distance, corner triad, platforms with own axes of 50 px and name, targets as
/// discs of 7 px with drop lines and, where directional, the normal of 20 px, surfaces with their normal, radars as
/// discs of 10 px with the cone of their beam (50 px, 16 points, 4 ribs) or a dotted circle where isotropic. Beyond
/// them: a scale bar with the main axes, the names of radars, trails, and of selected platforms the points that make
/// the path, squares of 7 px, on the whole of it; solid symbols of moving platforms, the globe with meridians and
/// parallels where an Earth is seen from so far that it is round. The globe and filled surfaces hide marks behind them.
/// What is selected or hovered has its own role and is larger. Marks end at most 64 pixels of the screen outside the
/// picture. Drop lines of platforms and surfaces end at the world's z = 0. Fills `drawing`, whose room is used again.
/// About 1 ms for 10 000 targets.
void draw_scene(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options, Drawing& drawing);

}  // namespace sarsim::picture
