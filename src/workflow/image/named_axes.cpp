#include "workflow/image/named_axes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/counted.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

constexpr double unknown_place = std::numeric_limits<double>::quiet_NaN();

// What a pose says of a row, by the names of its parts.
struct PosePart {
  std::string_view name;
  std::string_view unit;
  std::array<double, 3> raster::RowPose::*values;
};
constexpr std::array pose_parts{PosePart{"position", "m", &raster::RowPose::position_m},
                                PosePart{"velocity", "mps", &raster::RowPose::velocity_mps},
                                PosePart{"rotation", "rad", &raster::RowPose::rotation_rad}};
constexpr std::array<std::string_view, 3> row_places{"azimuth_m", "cross_range_m", "y_m"};
constexpr std::array<std::string_view, 3> column_places{"slant_range_m", "ground_range_m", "x_m"};

std::string unit_of(std::string_view name) { return std::string(name.substr(name.rfind('_') + 1)); }

std::string axis_of_pose(const PosePart& part, std::size_t component) {
  return fmt::format("{}_{}_{}", part.name, "xyz"[component], part.unit);
}

// "Slant range" in m: "slant_range_m".
std::string snake_name(const raster::ImagePlaces& places) {
  std::string name;
  for (const char c : places.label + " " + places.unit)
    name += c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

void add_axis(std::vector<NamedAxis>& axes, std::string name, bool of_columns, std::vector<double> values) {
  if (values.empty() || std::ranges::all_of(values, [](double value) { return std::isnan(value); })) return;
  std::string unit = unit_of(name);
  axes.push_back({std::move(name), std::move(unit), of_columns, std::move(values)});
}

std::string list_of_axes() {
  std::string names = "pulse_time_s, carrier_hz";
  for (const std::string_view name : row_places) names += fmt::format(", {}", name);
  for (const std::string_view name : column_places) names += fmt::format(", {}", name);
  return names + ", position_x_m, velocity_x_mps, rotation_x_rad and the like";
}

// Gives the poses of rows one of their components. Returns whether the name is one.
bool take_pose(const NamedAxis& axis, std::vector<raster::RowPose>& poses) {
  for (const PosePart& part : pose_parts)
    for (std::size_t k = 0; k < 3; ++k) {
      if (axis.name != axis_of_pose(part, k)) continue;
      constexpr std::array nowhere{unknown_place, unknown_place, unknown_place};
      poses.resize(axis.values.size(), {nowhere, nowhere, nowhere});
      for (std::size_t row = 0; row < axis.values.size(); ++row) (poses[row].*part.values)[k] = axis.values[row];
      return true;
    }
  return false;
}

void take_axis(const NamedAxis& axis, raster::RasterAxes& axes) {
  if (axis.name == "pulse_time_s") {
    axes.row_time_s = axis.values;
  } else if (axis.name == "carrier_hz") {
    axes.row_carrier_hz = axis.values;
  } else if (std::ranges::find(row_places, axis.name) != row_places.end()) {
    axes.row_m = axis.values;
    axes.row_axis = axis.name;
  } else if (std::ranges::find(column_places, axis.name) != column_places.end()) {
    axes.column_range_m = axis.values;
    axes.column_axis = axis.name;
  } else if (!take_pose(axis, axes.row_pose)) {
    throw core::InvalidRequest(fmt::format("'{}' is not the name of an axis", axis.name), "axes are " + list_of_axes());
  }
}

void expect_count(const NamedAxis& axis, std::size_t rows, std::size_t columns) {
  const bool of_columns = std::ranges::find(column_places, axis.name) != column_places.end();
  const std::size_t expected = of_columns ? columns : rows;
  if (axis.values.size() != expected)
    throw core::InvalidRequest(
        fmt::format("the axis {} has {}, but there are {}", axis.name, core::counted(axis.values.size(), "value"),
                    core::counted(expected, of_columns ? "column" : "row")),
        fmt::format("give a value for each {}", of_columns ? "column" : "row"));
}

}  // namespace

std::vector<NamedAxis> named_axes(const raster::FocusedPlaces& places, std::size_t rows, std::size_t columns) {
  std::vector<NamedAxis> axes;
  if (!places.azimuth.unit.empty())
    axes.push_back({snake_name(places.azimuth), places.azimuth.unit, false, places.azimuth.list(rows)});
  if (!places.range.unit.empty())
    axes.push_back({snake_name(places.range), places.range.unit, true, places.range.list(columns)});
  return axes;
}

std::vector<NamedAxis> named_axes(const raster::RasterAxes& axes) {
  std::vector<NamedAxis> named;
  add_axis(named, "pulse_time_s", false, axes.row_time_s);
  add_axis(named, "carrier_hz", false, axes.row_carrier_hz);
  if (!axes.row_axis.empty()) add_axis(named, axes.row_axis, false, axes.row_m);
  add_axis(named, axes.column_axis, true, axes.column_range_m);
  if (axes.row_pose.empty()) return named;
  for (const PosePart& part : pose_parts)
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> values;
      for (const raster::RowPose& pose : axes.row_pose) values.push_back((pose.*part.values)[k]);
      add_axis(named, axis_of_pose(part, k), false, std::move(values));
    }
  return named;
}

raster::RasterAxes axes_of(const std::vector<NamedAxis>& named, std::size_t rows, std::size_t columns) {
  raster::RasterAxes axes;
  for (const NamedAxis& axis : named) {
    take_axis(axis, axes);
    expect_count(axis, rows, columns);
  }
  if (axes.row_time_s.empty()) axes.row_time_s.assign(rows, unknown_place);
  if (axes.row_carrier_hz.empty()) axes.row_carrier_hz.assign(rows, unknown_place);
  if (axes.column_range_m.empty()) axes.column_range_m.assign(columns, unknown_place);
  return axes;
}

}  // namespace sarsim::workflow
