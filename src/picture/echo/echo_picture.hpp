#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "picture/colour/display_quantity.hpp"
#include "picture/echo/echo_matrix.hpp"
#include "picture/echo/echo_window.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::picture {

/// A picture in device pixels, rows from the top, each pixel 0xAARRGGBB; alpha 0 where nothing is drawn.
struct EchoImage {
  std::size_t width_px = 0;
  std::size_t height_px = 0;
  std::vector<std::uint32_t> pixel;

  [[nodiscard]] std::uint32_t at(std::size_t x, std::size_t y) const { return pixel[y * width_px + x]; }
};

/// Opaque pixel of a colour.
[[nodiscard]] constexpr std::uint32_t pixel_of(raster::Rgb colour) {
  return 0xFF000000U | std::uint32_t{colour.red} << 16U | std::uint32_t{colour.green} << 8U | colour.blue;
}

/// What samples are painted with.
struct EchoColours {
  DisplayQuantity quantity = DisplayQuantity::real;
  std::vector<std::uint32_t> level;  ///< Pixels from the lowest value to the highest.
  ColourLimits limits;
  double reference_v = 1.0;  ///< Of decibels.
  SampleStatistics statistics;
};

/// Colours for the rows of a matrix that are ready.
/// @param how  quantity, map and limits; its recording may be another one than the matrix's
[[nodiscard]] EchoColours colours_for(const EchoMatrix& matrix, const EchoWindow& how);
/// Number of the colour of a sample: `colour_index` of its value; the phase to 3e-8 rad.
[[nodiscard]] std::size_t level_of(const EchoColours& colours, std::complex<double> sample);

/// Paints the matrix at its size: every pixel the sample nearest to it, of the nearest row that is ready; no value is
/// made up between samples. With RowPlacing::own_row every pulse fills the one row of pixels nearest to its time.
/// @param threads    0: one for each core
/// @param[out] image replaced, its room used again; all empty where no row is ready
void paint(const EchoMatrix& matrix, const EchoColours& colours, RowPlacing placing, unsigned threads,
           EchoImage& image);

/// Whether a window with this matrix shows curves: as asked, or, by itself, where pulses are at least 20 pixels apart.
[[nodiscard]] DrawAs drawn_as(const EchoWindow& how, const EchoMatrix& matrix);

/// The strip beside the plot, from the highest value at the top to the lowest.
struct ColourBar {
  std::vector<std::uint32_t> pixel;  ///< One for each of the strip's rows.
  Ticks ticks;
};
[[nodiscard]] ColourBar colour_bar(const EchoColours& colours, std::size_t height_px, double tick_spacing_px);

/// An axis of the plot with the places of its marks.
struct PlotAxis {
  /// A mark of the axis with its words.
  struct Mark {
    double px;
    std::string label;
  };
  std::string title;  ///< "Slant range [km]"
  std::vector<Mark> marks;
};
struct PlotAxes {
  PlotAxis range;
  PlotAxis delay;  ///< The same axis as two-way delay.
  PlotAxis time;
};
/// @param spacing_px  between marks, at least
[[nodiscard]] PlotAxes plot_axes(const EchoView& view, const PlotSize& size, double light_speed_mps, double spacing_px);

/// "Highest magnitude: 40.9856 uV", or that it is unknown where no row is ready.
[[nodiscard]] std::string highest_magnitude_text(const SampleStatistics& statistics);

}  // namespace sarsim::picture
