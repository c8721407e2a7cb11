#include "workflow/focus/movers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "signal/sar/sar_track.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/target_aspects.hpp"

namespace sarsim::workflow {

namespace {

// The largest speed of each target, and where it is in the middle of the recording.
struct Motions {
  std::vector<double> speeds_mps;
  std::vector<core::Vec3> middles_m;
};

Motions motions_of(const simulate::Acquisition& acquisition) {
  constexpr std::int64_t looks = 17;
  const auto& scatterers = acquisition.scene->scatterers;
  Motions motions{std::vector<double>(scatterers.size()), std::vector<core::Vec3>(scatterers.size())};
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  for (std::int64_t look = 0; look < looks; ++look) {
    geometry.set_pulse(acquisition.timing.pulses.first + look * (acquisition.timing.pulses.count() - 1) / (looks - 1));
    for (std::size_t t = 0; t < scatterers.size(); ++t) {
      const radar::Pose& pose = geometry.pose(scatterers[t].platform);
      const double speed = core::norm(radar::world_velocity_mps(pose, scatterers[t].position_m));
      motions.speeds_mps[t] = std::max(motions.speeds_mps[t], speed);
      if (2 * look == looks - 1) motions.middles_m[t] = radar::world_position_m(pose, scatterers[t].position_m);
    }
  }
  return motions;
}

void remark_on_rows(const std::vector<SarTarget>& targets, const std::vector<std::size_t>& movers,
                    const signal::FocusedImage& image, double origin_m, core::Problems& problems) {
  const double first_m = image.azimuth.first_m;
  const double last_m = image.azimuth.at(static_cast<double>(image.azimuth.count) - 1.0);
  std::vector<std::size_t> outside;
  double nearest_m = INFINITY;
  double farthest_m = -INFINITY;
  for (const std::size_t t : movers) {
    const double azimuth_m = targets[t].place.azimuth_m - origin_m;
    if (!(targets[t].amplitude > 0.0) || (azimuth_m >= first_m && azimuth_m <= last_m)) continue;
    outside.push_back(t);
    nearest_m = std::min(nearest_m, azimuth_m);
    farthest_m = std::max(farthest_m, azimuth_m);
  }
  if (outside.empty()) return;
  constexpr double spare_m = 10.0;
  problems.push_back(
      core::warning(
          "focus.movers-outside-image",
          fmt::format(
              "the images of moving targets ({}) are displaced to azimuths from {:.0f} to {:.0f} m: the image, from "
              "{:.0f} to {:.0f} m, does not reach that far",
              target_list(outside), nearest_m, farthest_m, first_m, last_m))
          .hint(fmt::format("extend it with --azimuth {:.0f}:{:.0f}", std::min(first_m, nearest_m - spare_m),
                            std::max(last_m, farthest_m + spare_m))));
}

}  // namespace

core::Problems diagnose_movers(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                               const std::optional<signal::FocusedImage>& image, const core::WorkControl& control) {
  constexpr double rest_mps = 1e-6;
  if (acquisition.scene->scatterers.size() > max_examined_targets || acquisition.scene->scatterers.empty()) return {};
  const Motions motions = motions_of(acquisition);
  std::vector<std::size_t> movers;
  for (std::size_t t = 0; t < motions.speeds_mps.size(); ++t)
    if (motions.speeds_mps[t] > rest_mps) movers.push_back(t);
  if (movers.empty()) return {};
  const std::vector<SarTarget> targets = targets_from_line(acquisition, echoes, control);
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  double fastest_mps = 0.0;
  double farthest_m = 0.0;
  for (const std::size_t t : movers) {
    fastest_mps = std::max(fastest_mps, motions.speeds_mps[t]);
    if (!(targets[t].amplitude > 0.0)) continue;
    const double azimuth_m = core::dot(motions.middles_m[t] - track.origin_m, track.along);
    farthest_m = std::max(farthest_m, std::abs(targets[t].place.azimuth_m - azimuth_m));
  }
  core::Problems problems{core::note(
      "focus.movers-displaced",
      fmt::format(
          "{} of {} targets ({}) move or turn with their platform, at up to {:.3g} m/s: their images are displaced by "
          "up to {:.3g} m along the track, and blurred",
          movers.size(), targets.size(), target_list(movers), fastest_mps, farthest_m))};
  if (image && image->frame.plane == signal::ImagePlane::slant_range)
    remark_on_rows(targets, movers, *image, core::dot(image->frame.origin_m - track.origin_m, track.along), problems);
  return problems;
}

}  // namespace sarsim::workflow
