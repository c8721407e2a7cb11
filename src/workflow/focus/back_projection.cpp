#include "workflow/focus/back_projection.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/back_projection.hpp"
#include "signal/sar/ground_grid.hpp"
#include "workflow/focus/sar_rows.hpp"

namespace sarsim::workflow {

namespace {

// Towards the scene, perpendicular to the track.
core::Vec3 across_of(const core::Vec3& scene_m, const signal::ImageFrame& frame) {
  const core::Vec3 to_scene = scene_m - frame.origin_m;
  const core::Vec3 across = to_scene - core::dot(to_scene, frame.along) * frame.along;
  return core::norm(across) > 0.0 ? (1.0 / core::norm(across)) * across : core::Vec3{0.0, 0.0, -1.0};
}

// The azimuth window over the record, as weights whose mean is 1.
void weigh_pulses(signal::SarEchoes& echoes, const signal::SarWindow& window) {
  const auto weight = signal::weight_of(window);
  const double count = static_cast<double>(echoes.track.size());
  double sum = 0.0;
  for (std::size_t p = 0; p < echoes.track.size(); ++p) sum += weight((static_cast<double>(p) + 0.5) / count - 0.5);
  for (std::size_t p = 0; p < echoes.track.size(); ++p) {
    const auto factor = static_cast<float>(weight((static_cast<double>(p) + 0.5) / count - 0.5) * count / sum);
    for (std::size_t n = 0; n < echoes.samples; ++n) echoes.volts[p * echoes.samples + n] *= factor;
  }
}

// More columns where the antenna strays so far from its line that targets with recorded echoes are nearer to the line,
// or farther from it, than all recorded ranges.
void reach_targets(signal::ImageAxis& range, const std::vector<SarTarget>& targets) {
  constexpr double margin = 32.0;
  double first = 0.0;
  double last = static_cast<double>(range.count) - 1.0;
  for (const SarTarget& target : targets) {
    if (!(target.amplitude > 0.0) || !target.recorded) continue;
    const double at = range.index_of(target.place.range_m);
    if (at < 0.0) first = std::min(first, std::floor(at - margin));
    if (at > static_cast<double>(range.count) - 1.0) last = std::max(last, std::ceil(at + margin));
  }
  range.first_m = range.at(first);
  range.count = static_cast<std::size_t>(last - first) + 1;
}

// Closer rows where targets have Doppler frequencies that the pulses alternate too slowly for: back projection resolves
// them nevertheless, and its image is to hold them.
void refine_azimuth(signal::ImageAxis& axis, const std::vector<SarTarget>& targets, const signal::FocusOptions& options,
                    double speed_mps) {
  double band_hz = 0.0;
  for (const SarTarget& target : targets) {
    if (!(target.amplitude > 0.0)) continue;
    // All pulses are summed, those that see the target in sidelobes of the antenna, too.
    const double above_hz = target.max_doppler_hz - options.doppler_centroid_hz;
    const double below_hz = options.doppler_centroid_hz - target.min_doppler_hz;
    band_hz = std::max({band_hz, 2.0 * above_hz, 2.0 * below_hz});
  }
  if (options.doppler_bandwidth_hz > 0.0) band_hz = std::min(band_hz, options.doppler_bandwidth_hz);
  constexpr double most = 16.0;
  const auto factor = static_cast<std::size_t>(std::clamp(std::ceil(band_hz * axis.step_m / speed_mps), 1.0, most));
  axis.step_m /= static_cast<double>(factor);
  axis.count *= factor;
}

signal::BackProjectionOptions options_of(const signal::FocusOptions& options, const signal::FocusedImage& image) {
  const double per_hz = radar::range_of_cycle(image.carrier_hz * image.frame.speed_mps, image.light_speed_mps);
  const auto angle = [&](double hz) { return std::asin(std::clamp(per_hz * hz, -1.0, 1.0)); };
  signal::BackProjectionOptions back;
  back.heading = image.frame.along;
  back.squint_rad = angle(options.doppler_centroid_hz);
  const auto shifted = [](const signal::SarWindow& window) {
    return [weight = signal::weight_of(window)](double x) { return weight(x - 0.5); };
  };
  if (options.range_window.kind != signal::SarWindow::Kind::rectangular)
    back.range_window = shifted(options.range_window);
  if (options.doppler_bandwidth_hz <= 0.0) return back;
  back.aperture = signal::BackProjectionOptions::Aperture::beam;
  const double low_rad = angle(options.doppler_centroid_hz - 0.5 * options.doppler_bandwidth_hz);
  const double high_rad = angle(options.doppler_centroid_hz + 0.5 * options.doppler_bandwidth_hz);
  back.squint_rad = 0.5 * (low_rad + high_rad);
  back.beam_rad = high_rad - low_rad;
  back.azimuth_window = shifted(options.azimuth_window);
  return back;
}

void expect_ground_in_reach(const signal::FocusedImage& axes, double ground_m) {
  const double level = std::hypot(axes.frame.along.x, axes.frame.along.y);
  const double nearest_m = std::abs(axes.frame.origin_m.z - ground_m) / std::max(level, 1e-6);
  if (level < 1e-6 || axes.range.at(static_cast<double>(axes.range.count)) > nearest_m) return;
  throw core::InvalidRequest(
      fmt::format("back projection: ground at {:.6g} m is {:.6g} m or more away, farther than all ranges "
                  "of the image",
                  ground_m, nearest_m),
      "give the ground another --height");
}

// The frame of the points that are focused, and the height of those of slant range.
std::optional<double> place_axes(signal::FocusedImage& axes, const FocusInput& input,
                                 const BackProjectionChoice& choice) {
  if (axes.frame.plane == signal::ImagePlane::ground_grid) return std::nullopt;
  core::Vec3 scene_m = scene_middle_m(*input.acquisition);
  if (choice.ground_m) scene_m.z = *choice.ground_m;
  if (!choice.ground) {
    axes.frame.across = across_of(scene_m, axes.frame);
    if (choice.ground_m) expect_ground_in_reach(axes, scene_m.z);
    return scene_m.z;
  }
  if (core::norm(core::cross(axes.frame.along, {0.0, 0.0, 1.0})) < 1e-6)
    throw core::InvalidRequest("--grid ground: the antenna flies vertically, so ground range is undefined",
                               "leave out --grid ground");
  try {
    axes = signal::on_ground(axes, scene_m);
  } catch (const std::invalid_argument& error) {
    throw core::InvalidRequest(error.what(), "give the ground another --height, or leave out --grid ground");
  }
  return std::nullopt;
}

// Columns beyond the recorded ranges are made as well, but not so far away that they could not be counted.
void cut_range(signal::ImageAxis& range, const signal::AxisInterval& area) {
  constexpr double max_columns = 0x1p40;
  const double first = range.index_of(area.first_m);
  const double last = range.index_of(area.last_m);
  if (!(std::abs(first) <= max_columns && std::abs(last) <= max_columns)) {
    const double max_m = max_columns * range.step_m;
    throw core::InvalidRequest(
        {core::error("--range reaches too far from the recorded ranges")
             .found(fmt::format("{:.6g} to {:.6g} m", area.first_m, area.last_m))
             .expected(fmt::format("ranges from {:.6g} to {:.6g} m", range.first_m - max_m, range.first_m + max_m))
             .hint(fmt::format("recorded are {:.6g} to {:.6g} m", range.first_m,
                               range.at(static_cast<double>(range.count))))});
  }
  signal::cut_axis(range, area);
}

}  // namespace

void expect_samples(const signal::FocusedImage& axes) {
  if (axes.azimuth.count == 0 || axes.range.count == 0)
    throw core::InvalidRequest("no sample of the image lies in the area of --azimuth and --range",
                               "give a larger area");
}

signal::FocusedImage back_projection_axes(const signal::EchoRows& echoes, const std::vector<SarTarget>& targets,
                                          const signal::FocusOptions& options) {
  signal::FocusOptions plain = options;
  plain.method = signal::FocusMethod::range_doppler;
  plain.spectrum.reset();
  plain.azimuth_area.reset();
  plain.range_area.reset();
  signal::FocusedImage axes = signal::image_of(echoes, plain);
  refine_azimuth(axes.azimuth, targets, options, axes.frame.speed_mps);
  if (options.spectrum) {
    signal::fit_axis(axes.azimuth, options.spectrum->azimuth);
    signal::fit_axis(axes.range, options.spectrum->range);
  }
  reach_targets(axes.range, targets);
  return axes;
}

signal::FocusedRows back_projected(const FocusInput& input, signal::FocusedImage axes,
                                   const BackProjectionChoice& choice, const signal::FocusOptions& options,
                                   const core::WorkControl& control, const core::ProgressReport& progress) {
  signal::BackProjectionOptions back = options_of(options, axes);
  back.start_stop = choice.start_stop;
  back.ground_m = place_axes(axes, input, choice);
  if (options.azimuth_area) signal::cut_axis(axes.azimuth, *options.azimuth_area);
  if (options.range_area) cut_range(axes.range, *options.range_area);
  expect_samples(axes);
  const double bytes =
      8.0 * (static_cast<double>(input.echoes.track.size()) * static_cast<double>(input.echoes.columns) +
             static_cast<double>(axes.azimuth.count) * static_cast<double>(axes.range.count));
  if (options.memory_bytes > 0 && bytes > static_cast<double>(options.memory_bytes))
    throw core::InvalidRequest(
        fmt::format("back projection holds echoes and image in memory, {}, but --memory allows {}",
                    core::bytes_text(bytes), core::bytes_text(static_cast<double>(options.memory_bytes))),
        "allow more, or use another --algorithm");
  signal::SarEchoes echoes = signal::sar_echoes(input.echoes, control);
  if (options.doppler_bandwidth_hz <= 0.0) weigh_pulses(echoes, options.azimuth_window);
  const auto image = std::make_shared<const signal::FocusedImage>(
      signal::back_project(echoes, axes.frame, axes.azimuth, axes.range, back, control, progress));
  signal::FocusedRows rows = signal::rows_of(image);
  rows.image = {.frame = image->frame,
                .azimuth = axes.azimuth,
                .range = axes.range,
                .carrier_hz = axes.carrier_hz,
                .light_speed_mps = axes.light_speed_mps,
                .values = {}};
  return rows;
}

}  // namespace sarsim::workflow
