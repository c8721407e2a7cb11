#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace sarsim::raster {

/// What an axis is of.
enum class AxisOf { rows, columns, image_rows };

/// A dataset with a number for each row or column, and what CF ("NetCDF Climate and Forecast Metadata Conventions")
/// calls for: the unit as udunits writes it, and a name for people.
struct AxisLabels {
  AxisOf of;
  const char* name;
  const char* units;
  const char* long_name;
};

/// All of them; of those of columns, and of those of the rows of images, a file has one at most.
inline constexpr std::array<AxisLabels, 8> axis_words{{
    {AxisOf::rows, "pulse_time_s", "s", "send time"},
    {AxisOf::rows, "carrier_hz", "Hz", "carrier frequency"},
    {AxisOf::columns, "slant_range_m", "m", "one-way slant range"},
    {AxisOf::columns, "ground_range_m", "m", "ground range"},
    {AxisOf::columns, "x_m", "m", "x in world axes"},
    {AxisOf::image_rows, "azimuth_m", "m", "place along the track"},
    {AxisOf::image_rows, "cross_range_m", "m", "cross-range"},
    {AxisOf::image_rows, "y_m", "m", "y in world axes"},
}};

/// The words of an axis; null for another name.
[[nodiscard]] constexpr const AxisLabels* words_of_axis(std::string_view name) {
  const auto* const found = std::ranges::find(axis_words, name, &AxisLabels::name);
  return found == axis_words.end() ? nullptr : found;
}

}  // namespace sarsim::raster
