#include "workflow/image/image_fields.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/image_gate.hpp"
#include "workflow/image/map_fields.hpp"
#include "workflow/input/earth_place.hpp"

namespace sarsim::workflow {

namespace {

std::string vector_text(const core::Vec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

void add_axis(std::vector<std::pair<std::string, std::string>>& fields, const std::string& name,
              const signal::ImageAxis& axis) {
  fields.emplace_back(name + " first m", fmt::format("{}", axis.first_m));
  fields.emplace_back(name + " step m", fmt::format("{}", axis.step_m));
  fields.emplace_back(name + " spectrum centre per m", fmt::format("{}", axis.spectrum_centre_per_m));
}

// Takes fields of a header, each of which must be there.
class FieldTaker {
 public:
  FieldTaker(const raster::EnviHeader& header, const std::string& file) : header_(header), file_(file) {}

  [[nodiscard]] std::string text(const std::string& name) const {
    const auto value = header_.field(name);
    if (!value) refuse(name, "is missing");
    return *value;
  }
  [[nodiscard]] std::string word(const std::string& name, std::initializer_list<std::string_view> allowed) const {
    const std::string value = text(name);
    if (std::ranges::find(allowed, value) == allowed.end()) refuse(name, "is not known");
    return value;
  }
  [[nodiscard]] double number(const std::string& name) const { return parsed(name, text(name)); }
  // A number from 1, as the position from 0.
  [[nodiscard]] std::size_t position(const std::string& name) const {
    const auto value = core::parse_integer(text(name));
    if (!value || *value < 1) refuse(name, "is not a number from 1");
    return static_cast<std::size_t>(*value) - 1;
  }
  [[nodiscard]] core::Vec3 vector(const std::string& name) const {
    const std::string value = text(name);
    const std::size_t first = value.find(',');
    const std::size_t second = first == std::string::npos ? first : value.find(',', first + 1);
    if (second == std::string::npos) refuse(name, "is not a vector");
    return {parsed(name, value.substr(0, first)), parsed(name, value.substr(first + 1, second - first - 1)),
            parsed(name, value.substr(second + 1))};
  }
  [[nodiscard]] double above_zero(const std::string& name) const {
    const double value = number(name);
    if (!(value > 0.0)) refuse(name, "is not above 0");
    return value;
  }
  [[nodiscard]] double light_speed(const std::string& name) const {
    const double value = number(name);
    if (!raster::is_light_speed(value))
      refuse(name, fmt::format("is no speed of light ({})", raster::light_speeds).c_str());
    return value;
  }
  // A vector of length 1.
  [[nodiscard]] core::Vec3 direction(const std::string& name) const {
    const core::Vec3 value = vector(name);
    if (!(std::abs(core::norm(value) - 1.0) < 1e-6)) refuse(name, "is not a vector of length 1");
    return value;
  }
  [[nodiscard]] signal::ImageAxis axis(const std::string& name, std::size_t count) const {
    const signal::ImageAxis axis{number(name + " first m"), number(name + " step m"), count,
                                 number(name + " spectrum centre per m")};
    if (!(axis.step_m > 0.0)) refuse(name + " step m", "is not above 0");
    return axis;
  }
  [[nodiscard]] signal::SarWindow window(const std::string& name) const {
    const auto window = signal::window_from_text(text(name));
    if (!window) refuse(name, "is not a window");
    return *window;
  }

 private:
  [[noreturn]] void refuse(const std::string& name, const char* what) const {
    throw core::InvalidRequest(fmt::format("{}: '{}' {}", file_, name, what), "measure images that sarsim focus wrote");
  }
  [[nodiscard]] double parsed(const std::string& name, std::string value) const {
    const std::size_t begin = value.find_first_not_of(' ');
    value.erase(0, begin);
    const auto number = core::parse_number(value);
    if (!number) refuse(name, "is not a number");
    return *number;
  }

  const raster::EnviHeader& header_;
  const std::string& file_;
};

}  // namespace

bool is_of_turning_target(const ImageOrigin& origin) { return origin.algorithm.starts_with("isar-"); }

bool is_on_the_earth(const signal::FocusedImage& image, const ImageOrigin& origin) {
  return origin.earth && !is_of_turning_target(origin) && image.frame.plane == signal::ImagePlane::ground_grid;
}

raster::EnviHeader header_of(const signal::FocusedImage& image, const ImageOrigin& origin) {
  raster::EnviHeader header;
  header.samples = image.range.count;
  header.lines = image.azimuth.count;
  const bool turning = is_of_turning_target(origin);
  const char* range = turning                                                ? "the line of sight"
                      : image.frame.plane == signal::ImagePlane::slant_range ? "slant range"
                                                                             : "ground range";
  header.description = fmt::format("Focused by sarsim {}: lines along {}, samples along {}", core::program_version,
                                   turning ? "cross-range" : "azimuth", range);
  auto& fields = header.fields;
  fields.emplace_back("image plane",
                      image.frame.plane == signal::ImagePlane::slant_range ? "slant range" : "ground grid");
  fields.emplace_back("origin m", vector_text(image.frame.origin_m));
  fields.emplace_back("along", vector_text(image.frame.along));
  fields.emplace_back("across", vector_text(image.frame.across));
  fields.emplace_back("speed mps", fmt::format("{}", image.frame.speed_mps));
  if (origin.anchor) fields.emplace_back("world anchor", anchor_text(*origin.anchor));
  add_axis(fields, "azimuth", image.azimuth);
  add_axis(fields, "range", image.range);
  fields.emplace_back("carrier hz", fmt::format("{}", image.carrier_hz));
  fields.emplace_back("light speed mps", fmt::format("{}", image.light_speed_mps));
  fields.emplace_back("source", origin.source);
  fields.emplace_back("script", origin.script);
  if (!origin.settings.empty()) fields.emplace_back("settings", origin.settings);
  fields.emplace_back("simulation", fmt::format("{}", origin.simulation + 1));
  fields.emplace_back("algorithm", origin.algorithm);
  fields.emplace_back("motion compensation", origin.motion);
  fields.emplace_back("range window", signal::to_string(origin.options.range_window));
  fields.emplace_back("azimuth window", signal::to_string(origin.options.azimuth_window));
  fields.emplace_back("doppler centroid hz", fmt::format("{}", origin.options.doppler_centroid_hz));
  fields.emplace_back("doppler bandwidth hz", fmt::format("{}", origin.options.doppler_bandwidth_hz));
  if (is_on_the_earth(image, origin)) std::ranges::move(map_fields(image, *origin.earth), std::back_inserter(fields));
  return header;
}

void read_header(const raster::EnviHeader& header, const std::string& file, signal::FocusedImage& image,
                 ImageOrigin& origin) {
  const FieldTaker fields(header, file);
  const bool slant = fields.word("image plane", {"slant range", "ground grid"}) == "slant range";
  image.frame = {slant ? signal::ImagePlane::slant_range : signal::ImagePlane::ground_grid, fields.vector("origin m"),
                 fields.direction("along"), slant ? fields.vector("across") : fields.direction("across"),
                 fields.above_zero("speed mps")};
  image.azimuth = fields.axis("azimuth", header.lines);
  image.range = fields.axis("range", header.samples);
  image.carrier_hz = fields.above_zero("carrier hz");
  image.light_speed_mps = fields.light_speed("light speed mps");
  origin.source = fields.text("source");
  origin.script = fields.text("script");
  origin.settings = header.field("settings").value_or("");
  origin.simulation = fields.position("simulation");
  origin.algorithm = fields.text("algorithm");
  origin.motion = header.field("motion compensation").value_or("none");
  origin.anchor.reset();
  if (const auto anchor = header.field("world anchor")) origin.anchor = anchor_from_text(*anchor, file);
  origin.options.range_window = fields.window("range window");
  origin.options.azimuth_window = fields.window("azimuth window");
  origin.options.doppler_centroid_hz = fields.number("doppler centroid hz");
  origin.options.doppler_bandwidth_hz = fields.number("doppler bandwidth hz");
}

}  // namespace sarsim::workflow
