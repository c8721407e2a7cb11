#include "picture/drawing/draw_figure.hpp"
#include "picture/drawing/draw_sheet.hpp"
#include "picture/figure/load_drawing.hpp"

// The one name that the module shows.
extern "C" {
[[gnu::visibility("default")]] extern const sarsim::picture::DrawingModule sarsim_drawing_module;
}

const sarsim::picture::DrawingModule sarsim_drawing_module{&sarsim::picture::drawn_figure,
                                                           &sarsim::picture::drawn_sheet};
