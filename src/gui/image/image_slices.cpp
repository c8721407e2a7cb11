#include "gui/image/image_slices.hpp"

#include <algorithm>
#include <cmath>

#include "picture/image/image_figure.hpp"

namespace sarsim::gui {

std::vector<ImageSlice> slices_of(const ImagePart& part, const PartColours& colours, picture::DrawAs draw_as,
                                  const ImageView& view, QSize plot_px) {
  const bool across = draw_as == picture::DrawAs::curves_per_pulse;
  std::vector<ImageSlice> slices;
  if ((!across && draw_as != picture::DrawAs::curves_per_range) || !part.colours.empty() || part.samples.empty())
    return slices;
  const raster::ImageWindow& window = part.window;
  const std::size_t step = across ? window.row_step : window.col_step;
  const double sample_px = across ? plot_px.height() / view.rows() : plot_px.width() / view.columns();
  const double every = std::max(1.0, std::ceil(picture::nearest_curves_px / (sample_px * static_cast<double>(step))));
  const double apart = every * static_cast<double>(step);
  const picture::ColourLimits& limits = colours.limits;
  const auto reach =
      picture::curve_reach(colours.quantity, limits, std::max(std::abs(limits.low), std::abs(limits.high)));
  for (std::size_t i = 0; i < (across ? window.rows : window.cols); ++i) {
    const auto base = static_cast<double>(across ? window.row(i) : window.column(i));
    if (std::fmod(std::floor(base / static_cast<double>(step)), every) != 0.0) continue;
    ImageSlice& slice = slices.emplace_back();
    slice.base = base;
    for (std::size_t k = 0; k < (across ? window.cols : window.rows); ++k) {
      const std::size_t sample = across ? i * window.cols + k : k * window.cols + i;
      const double aside =
          apart * reach(shown_value(part.value, colours.quantity, part.samples[sample], colours.reference_v));
      const auto along = static_cast<double>(across ? window.column(k) : window.row(k));
      slice.points.push_back(across ? QPointF(along, base - aside) : QPointF(base + aside, along));
    }
  }
  return slices;
}

}  // namespace sarsim::gui
