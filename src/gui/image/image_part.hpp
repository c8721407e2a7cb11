#pragma once

#include <QImage>
#include <QRectF>
#include <QSize>

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "picture/colour/colour_map.hpp"
#include "picture/colour/display_quantity.hpp"
#include "picture/echo/echo_window.hpp"
#include "raster/table/image_value.hpp"
#include "raster/table/image_window.hpp"

namespace sarsim::gui {

/// Which part of an image is seen: sample k of a row fills k - 1/2 to k + 1/2; rows count downwards.
struct ImageView {
  double column_first = -0.5;
  double column_last = 0.5;
  double row_first = -0.5;
  double row_last = 0.5;

  [[nodiscard]] double columns() const { return column_last - column_first; }
  [[nodiscard]] double rows() const { return row_last - row_first; }
  friend bool operator==(const ImageView&, const ImageView&) = default;
};

/// The view of a whole image; of an empty one a single sample.
[[nodiscard]] ImageView whole_view(std::size_t rows, std::size_t columns);
/// The view with its spans between 2 samples and four times the image, and at least its middle in the image.
[[nodiscard]] ImageView mended(const ImageView& view, std::size_t rows, std::size_t columns);
/// The view scaled about a place.
[[nodiscard]] ImageView scaled_about(const ImageView& view, double column, double row, double column_factor,
                                     double row_factor);

/// The view with more across or downwards, so that a metre is as long in both directions. As it is where it is more
/// than six times as long as wide, or no size is known.
/// @param row_step_m, column_step_m  from one row or sample to the next; signs do not matter
[[nodiscard]] ImageView with_equal_scale(const ImageView& view, double row_step_m, double column_step_m, QSize plot_px);

/// The samples to read for a view on so many device pixels: about one for each pixel, a quarter of the view more on all
/// sides to be moved into it, at multiples of the steps so that the same ones are met again. Empty where none is seen.
/// @param peak  at most one for each pixel: they stand for those between them, so all must be drawn
[[nodiscard]] raster::ImageWindow window_for(const ImageView& view, std::size_t width_px, std::size_t height_px,
                                             std::size_t rows, std::size_t columns, bool peak = false);
/// The samples that a view shows, all of them.
[[nodiscard]] raster::ImageWindow samples_in(const ImageView& view, std::size_t rows, std::size_t columns);

/// How a part of an image is looked at; decibels where nothing else is said.
struct PartLook : picture::ColourLook {
  PartLook() {
    quantity = picture::DisplayQuantity::decibels;
    map = picture::ColourMap::ocean;
  }

  picture::DrawAs draw_as = picture::DrawAs::pixels;  ///< Never automatic.
  bool peak = true;         ///< Where a pixel has many samples, the largest magnitude of them.
  bool numbers = false;     ///< Axes have the numbers of rows and samples, not their places.
  bool equal_scale = true;  ///< Of images in metres: as long across as downwards.

  /// Curves go through samples.
  [[nodiscard]] bool wants_peaks() const { return peak && draw_as == picture::DrawAs::pixels; }

  friend bool operator==(const PartLook&, const PartLook&) = default;
};

/// What suits values of a kind: decibels, or grey levels for pictures.
[[nodiscard]] PartLook look_for(raster::ImageValue value, bool picture);
/// Whether a quantity means anything for values of a kind.
[[nodiscard]] bool has_quantity(raster::ImageValue value, picture::DisplayQuantity quantity);

/// Samples that were read.
struct ImagePart {
  raster::ImageWindow window;
  raster::ImageValue value = raster::ImageValue::complex;
  std::vector<std::complex<double>> samples;  ///< Row by row; luminance of colours.
  std::vector<raster::Rgb> colours;           ///< As many, of colour pictures.
  bool peaks = false;                         ///< The samples are largest magnitudes around their places.

  /// Index of the sample nearest to a place; nothing where the place is outside.
  [[nodiscard]] std::optional<std::size_t> nearest(double column, double row) const;
};

/// The place of a part in samples: each of them as wide as their spacing.
[[nodiscard]] QRectF extent_of(const raster::ImageWindow& window);

/// What a part was painted with.
struct PartColours {
  picture::DisplayQuantity quantity = picture::DisplayQuantity::decibels;
  std::vector<raster::Rgb> table;  ///< From the lowest value to the highest; empty for colour pictures.
  picture::ColourLimits limits;
  double reference_v = 1.0;
};

/// A part with a pixel for each of its samples.
struct PaintedPart {
  QImage image;
  PartColours colours;
};

/// Paints a part. Limits come from those of its samples that `seen` holds; where it holds none, from all.
[[nodiscard]] PaintedPart paint(const ImagePart& part, const PartLook& look, const ImageView& seen);

/// The value of a quantity of a sample: decibels of powers are 10 log10.
[[nodiscard]] double shown_value(raster::ImageValue value, picture::DisplayQuantity quantity,
                                 std::complex<double> sample, double reference_v);

}  // namespace sarsim::gui
