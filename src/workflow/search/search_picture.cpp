#include "workflow/search/search_picture.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "workflow/search/search_checks.hpp"

namespace sarsim::workflow {

namespace {

constexpr double max_pixels_to_a_side = 1000.0;  // by default
constexpr double max_pixels = 30000.0;           // of a picture's edge
constexpr double widest_half_sector_rad = 0.25 * core::pi;

core::Vec3 radar_at(const PulseRows& rows, std::size_t pulse) {
  simulate::PulseGeometry geometry(*rows.acquisition->scene, rows.acquisition->link);
  geometry.set_pulse(rows.number(pulse));
  return geometry.radar_pose().position_world_m;
}

// Ends of the cells around ascending ranges: half way between them.
std::vector<double> ends_of(const std::vector<double>& range_m) {
  std::vector<double> ends;
  const double step_m = range_m.size() > 1 ? range_m[1] - range_m[0] : 1.0;
  ends.push_back(std::max(0.0, range_m.front() - 0.5 * step_m));
  for (std::size_t i = 1; i < range_m.size(); ++i) ends.push_back(0.5 * (range_m[i - 1] + range_m[i]));
  ends.push_back(range_m.back() + 0.5 * step_m);
  return ends;
}

double above_zero(const char* option, double value) {
  if (value > 0.0) return value;
  throw core::InvalidRequest(fmt::format("{} {}: must be above 0", option, core::format_number(value)));
}

}  // namespace

double ground_range_m(double slant_m, double height_m) {
  return std::sqrt(std::max(0.0, slant_m * slant_m - height_m * height_m));
}

signal::PpiGrid picture_grid(const PulseRows& rows, const PictureArguments& arguments) {
  const core::Vec3 begin_m = radar_at(rows, 0);
  const core::Vec3 end_m = radar_at(rows, rows.pulses() - 1);
  const core::Vec3 middle_m = 0.5 * (begin_m + end_m);
  const double reach_m = ground_range_m(rows.range_m.back(), middle_m.z - arguments.height_m.value_or(0.0));
  if (!(reach_m > 0.0))
    throw core::InvalidRequest(
        "the ground is beyond the recorded ranges",
        fmt::format("record beyond {:.6g} m, or set the height of the displayed plane with --height",
                    std::abs(middle_m.z - arguments.height_m.value_or(0.0))));
  const double extent_m = arguments.extent_m ? above_zero("--extent", *arguments.extent_m)
                                             : reach_m + 0.5 * std::hypot(end_m.x - begin_m.x, end_m.y - begin_m.y);
  const double step_m = rows.samples() > 1 ? rows.range_m[1] - rows.range_m[0] : reach_m;
  const double pixel_m =
      arguments.pixel_m ? above_zero("--pixel", *arguments.pixel_m) : std::max(step_m, extent_m / max_pixels_to_a_side);
  if (2.0 * extent_m / pixel_m > max_pixels)
    throw core::InvalidRequest(
        fmt::format("a picture of {:.6g} pixels to a side is too large", 2.0 * extent_m / pixel_m),
        fmt::format("give --pixel at least {:.3g}, or --extent less", 2.0 * extent_m / max_pixels));
  return signal::ppi_grid(middle_m.x, middle_m.y, extent_m, pixel_m);
}

double turns_of_beam(const PulseRows& rows) {
  simulate::PulseGeometry geometry(*rows.acquisition->scene, rows.acquisition->link);
  double first_rad = 0.0;
  double last_rad = 0.0;
  double farthest_rad = 0.0;
  for (std::size_t pulse = 0; pulse < rows.pulses(); ++pulse) {
    geometry.set_pulse(rows.number(pulse));
    double beam_rad = core::azimuth_rad(geometry.pointing().axis_world());
    if (pulse == 0) first_rad = last_rad = beam_rad;
    beam_rad += 2.0 * core::pi * std::round((last_rad - beam_rad) / (2.0 * core::pi));
    last_rad = beam_rad;
    farthest_rad = std::max(farthest_rad, std::abs(beam_rad - first_rad));
  }
  return std::floor(farthest_rad / (2.0 * core::pi) + 1e-9) + 1.0;
}

double turns_to_come(const PulseRows& rows) {
  const radar::Beam& beam = rows.acquisition->link.beam;
  if (beam.kind != radar::Beam::Kind::rotating) return turns_of_beam(rows);
  const radar::Repetition& repetition = rows.acquisition->link.repetition;
  const radar::PulseRange& pulses = rows.acquisition->timing.pulses;
  const double time_s = repetition.send_time_s(pulses.last) - repetition.send_time_s(pulses.first);
  return std::floor(std::abs(beam.rate_rad_per_s) * time_s / (2.0 * core::pi) + 1e-9) + 1.0;
}

GroundPlace place_of(const SearchInterval& interval, const SearchDetection& detection, double height_m) {
  const core::Vec3& radar_m = interval.radar_world_m;
  const double ground_m = ground_range_m(detection.range_m, radar_m.z - height_m);
  return {radar_m.x + ground_m * std::sin(detection.azimuth_rad),
          radar_m.y + ground_m * std::cos(detection.azimuth_rad)};
}

SearchPicture::SearchPicture(const PulseRows& rows, const PictureArguments& arguments)
    : rows_(rows),
      height_m_(arguments.height_m.value_or(0.0)),
      still_rad_(beam_width_rad(*rows.acquisition)),
      scan_(arguments.scan),
      picture_(picture_grid(rows, arguments)) {
  constexpr double usual_width_rad = core::rad_per_deg;
  if (still_rad_ <= 0.0) still_rad_ = usual_width_rad;
}

SearchPicture::Line SearchPicture::line_of(const SearchInterval& interval) const {
  Line line;
  line.x_m = interval.radar_world_m.x;
  line.y_m = interval.radar_world_m.y;
  line.azimuth_rad = core::azimuth_rad(interval.beam_world);
  if (waiting_)
    line.azimuth_rad += 2.0 * core::pi * std::round((waiting_->azimuth_rad - line.azimuth_rad) / (2.0 * core::pi));
  for (const double end_m : ends_of(rows_.range_m))
    line.edges_m.push_back(ground_range_m(end_m, interval.radar_world_m.z - height_m_));
  const std::size_t samples = interval.map.samples;
  line.strengths.assign(samples, 0.0F);
  for (std::size_t i = 0; i < interval.map.values.size(); ++i) {
    float& strength = line.strengths[i % samples];
    strength = std::max(strength, std::abs(interval.map.values[i]));
  }
  return line;
}

void SearchPicture::take(const SearchInterval& interval) {
  Line line = line_of(interval);
  if (!waiting_) {
    first_azimuth_rad_ = line.azimuth_rad;
    waiting_ = std::move(line);
    return;
  }
  const double step_rad = line.azimuth_rad - waiting_->azimuth_rad;
  paint(*waiting_, lines_ == 0 ? step_rad : before_rad_, step_rad);
  before_rad_ = step_rad;
  waiting_ = std::move(line);
}

void SearchPicture::finish() {
  if (!waiting_) return;
  paint(*waiting_, before_rad_, before_rad_);
  waiting_.reset();
}

// The steps of azimuth to the line before and to the line after say how wide a line is.
void SearchPicture::paint(const Line& line, double before_rad, double after_rad) {
  constexpr double still = 1e-9;
  ++lines_;
  const double turned = std::abs(line.azimuth_rad - first_azimuth_rad_);
  farthest_turn_rad_ = std::max(farthest_turn_rad_, turned);
  constexpr double rounding = 1e-9;
  if (scan_ && static_cast<std::size_t>(turned / (2.0 * core::pi) + rounding) != *scan_) return;
  const auto half = [](double step_rad) { return std::min(0.5 * std::abs(step_rad), widest_half_sector_rad); };
  double begin = half(before_rad);
  double end = half(after_rad);
  if (before_rad + after_rad < 0.0) std::swap(begin, end);
  if (begin + end < still) begin = end = half(still_rad_);
  picture_.paint({line.x_m, line.y_m, line.azimuth_rad - begin, line.azimuth_rad + end, line.edges_m, line.strengths});
}

std::size_t SearchPicture::scans() const {
  return static_cast<std::size_t>(farthest_turn_rad_ / (2.0 * core::pi) + 1e-9) + 1;
}

}  // namespace sarsim::workflow
