#include "workflow/focus/scene_grid.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "radar/path/path.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/flown_spectrum.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/focus/target_sights.hpp"

namespace sarsim::workflow {

namespace {

signal::ImageFrame frame_of_scene(const signal::EchoRows& echoes, const core::Vec3& scene_m) {
  const signal::ReferenceTrack line = signal::fitted_track(echoes.track);
  signal::ImageFrame frame;
  frame.plane = signal::ImagePlane::ground_grid;
  frame.origin_m = scene_m;
  frame.speed_mps = core::norm(line.velocity_mps);
  const core::Vec3 level{line.velocity_mps.x, line.velocity_mps.y, 0.0};
  if (core::norm(level) > 1e-6 * frame.speed_mps && frame.speed_mps > 0.0)
    frame.along = (1.0 / core::norm(level)) * level;
  frame.across = core::cross(frame.along, {0.0, 0.0, 1.0});
  return frame;
}

// Coordinates of the targets that the beam lit.
struct LitArea {
  signal::ImagePlace least{INFINITY, INFINITY};
  signal::ImagePlace most{-INFINITY, -INFINITY};

  void add(const signal::ImagePlace& place) {
    least = {std::min(least.azimuth_m, place.azimuth_m), std::min(least.range_m, place.range_m)};
    most = {std::max(most.azimuth_m, place.azimuth_m), std::max(most.range_m, place.range_m)};
  }
  [[nodiscard]] bool empty() const { return !(most.azimuth_m >= least.azimuth_m); }
};

struct LitTarget {
  double amplitude = 0.0;
  core::Vec3 point_m;
};

LitArea lit_area(const FocusInput& input, const signal::ImageFrame& frame, const core::WorkControl& control) {
  constexpr SightLimits limits{4096, 65};
  constexpr double weakest = 0.01;
  const std::size_t every = target_stride(*input.acquisition, limits);
  LitArea area;
  if (every == 0) return area;
  std::vector<LitTarget> lit((input.acquisition->scene->scatterers.size() + every - 1) / every);
  each_target_in_sight(*input.acquisition, input.echoes, limits, control,
                       [&](std::size_t target, std::span<const PulseSight> sights) {
                         LitTarget& one = lit[target / every];
                         for (const PulseSight& sight : sights)
                           if (sight.amplitude > one.amplitude) one = {sight.amplitude, sight.point_m};
                       });
  double strongest = 0.0;
  for (const LitTarget& target : lit) strongest = std::max(strongest, target.amplitude);
  for (const LitTarget& target : lit)
    if (target.amplitude > 0.0 && target.amplitude >= weakest * strongest)
      area.add(signal::place_of(frame, target.point_m));
  return area;
}

signal::ImageAxis axis_around(double min_m, double max_m, const signal::SpectrumExtent& extent) {
  constexpr double spare = 1.1;
  constexpr double min_samples = 48.0;
  constexpr double share = 0.1;
  constexpr double min_per_m = 1e-6;  // of an echo of one frequency from one direction
  signal::ImageAxis axis;
  axis.step_m = 1.0 / (spare * std::max(extent.width_per_m(), min_per_m));
  axis.spectrum_centre_per_m = extent.middle_per_m();
  const double margin_m = std::max(share * (max_m - min_m), min_samples * axis.step_m);
  // Of whole steps from 0, so that areas of one scene have their samples at the same places.
  axis.first_m = axis.step_m * std::floor((min_m - margin_m) / axis.step_m);
  axis.count = static_cast<std::size_t>(std::ceil((max_m + margin_m - axis.first_m) / axis.step_m)) + 1;
  return axis;
}

}  // namespace

bool flies_along_a_line(const signal::EchoRows& echoes) {
  return signal::straightness(echoes.track) >= signal::min_straightness;
}

signal::FocusedImage scene_grid_axes(const FocusInput& input, std::optional<double> ground_m,
                                     const core::WorkControl& control) {
  core::Vec3 scene_m = scene_middle_m(*input.acquisition);
  if (ground_m) scene_m.z = *ground_m;
  signal::FocusedImage image;
  image.carrier_hz = input.echoes.waveform.carrier_hz;
  image.light_speed_mps = input.echoes.waveform.light_speed_mps;
  image.frame = frame_of_scene(input.echoes, scene_m);
  const double cell_m = radar::range_of_cycle(input.echoes.waveform.sample_rate_hz, image.light_speed_mps);
  const signal::SpectrumExtent coarse{-0.5 / cell_m, 0.5 / cell_m};
  const auto seen = flown_spectrum(*input.acquisition, input.echoes, image.frame, scene_m, {}, control);
  const signal::ImageSpectrum spectrum = seen.value_or(signal::ImageSpectrum{coarse, coarse});
  LitArea area = lit_area(input, image.frame, control);
  if (area.empty()) {
    const double half_m = 0.5 * cell_m * static_cast<double>(input.echoes.columns);
    area.add({-half_m, -half_m});
    area.add({half_m, half_m});
  }
  image.azimuth = axis_around(area.least.azimuth_m, area.most.azimuth_m, spectrum.azimuth);
  image.range = axis_around(area.least.range_m, area.most.range_m, spectrum.range);
  return image;
}

}  // namespace sarsim::workflow
