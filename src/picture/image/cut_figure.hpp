#pragma once

#include <cstddef>
#include <string>

#include "picture/colour/display_quantity.hpp"
#include "picture/echo/radar_views.hpp"
#include "picture/figure/figure.hpp"

/// Cuts through samples that are there: one row against its columns, one column against its rows.
namespace sarsim::picture {

/// What the rows or columns of samples stand for.
struct CutPlaces {
  std::string label;  ///< "Slant range".
  std::string unit;   ///< "m"; empty for plain numbers.
};

/// The choices of a cut.
struct CutLook {
  DisplayQuantity quantity = DisplayQuantity::magnitude;
  double span_db = 60.0;   ///< Of decibels, below the largest value of the cut.
  std::size_t peaks = 0;   ///< So many of the highest maxima are marked.
  std::string unit = "V";  ///< Of the samples.
  CutPlaces rows{"Azimuth time", "s"};
  CutPlaces columns{"Slant range", "m"};
};

/// One row against its columns; delay as the twin of slant range.
/// @param row  of the block
[[nodiscard]] Figure row_figure(const EchoBlock& block, std::size_t row, const CutLook& look);
/// One column against its rows.
[[nodiscard]] Figure column_figure(const EchoBlock& block, std::size_t column, const CutLook& look);

/// All samples of a block as text for a spreadsheet: a header line, then for each sample the place of its row (where
/// `rows`), that of its column (where `columns`), I, Q, magnitude and phase.
[[nodiscard]] std::string sample_table(const EchoBlock& block, const CutLook& look, bool rows, bool columns,
                                       char separator);

}  // namespace sarsim::picture
