#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/task/observer.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/image_places.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::workflow {

/// Which file of samples or focused image is looked at, and what is said about it.
struct PlacedImageRequest {
  std::string path;
  SampleArguments samples;                 ///< Of a file that does not describe itself.
  std::optional<std::int64_t> simulation;  ///< The one of `samples.script` that wrote the file, from 1.
};

/// An open file and where its samples are, as far as that is known.
struct PlacedImage {
  std::shared_ptr<raster::Raster> source;
  std::optional<raster::EnviHeader> header{};    ///< Of images that have one,
  std::optional<raster::FocusedPlaces> focused;  ///< and what it says of their places.
  std::optional<raster::RasterAxes> axes;  ///< Times, carriers and ranges of recordings; of the file or of its script.
  double sample_rate_hz = 0.0;             ///< Of recordings; 0 where unknown.

  /// Whether every row was sent at a known time: those of pictures that are kept as HDF5 were sent at none.
  [[nodiscard]] bool has_times() const {
    return axes && std::ranges::all_of(axes->row_time_s, [](double time) { return std::isfinite(time); });
  }
};

/// Where the rows and columns of an image with a header are.
/// @param file  the header's, for messages
[[nodiscard]] raster::FocusedPlaces places_of(const raster::EnviHeader& header, const std::string& file);

/// The places of the rows and columns of an open file, for axes: those of the header beside it, those that the file
/// itself says, or those of evenly spaced times and ranges. Nothing where nobody says any.
/// @throws core::InvalidRequest where the header beside the file is faulty; what reading the axes throws
[[nodiscard]] std::optional<raster::FocusedPlaces> drawn_places(const std::filesystem::path& path,
                                                                const raster::Raster& source);
/// The same of times and ranges alone.
[[nodiscard]] std::optional<raster::FocusedPlaces> drawn_places(const raster::RasterAxes& axes);

/// The algorithm that the header beside an image names; empty where none does.
/// @throws core::InvalidRequest where the header is faulty
[[nodiscard]] std::string algorithm_said(const std::filesystem::path& path);

/// Opens a file with the places of its samples: those of the header beside an image, otherwise those that the file
/// carries, otherwise those of its script. Waits until all its rows are known.
/// @param observer  hears warnings about the file
/// @throws core::InvalidRequest where it cannot be read whole or holds no samples, core::Interrupted when stopped
[[nodiscard]] PlacedImage open_placed_image(const PlacedImageRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
