#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/task/stop.hpp"
#include "picture/echo/echo_matrix.hpp"
#include "picture/echo/radar_views.hpp"
#include "picture/image/cut_figure.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/image_places.hpp"

namespace sarsim::picture {

/// Samples that cuts and radar views can be made of, wherever they come from.
struct SampleSource {
  std::vector<double> row_place;     ///< Time of each row; azimuth or number, where `look.rows` says so.
  std::vector<double> column_place;  ///< Range of each column, or its number.
  CutLook look;                      ///< Names of the places and unit of the samples.
  bool timed = true;                 ///< Rows have times, columns ranges, and the carriers are known.
  std::function<EchoBlock(simulate::IndexSpan rows, simulate::IndexSpan columns)> read;
};

/// The samples of a recording as a run saves them, computed when they are asked for.
/// @param stop  asked meanwhile
[[nodiscard]] SampleSource samples_of(std::shared_ptr<const simulate::Plan> plan, const core::StopFlag* stop);

/// All samples of a matrix that is computed, with their times and ranges.
[[nodiscard]] EchoBlock echo_block(const EchoMatrix& matrix);

/// Says the unit of the samples in a radar view, whose words are those of volts.
void say_unit(Figure& figure, const std::string& unit);

/// A part of a file, and its samples.
struct ImageSamples {
  std::shared_ptr<const raster::Raster> source;
  std::optional<raster::FocusedPlaces> focused;  ///< Of images that can be cut finer.
  std::vector<double> row_carrier_hz;            ///< Of all rows of the file; empty where unknown.
  double sample_rate_hz = 0.0;                   ///< 0 where unknown.
  simulate::IndexSpan rows;                      ///< Of the file.
  simulate::IndexSpan columns;                   ///< Of the file.
  double scale = 1.0;                            ///< Volts of a number of the file; 1 where that is unknown.
  SampleSource samples;
};

/// Cuts the places of all rows and columns of the file to those of the part and lets its samples be read: in volts,
/// or in counts where no LSB is known. The samples keep the file open; reading one that cannot be computed with
/// (`raster::is_usable_sample`) throws core::InvalidRequest.
/// @param stop  asked while blocks are read
void begin_reading(ImageSamples& part, const core::StopFlag* stop);

/// An image has a sample or two for each width of a point: a cut shows so many for each of them.
inline constexpr std::size_t upsampled_by = 16;

/// Gives a cut through a focused complex image what lies between its samples: places `upsampled_by` times as close
/// along it, inside the part, and their values, which follow from the image's spectrum.
/// @param along_range  along rows; otherwise along columns
void make_finer(ImageSamples& part, bool along_range, const core::StopFlag* stop);

}  // namespace sarsim::picture
