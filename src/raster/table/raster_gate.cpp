#include "raster/table/raster_gate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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

// Opening a file takes neither memory nor time that grows with it; longer axes are judged where they are used.
constexpr std::size_t max_looked_at = std::size_t{1} << 20U;

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
  FactCheck(const Raster& raster, const std::string& path) : raster_(raster), path_(path) {}

  core::Problems run() {
    for (const FactBounds& bounds : fact_bounds) check_fact(bounds);
    check_known();
    const bool looked_at = raster_.rows() <= max_looked_at && raster_.columns() <= max_looked_at;
    const auto axes = looked_at ? raster_.axes() : std::nullopt;
    if (axes) {
      check_axis("pulse_time_s", axes->row_time_s);
      check_axis("carrier_hz", axes->row_carrier_hz);
      check_axis(axes->column_axis, axes->column_range_m);
      check_axis(axes->row_axis, axes->row_m);
      check_poses(axes->row_pose);
      compare_rate(*axes);
    }
    std::ranges::move(problems_of_image(raster_.info(), axes ? &*axes : nullptr, path_), std::back_inserter(problems_));
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

  // What is left empty by us is not a number: a part of an image that lies beyond its axis.
  void check_axis(const std::string& name, const std::vector<double>& values) {
    const auto bad =
        std::ranges::find_if(values, [](double value) { return std::abs(value) > largest_place; });  // False for NaN.
    const bool none = !values.empty() && std::ranges::all_of(values, [](double value) { return std::isnan(value); });
    if (bad == values.end() && !none) return;
    const auto at = none ? std::ptrdiff_t{0} : bad - values.begin();
    refuse(fmt::format("the axis {} has a value that cannot be", name),
           fmt::format("{:g} at position {}", values[static_cast<std::size_t>(at)], at), "numbers up to 1e15");
  }

  void check_poses(const std::vector<simulate::RowPose>& poses) {
    for (const PoseAxis& axis : pose_axes) {
      std::vector<double> values;
      values.reserve(3 * poses.size());
      for (const simulate::RowPose& pose : poses)
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
  const std::string& path_;
  core::Problems problems_;
};

}  // namespace

core::Problems problems_of_facts(const Raster& raster, const std::string& path) {
  return FactCheck(raster, path).run();
}

}  // namespace sarsim::raster
