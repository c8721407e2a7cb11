#include "workflow/focus/image_reach.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "workflow/focus/target_aspects.hpp"

namespace sarsim::workflow {

namespace {

constexpr double margin_samples = 32.0;

double end_of(const signal::ImageAxis& axis) { return axis.at(static_cast<double>(axis.count) - 1.0); }

// By how many samples a place lies beyond the ends of an axis; 0 within.
double beyond(const signal::ImageAxis& axis, double place_m) {
  const double at = axis.index_of(place_m);
  return std::max({0.0, -0.5 - at, at - static_cast<double>(axis.count) + 0.5});
}

// Samples of an axis that is made to hold an interval.
double samples_with(const signal::ImageAxis& axis, const std::optional<signal::AxisInterval>& reach) {
  if (!reach) return static_cast<double>(axis.count);
  return (std::max(end_of(axis), reach->last_m) - std::min(axis.first_m, reach->first_m)) / axis.step_m + 1.0;
}

void include(std::optional<signal::AxisInterval>& reach, const signal::ImageAxis& axis, double place_m,
             double margin_m) {
  if (!(beyond(axis, place_m) > 0.0)) return;
  if (!reach) reach = signal::AxisInterval{place_m - margin_m, place_m + margin_m};
  reach->first_m = std::min(reach->first_m, place_m - margin_m);
  reach->last_m = std::max(reach->last_m, place_m + margin_m);
}

// A part of the warning about one axis: "at 512 m along the track, the image covers -300 to 300 m".
std::string text_of_axis(double place_m, const signal::ImageAxis& axis, const char* what) {
  return fmt::format("at {:.1f} m {}, the image covers {:.1f} to {:.1f} m", place_m, what, axis.first_m, end_of(axis));
}

std::string area_of(const signal::ImageAxis& axis, double least_m, double most_m, double margin_m) {
  return fmt::format("{:.0f}:{:.0f}", std::floor(std::min(axis.first_m, least_m - margin_m)),
                     std::ceil(std::max(end_of(axis), most_m + margin_m)));
}

// What is shown of a response on either side, along the track and in range.
double azimuth_margin_m(const signal::FocusedImage& image, const SarTarget& target) {
  constexpr double widths = 4.0;
  const double band_hz = target.highest_doppler_hz - target.lowest_doppler_hz;
  const double width_m = band_hz > 0.0 ? image.frame.speed_mps / band_hz : 0.0;
  return std::max(margin_samples * image.azimuth.step_m, widths * width_m);
}
double range_margin_m(const signal::FocusedImage& image) { return margin_samples * image.range.step_m; }

}  // namespace

bool shows(const signal::FocusedImage& image, const signal::ImagePlace& place) {
  return !(beyond(image.azimuth, place.azimuth_m) > 0.0) && !(beyond(image.range, place.range_m) > 0.0);
}

std::vector<SarTarget> targets_to_show(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                       const DopplerBand& kept, const core::WorkControl& control) {
  constexpr std::size_t max_looks = 513;
  constexpr double weakest = 0.1;
  signal::EchoRows line = echoes;
  line.compensated = true;
  const TargetAspects looks(acquisition, line, {}, max_looks);
  std::vector<SarTarget> targets = sar_targets(looks, control);
  double strongest = 0.0;
  for (const SarTarget& target : targets)
    if (target.recorded) strongest = std::max(strongest, target.amplitude);
  std::erase_if(targets, [&](const SarTarget& target) {
    const double middle_hz = 0.5 * (target.lowest_doppler_hz + target.highest_doppler_hz);
    const bool has = kept.width_hz <= 0.0 || std::abs(middle_hz - kept.centroid_hz) <= 0.5 * kept.width_hz;
    return !(target.recorded && target.amplitude >= weakest * strongest && has && looks.resting_place(target.target));
  });
  return targets;
}

void reach_targets(const std::vector<SarTarget>& targets, const signal::EchoRows& echoes,
                   signal::FocusOptions& options) {
  constexpr double max_times = 4.0;
  constexpr double always_samples = 4e6;
  options.azimuth_reach.reset();
  options.range_reach.reset();
  if (targets.empty()) return;
  const signal::FocusedImage image = signal::image_of(echoes, options);
  const double most = std::max(
      always_samples, max_times * static_cast<double>(image.azimuth.count) * static_cast<double>(image.range.count));
  std::vector<SarTarget> outside;
  std::ranges::copy_if(targets, std::back_inserter(outside),
                       [&](const SarTarget& target) { return !shows(image, target.place); });
  std::ranges::stable_sort(outside, {}, [&](const SarTarget& target) {
    return beyond(image.azimuth, target.place.azimuth_m) + beyond(image.range, target.place.range_m);
  });
  for (const SarTarget& target : outside) {
    std::optional<signal::AxisInterval> azimuth = options.azimuth_reach;
    std::optional<signal::AxisInterval> range = options.range_reach;
    if (!options.azimuth_area) include(azimuth, image.azimuth, target.place.azimuth_m, azimuth_margin_m(image, target));
    if (!options.range_area) include(range, image.range, target.place.range_m, range_margin_m(image));
    if (samples_with(image.azimuth, azimuth) * samples_with(image.range, range) > most) break;
    options.azimuth_reach = azimuth;
    options.range_reach = range;
  }
}

core::Problems diagnose_outside(const std::vector<SarTarget>& targets, const signal::FocusedImage& image,
                                const signal::FocusOptions& options, bool in_time) {
  const auto off_azimuth = [&](const SarTarget& target) {
    return options.azimuth_area ? 0.0 : beyond(image.azimuth, target.place.azimuth_m);
  };
  const auto off_range = [&](const SarTarget& target) {
    return options.range_area ? 0.0 : beyond(image.range, target.place.range_m);
  };
  std::vector<SarTarget> outside;
  for (const SarTarget& target : targets)
    if (off_azimuth(target) > 0.0 || off_range(target) > 0.0) outside.push_back(target);
  if (outside.empty()) return {};
  const SarTarget& farthest = *std::ranges::max_element(
      outside, {}, [&](const SarTarget& target) { return off_azimuth(target) + off_range(target); });
  std::string where;
  std::string areas;
  const auto add = [](std::string& text, const char* between, const std::string& more) {
    text += (text.empty() ? "" : between) + more;
  };
  if (off_azimuth(farthest) > 0.0)
    add(where, "; ", text_of_axis(farthest.place.azimuth_m, image.azimuth, "along the track"));
  if (off_range(farthest) > 0.0)
    add(where, "; ", text_of_axis(farthest.place.range_m, image.range, "of closest distance"));
  const auto [least_azimuth, most_azimuth] =
      std::ranges::minmax(outside, {}, [](const SarTarget& target) { return target.place.azimuth_m; });
  const auto [least_range, most_range] =
      std::ranges::minmax(outside, {}, [](const SarTarget& target) { return target.place.range_m; });
  if (std::ranges::any_of(outside, [&](const SarTarget& target) { return off_azimuth(target) > 0.0; }))
    add(areas, " ",
        "--azimuth " +
            area_of(image.azimuth, least_azimuth.place.azimuth_m, most_azimuth.place.azimuth_m,
                    std::max(azimuth_margin_m(image, least_azimuth), azimuth_margin_m(image, most_azimuth))));
  if (std::ranges::any_of(outside, [&](const SarTarget& target) { return off_range(target) > 0.0; }))
    add(areas, " ",
        "--range " + area_of(image.range, least_range.place.range_m, most_range.place.range_m, range_margin_m(image)));
  const bool scaled = !in_time && options.method == signal::FocusMethod::chirp_scaling;
  std::vector<std::size_t> numbers;
  for (const SarTarget& target : outside) numbers.push_back(target.target);
  return {core::warning("focus.targets-outside-image",
                        outside.size() == 1
                            ? fmt::format("target {} is outside the image: {}", farthest.target + 1, where)
                            : fmt::format("{} targets ({}) are outside the image: target {}, the farthest, {}",
                                          outside.size(), target_list(numbers), farthest.target + 1, where))
              .hint(fmt::format("use {}{}", scaled ? "--algorithm omega-k " : "", areas))};
}

}  // namespace sarsim::workflow
