#include "raster/table/raster_gate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/image_gate.hpp"
#include "raster/table/pose_axes.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster {

namespace {

// Of converters of 32 bits, whose largest counts are then volts of single precision.
constexpr double largest_lsb_v = 1e29;
// The least of single precision that has all its digits is 1.2e-38.
constexpr double smallest_lsb_v = 1e-37;
constexpr double largest_rate_hz = 1e18;
// Beyond all times, places and frequencies that are computed with.
constexpr double largest_place = 1e15;

// The attributes that all of our layouts have, and what they may be. 0 says that it is not known.
struct FactBounds {
  const char* name;
  double most;
  const char* expected;
};

constexpr FactBounds fact_bounds[] = {
    {"lsb_v", largest_lsb_v, "volts of a count, up to 1e29; 0 where they are not known"},
    {"sample_rate_hz", largest_rate_hz, "a frequency, up to 1e18 Hz; 0 where it is not known"},
    {"bits", 64.0, "a whole number up to 64"},
};

class FactCheck {
 public:
  FactCheck(const Raster& raster, const RasterAxes* axes, const std::string& path)
      : raster_(raster), axes_(axes), path_(path) {}

  core::Problems run() {
    for (const FactBounds& bounds : fact_bounds) check_fact(bounds);
    check_known();
    if (axes_ != nullptr) {
      check_axis("pulse_time_s", axes_->row_time_s);
      check_axis("carrier_hz", axes_->row_carrier_hz);
      check_axis(axes_->column_axis, axes_->column_range_m);
      check_axis(axes_->row_axis, axes_->row_m);
      check_poses(axes_->row_pose);
      compare_rate(*axes_);
    }
    core::append(problems_, problems_of_image(raster_.info(), axes_, path_));
    return std::move(problems_);
  }

 private:
  void refuse(std::string message, std::string found, std::string expected) {
    problems_.push_back(file_problem(path_, std::move(message), std::move(found), std::move(expected),
                                     "correct it, or give the scene that wrote the file with --script"));
  }

  void check_fact(const FactBounds& bounds) {
    const std::string text = attribute_of(raster_.info().attributes, bounds.name);
    if (text.empty()) return;
    const auto number = core::parse_number(text);
    const bool whole = bounds.most > 64.0 || (number && std::floor(*number) == *number);
    if (number && *number >= 0.0 && *number <= bounds.most && whole) return;
    refuse(fmt::format("{} of the file cannot be", bounds.name), core::quoted_word(text), bounds.expected);
  }

  // What readers have understood, by whatever name; counts become volts in single precision.
  void check_known() {
    const RasterInfo& info = raster_.info();
    if (!core::has_errors(problems_) && info.lsb_v && !(*info.lsb_v <= largest_lsb_v))
      refuse("the LSB of the file cannot be", fmt::format("{:g} V", *info.lsb_v), "up to 1e29 V");
    if (!core::has_errors(problems_) && info.sample_rate_hz &&
        !(*info.sample_rate_hz > 0.0 && *info.sample_rate_hz <= largest_rate_hz))
      refuse("the sampling rate of the file cannot be", fmt::format("{:g} Hz", *info.sample_rate_hz),
             "above 0, up to 1e18 Hz");
    if (info.counts && info.lsb_v && *info.lsb_v > 0.0 && *info.lsb_v < smallest_lsb_v)
      refuse("the LSB of the file is too small for volts of single precision", fmt::format("{:g} V", *info.lsb_v),
             "at least 1e-37 V");
  }

  // Recordings have all of their axes. What we leave empty of an image is not a number: a part beyond its axis.
  [[nodiscard]] bool is_recording() const {
    return axes_->row_m.empty() && axes_->column_axis == "slant_range_m" &&
           attribute_of(raster_.info().attributes, "image_plane").empty();
  }

  void check_axis(const std::string& name, const std::vector<double>& values) {
    const bool whole = is_recording() || std::ranges::all_of(values, [](double value) { return std::isnan(value); });
    const auto bad = std::ranges::find_if(
        values, [&](double value) { return std::abs(value) > largest_place || (whole && std::isnan(value)); });
    if (bad == values.end()) return;
    const auto at = bad - values.begin();
    refuse(fmt::format("the axis {} has a value that cannot be", name), fmt::format("{:g} at position {}", *bad, at),
           "numbers up to 1e15");
  }

  void check_poses(const std::vector<RowPose>& poses) {
    for (const PoseAxis& axis : pose_axes) {
      std::vector<double> values;
      values.reserve(3 * poses.size());
      for (const RowPose& pose : poses)
        for (const double value : pose.*axis.part) values.push_back(value);
      check_axis(axis.name, values);
    }
  }

  // Columns of a recording are samples of the converter: c/(2 rate) apart, whichever profile's c that is.
  void compare_rate(const RasterAxes& axes) {
    const RasterInfo& info = raster_.info();
    const std::string processing = attribute_of(info.attributes, "processing");
    const bool samples = processing == "raw" || processing == "matched_filter";
    const std::size_t columns = axes.column_range_m.size();
    if (!samples || !info.sample_rate_hz || !axes.row_m.empty() || axes.column_axis != "slant_range_m" || columns < 2)
      return;
    const double spacing_m =
        (axes.column_range_m.back() - axes.column_range_m.front()) / static_cast<double>(columns - 1);
    const double expected_hz = core::exact_light_speed_mps / (2.0 * spacing_m);
    constexpr double share = 0.01;
    if (std::abs(*info.sample_rate_hz - expected_hz) <= share * std::abs(expected_hz)) return;
    problems_.push_back(
        with_severity(file_problem(path_, "sample_rate_hz of the file contradicts its slant_range_m",
                                   fmt::format("{:.9g} Hz", *info.sample_rate_hz),
                                   fmt::format("{:.9g} Hz, as its columns are {:.9g} m apart", expected_hz, spacing_m),
                                   "one of them was changed"),
                      core::Severity::warning));
  }

  const Raster& raster_;
  const RasterAxes* axes_;
  const std::string& path_;
  core::Problems problems_;
};

}  // namespace

core::Problems problems_of_facts(const Raster& raster, const RasterAxes* axes, const std::string& path) {
  return FactCheck(raster, axes, path).run();
}

}  // namespace sarsim::raster
