#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/task/stop.hpp"
#include "picture/echo/echo_window.hpp"
#include "picture/figure/figure.hpp"
#include "raster/table/image_places.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::picture {

/// How a file is looked at: the part that is seen, in rows and columns of the file, and the look.
struct ImageLook : ColourLook {
  ImageLook() {
    quantity = DisplayQuantity::magnitude;
    map = ColourMap::ocean;
  }

  std::size_t first_row = 0;
  std::size_t rows = 0;  ///< 0: all.
  std::size_t first_column = 0;
  std::size_t columns = 0;  ///< 0: all.
  /// Pixels, or curves (echo_curves.hpp): one for each row or column, of those that are nearer than 20 pixels every
  /// n-th.
  DrawAs draw_as = DrawAs::pixels;
  PixelRule pixel_rule = PixelRule::sample;  ///< Of pixels: one of its samples, or the largest, which reads them all.
  std::optional<raster::ImagePlaces> row_places;  ///< Instead of the file's own.
  std::optional<raster::ImagePlaces> column_places;
  std::optional<std::string> unit;  ///< Of the values; otherwise V, or none where the file holds counts or levels.
};

/// Curves through samples are no nearer than this, pixels.
inline constexpr double nearest_curves_px = 20.0;

/// How far a curve through samples reaches from its base for a value of a quantity, as a share of the distance to the
/// next curve: positive and negative together take three quarters of it, degrees as much from -180 to 180, decibels
/// nine tenths from their lower limit to the upper.
/// @param largest  magnitude of the values, in their unit; for phases and decibels of no account
[[nodiscard]] std::function<double(double)> curve_reach(DisplayQuantity quantity, const ColourLimits& limits,
                                                        double largest);

/// A picture of a file of any size: where it has more samples than pixels, a subset of them or the largest of each
/// pixel. Axes are pulses and samples, or, where the file or the look says them, slant range and time; the larger place
/// is above, also where the step of the rows is negative.
/// @param size     device pixels at most
/// @param remarks  where warnings go: of samples that are not finite
/// @throws std::invalid_argument for a part that is not inside the file, and what reading throws
[[nodiscard]] Figure image_figure(const raster::Raster& source, const ImageLook& look, const PlotSize& size,
                                  const core::WorkControl& control = {}, core::Problems* remarks = nullptr);

}  // namespace sarsim::picture
