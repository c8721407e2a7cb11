#include "raster/table/image_gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "core/text/separated.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster {

namespace {

// Three numbers, separated by commas.
std::optional<std::array<double, 3>> vector_in(std::string_view text) {
  const auto numbers = core::numbers_between_commas(text);
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!numbers || numbers->size() != 3 || !std::ranges::all_of(*numbers, is_finite)) return std::nullopt;
  return std::array<double, 3>{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

class ImageCheck {
 public:
  ImageCheck(const RasterInfo& info, const std::string& path) : info_(info), path_(path) {}

  core::Problems run(const RasterAxes* axes) {
    const std::string plane = text_of("image_plane");
    if (plane.empty()) return {};
    if (plane != "slant range" && plane != "ground grid")
      refuse("image_plane", plane, "'slant range' or 'ground grid'");
    for (const char* const name : {"azimuth_step_m", "range_step_m", "carrier_hz", "speed_mps"})
      if (const auto number = number_of(name); !number || !(*number > 0.0))
        refuse(name, text_of(name), "a number above 0");
    if (const auto number = number_of("light_speed_mps"); !number || !is_light_speed(*number))
      refuse("light_speed_mps", text_of("light_speed_mps"), light_speeds);
    for (const char* const name : {"azimuth_first_m", "range_first_m"})
      if (!number_of(name)) refuse(name, text_of(name), "a finite number");
    if (!vector_in(text_of("origin_m"))) refuse("origin_m", text_of("origin_m"), "three numbers, x, y, z");
    constexpr double roundings = 1e-6;
    const auto along = vector_in(text_of("along"));
    if (!along || !(std::abs(std::hypot((*along)[0], (*along)[1], (*along)[2]) - 1.0) < roundings))
      refuse("along", text_of("along"), "a vector of length 1");
    if (axes != nullptr && problems_.empty()) {
      compare("azimuth", axes->row_axis, axes->row_m);
      compare("range", axes->column_axis, axes->column_range_m);
    }
    return std::move(problems_);
  }

 private:
  [[nodiscard]] std::string text_of(const std::string& name) const { return attribute_of(info_.attributes, name); }
  [[nodiscard]] std::optional<double> number_of(const std::string& name) const {
    const auto number = core::parse_number(text_of(name));
    return number && std::isfinite(*number) ? number : std::nullopt;
  }

  void refuse(const std::string& name, const std::string& found, std::string expected) {
    problems_.push_back(file_problem(path_, fmt::format("{} of the image cannot be", name),
                                     fmt::format("{:.60}", found), std::move(expected),
                                     "correct it, or focus the recording again"));
  }

  // Places are said twice: one by one, and by the first of them and the step.
  void compare(const std::string& key, const std::string& axis, const std::vector<double>& places) {
    const double first = *number_of(key + "_first_m");
    const double step = *number_of(key + "_step_m");
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double expected = first + step * static_cast<double>(i);
      if (std::abs(places[i] - expected) <= 1e-3 * step + 1e-9 * std::abs(expected)) continue;
      core::Problem problem = file_problem(
          path_, fmt::format("the axis {0} contradicts {1}_first_m and {1}_step_m, which count", axis, key),
          fmt::format("{:.9g} m at position {}", places[i], i), fmt::format("{:.9g} m", expected),
          "one of them was changed: focus the recording again");
      return problems_.push_back(with_severity(std::move(problem), core::Severity::warning));
    }
  }

  const RasterInfo& info_;
  const std::string& path_;
  core::Problems problems_;
};

}  // namespace

bool is_light_speed(double speed_mps) {
  constexpr double share = 1e-8;
  return std::abs(speed_mps - core::exact_light_speed_mps) < share * core::exact_light_speed_mps ||
         std::abs(speed_mps - core::classic_light_speed_mps) < share * core::classic_light_speed_mps;
}

core::Problems problems_of_image(const RasterInfo& info, const RasterAxes* axes, const std::string& path) {
  return ImageCheck(info, path).run(axes);
}

}  // namespace sarsim::raster
