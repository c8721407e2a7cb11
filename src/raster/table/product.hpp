#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/model/recording.hpp"
#include "scene/model/run_options.hpp"

namespace sarsim::raster {

/// Where the radar's platform is and how it moves when the (first) pulse of a row leaves, motion errors included.
struct RowPose {
  std::array<double, 3> position_m{};    ///< World axes.
  std::array<double, 3> velocity_mps{};  ///< World axes.
  std::array<double, 3> rotation_rad{};  ///< About x, y and z, as radar::world_from_platform takes them.
};

/// A number or a text that a file says of itself.
using FactValue = std::variant<double, std::string>;
/// Such values with their names.
using Facts = std::vector<std::pair<std::string, FactValue>>;

/// What only images have. The names are those of docs/formats/focused-images.md.
struct ImageAxes {
  std::string rows = {};                          ///< Name of the axis of rows: azimuth_m, cross_range_m or y_m.
  std::function<double(std::size_t)> row_m = {};  ///< Where a row is, m; empty where rows are known by their times.
  std::string columns = "slant_range_m";          ///< Name of the axis of columns; or ground_range_m, x_m.
  Facts facts = {};                               ///< What else the file says of itself.
  Facts map = {};                                 ///< How it lies on a map (CF grid mapping); empty where it does not.
};

/// What a recording is: its shape, its axes and where its numbers come from. Everything a file can carry.
struct Product {
  std::string radar;
  scene::Processing processing = scene::Processing::raw;
  std::size_t rows = 0;                               ///< Pulses; bursts for synthetic range profiles.
  std::size_t columns = 0;                            ///< Complex samples of a row.
  std::function<double(std::size_t)> row_time_s;      ///< Send time of a row's (first) pulse.
  std::function<double(std::size_t)> row_carrier_hz;  ///< Its carrier.
  std::function<RowPose(std::size_t)> row_pose;       ///< The radar's platform then.
  std::function<double(std::size_t)> column_range_m;  ///< One-way slant range of a column; of images what `image` says.
  double sample_rate_hz = 0.0;
  int bits = 8;
  double lsb_v = 0.0;  ///< 0 where it is only known at the end.
  scene::RunOptions options;
  std::string engine = "reference";
  std::string script;  ///< Text of the scene as understood.
  /// Attributes of docs/formats/samples.md that nobody knows: what stands here for them says nothing, and files leave
  /// them out, as they do axes that are empty functions.
  std::vector<std::string> unknown = {};
  ImageAxes image = {};  ///< Of images.
};

}  // namespace sarsim::raster
