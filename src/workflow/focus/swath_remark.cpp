#include "workflow/focus/swath_remark.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/sar_track.hpp"
#include "signal/sar/swath_loss.hpp"
#include "workflow/focus/sar_ghosts.hpp"

namespace sarsim::workflow {

namespace {

struct PlaceOfLoss {
  std::string name;
  double range_m = 0.0;
  double lowest_hz = 0.0;
  double highest_hz = 0.0;
};

// The target farthest from the middle of the swath.
std::optional<PlaceOfLoss> farthest_target(const simulate::Plan& plan, const signal::EchoRows& echoes, double middle_m,
                                           const core::WorkControl& control) {
  std::optional<PlaceOfLoss> farthest;
  for (const SarTarget& target : targets_from_line(plan, echoes, control)) {
    if (!(target.amplitude > 0.0) || !target.in_swath) continue;
    if (farthest && std::abs(target.place.range_m - middle_m) <= std::abs(farthest->range_m - middle_m)) continue;
    farthest = {fmt::format("target {}", target.target + 1), target.place.range_m, target.lowest_doppler_hz,
                target.highest_doppler_hz};
  }
  return farthest;
}

PlaceOfLoss edge_of_swath(const signal::FocusedImage& axes, const signal::FocusOptions& options) {
  PlaceOfLoss edge{"a point at the edge of the swath", axes.range.at(static_cast<double>(axes.range.count) - 1.0),
                   options.doppler_centroid_hz, options.doppler_centroid_hz};
  if (!options.spectrum) return edge;
  edge.lowest_hz = options.spectrum->azimuth.least_per_m * axes.frame.speed_mps;
  edge.highest_hz = options.spectrum->azimuth.most_per_m * axes.frame.speed_mps;
  return edge;
}

// Restricts a place to the Doppler frequencies that focusing does not fold.
void keep_band(PlaceOfLoss& place, const signal::FocusOptions& options, double prf_hz) {
  const double half_hz = 0.5 * (options.doppler_bandwidth_hz > 0.0 ? options.doppler_bandwidth_hz : prf_hz);
  const double centroid_hz = options.doppler_centroid_hz;
  place.lowest_hz = std::clamp(place.lowest_hz, centroid_hz - half_hz, centroid_hz + half_hz);
  place.highest_hz = std::clamp(place.highest_hz, centroid_hz - half_hz, centroid_hz + half_hz);
}

}  // namespace

core::Problems remarks_on_swath_loss(const simulate::Plan& plan, const signal::EchoRows& echoes,
                                     const signal::FocusOptions& options, const core::WorkControl& control) {
  constexpr double most_db = 0.1;
  constexpr double most_rad = 0.1;
  if (options.method == signal::FocusMethod::omega_k) return {};
  const signal::FocusedImage axes = signal::image_of(echoes, options);
  const double middle_m = axes.range.at(0.5 * static_cast<double>(axes.range.count));
  std::optional<PlaceOfLoss> place;
  if (plan.scene->scatterers.size() <= most_examined_targets)
    place = farthest_target(plan, echoes, middle_m, control);
  else
    place = edge_of_swath(axes, options);
  if (!place) return {};
  keep_band(*place, options, 1.0 / signal::fit_straight(echoes.track).interval_s);
  const signal::SwathLoss loss =
      signal::loss_off_mid_swath(echoes, options, place->range_m, place->lowest_hz, place->highest_hz);
  const double lost_db = -core::amplitude_db(loss.amplitude);
  const double worst = std::max(lost_db / most_db, std::abs(loss.phase_rad) / most_rad);
  if (worst < 0.1) return {};
  const bool scaled = options.method == signal::FocusMethod::chirp_scaling;
  return {core::problem_of(
      worst < 1.0 ? core::Severity::note : core::Severity::warning,
      fmt::format(
          "{} compresses all ranges like the middle of the swath at {:.1f} m: {}, {:.1f} m off it, loses {:.3g} "
          "dB, its phase is wrong by {:.3g} rad, and it is displaced by {:.2g} m in range",
          scaled ? "chirp scaling" : "range-Doppler", middle_m, place->name, std::abs(loss.from_middle_m), lost_db,
          loss.phase_rad, std::abs(loss.shift.range_m)),
      {}, worst < 1.0 ? "" : fmt::format("below {:.1f} dB and {:.1f} rad", most_db, most_rad),
      "use --algorithm omega-k, which compresses each range correctly")};
}

core::Problems remarks_on_area(const signal::EchoRows& echoes, const signal::FocusOptions& options) {
  if (!options.azimuth_area) return {};
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const double far_s = echoes.first_delay_s + static_cast<double>(echoes.columns) / echoes.waveform.sample_rate_hz;
  const double far_m = radar::range_of(far_s, echoes.waveform.light_speed_mps);
  const double low_m = track.speed_mps * track.time_s(0.0) - far_m;
  const double high_m = track.speed_mps * track.time_s(static_cast<double>(echoes.track.size()) - 1.0) + far_m;
  const signal::AxisInterval& area = *options.azimuth_area;
  if (area.first_m <= high_m && area.last_m >= low_m) return {};
  return {core::problem_of(
      core::Severity::warning,
      "the area in azimuth lies beyond all that the record holds echoes of: the image is empty",
      fmt::format("{:.6g} to {:.6g} m", area.first_m, area.last_m),
      fmt::format("a part of {:.6g} to {:.6g} m, the record and the farthest range on either side", low_m, high_m),
      "give an --azimuth within it")};
}

}  // namespace sarsim::workflow
