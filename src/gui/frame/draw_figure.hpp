#pragma once

namespace sarsim::gui {

/// `sarsim-gui --draw-figure FIGURE --out PICTURE`: makes a picture file of a figure that the command line has handed
/// over (`figure_bytes`), without a display and without any window. Returns the exit status; failures are told on
/// standard error.
int draw_figure(int argc, char** argv);

}  // namespace sarsim::gui
