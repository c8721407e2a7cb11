#pragma once

#include <QImage>

#include <cstddef>
#include <optional>

#include "gui/image/image_plot.hpp"
#include "gui/image/image_words.hpp"
#include "picture/figure/figure.hpp"
#include "picture/image/overview.hpp"

namespace sarsim::gui {

/// Graphs along samples and rows.
struct ImageCuts {
  picture::Figure row;
  picture::Figure column;
};
/// Those through the first cursor, or the middle of the view; nothing where nothing was read there.
[[nodiscard]] std::optional<ImageCuts> cuts_of(const ImagePlot& plot, const ImageWords& words);

/// How often the values of what is drawn are there.
[[nodiscard]] picture::Figure histogram_of(const picture::SelectionStatistics& statistics, const ImageWords& words);

/// What is seen, with axes and without a title; empty where nothing is.
[[nodiscard]] picture::Figure figure_of(const ImagePlot& plot, const ImageWords& words);

/// A picture of a whole image.
struct CoarsePicture {
  QImage image;
  bool as_wanted = true;  ///< It shows the quantity that is wanted, and not the nearest that an overview has.
};
/// As coarse as a thumbnail needs it, in the colours that are chosen.
/// @param rows  of which the overview is made
[[nodiscard]] CoarsePicture coarse_picture(const picture::Overview& overview, const raster::Raster& source,
                                           std::size_t rows, const PartLook& wanted);

}  // namespace sarsim::gui
