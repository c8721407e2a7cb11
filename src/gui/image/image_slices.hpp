#pragma once

#include <QPointF>
#include <QSize>

#include <vector>

#include "gui/image/image_part.hpp"

namespace sarsim::gui {

/// A curve through the samples of a row or a column, in places of samples: x counts columns, y rows.
struct ImageSlice {
  double base = 0.0;  ///< Row or column that stands for 0; for the lower limit, of decibels.
  std::vector<QPointF> points;
};

/// Curves instead of pixels (thesis 4.7, figure 4.14): one for each row, drawn upwards from it, or for each column,
/// drawn to the right; where they would be nearer than 20 pixels, for every n-th, counted from the first of the image,
/// so that a view that moves keeps them. The largest value is drawn as 3/8 of their distance, so that positive and
/// negative together take three quarters of it; decibels take 90 % from the lower limit to the upper, degrees 3/8 for
/// 180.
/// @param colours  that the part was painted with: what is drawn, and its limits
/// @param plot_px  of the view, for the distances
/// @return none for pixels and for colour pictures
[[nodiscard]] std::vector<ImageSlice> slices_of(const ImagePart& part, const PartColours& colours,
                                                picture::DrawAs draw_as, const ImageView& view, QSize plot_px);

}  // namespace sarsim::gui
