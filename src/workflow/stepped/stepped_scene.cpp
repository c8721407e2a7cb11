#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/run/sampled_views.hpp"
#include "workflow/focus/matched_filter_coverage.hpp"
#include "workflow/stepped/profile_series.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::size_t max_targets = 4096;

std::int64_t pulse_of(const SteppedRows& rows, std::size_t burst, std::size_t in_burst) {
  return rows.first_pulse + static_cast<std::int64_t>(burst * rows.band->waveform().burst_pulses() + in_burst);
}

// Columns of a matrix as rows: the rate at which a frame turns, as a vector. W = R' R^T is antisymmetric.
core::Vec3 turn_rate_radps(const radar::Pose& pose) {
  const core::Mat3 w = pose.world_from_platform_rate * core::transposed(pose.world_from_platform);
  return {0.5 * (w.row[2].y - w.row[1].z), 0.5 * (w.row[0].z - w.row[2].x), 0.5 * (w.row[1].x - w.row[0].y)};
}

}  // namespace

std::vector<BurstTruth> truth_of_burst(const SteppedRows& rows, std::size_t burst) {
  const simulate::Acquisition& acquisition = *rows.acquisition;
  const std::size_t pulses = rows.band->waveform().burst_pulses();
  const double light_mps = acquisition.light_speed_mps();
  std::vector<BurstTruth> truth(acquisition.scene->scatterers.size());
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  const bool compressed = acquisition.reception.is_compressed();
  const MatchedFilterCoverage gain(
      acquisition, acquisition.reception.columns, compressed ? acquisition.link.window : [](double) { return 1.0; });
  for (std::size_t p = 0; p < pulses; ++p) {
    geometry.set_pulse(pulse_of(rows, burst, p));
    const radar::Pointing pointing = geometry.pointing();
    for (std::size_t t = 0; t < truth.size(); ++t) {
      const simulate::ScattererView view = geometry.view(t, pointing);
      truth[t].amplitude += view.amplitude_sqrt_w * gain.gain(view.delay_s) / static_cast<double>(pulses);
      // The middle of the burst lies on the pulse there, or between two.
      const double share = p == (pulses - 1) / 2 || p == pulses / 2 ? (pulses % 2 == 1 ? 1.0 : 0.5) : 0.0;
      truth[t].range_m += radar::range_of(view.delay_s, share * light_mps);
      truth[t].speed_mps += share * view.speed_mps;
    }
  }
  for (std::size_t t = 0; t < truth.size(); ++t) truth[t].target = t;
  return truth;
}

std::vector<double> illumination_of(const SteppedRows& rows, const core::WorkControl& control) {
  const simulate::Acquisition& acquisition = *rows.acquisition;
  const std::size_t targets = acquisition.scene->scatterers.size();
  std::vector<double> power(rows.bursts);
  core::parallel_ranges(rows.bursts, 16, control, [&](std::size_t begin, std::size_t end) {
    simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
    for (std::size_t b = begin; b < end; ++b) {
      geometry.set_pulse(pulse_of(rows, b, rows.band->waveform().burst_pulses() / 2));
      const radar::Pointing pointing = geometry.pointing();
      for (std::size_t t = 0; t < targets; t += targets / max_targets + 1) {
        const double amplitude = geometry.view(t, pointing).amplitude_sqrt_w;
        power[b] = std::max(power[b], amplitude * amplitude);
      }
      // Surfaces alone, or nothing: all bursts count the same.
      if (targets == 0) power[b] = 1.0;
    }
  });
  return power;
}

double fastest_searched_mps(const SteppedRows& rows) {
  const std::size_t pulses = rows.band->waveform().burst_pulses();
  const double span_s = rows.pulse_time_s(pulses - 1) - rows.pulse_time_s(0);
  return span_s > 0.0 ? 0.5 * signal::max_searched_speeds * signal::first_speed_step_mps(*rows.band, span_s)
                      : std::numeric_limits<double>::infinity();
}

double mean_speed_mps(const SteppedRows& rows, std::size_t first, std::size_t count) {
  constexpr std::size_t max_looks = 17;
  const std::size_t looks = std::min(count, max_looks);
  simulate::PulseGeometry geometry(*rows.acquisition->scene, rows.acquisition->link);
  double power = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < looks; ++i) {
    const std::size_t burst = first + (looks > 1 ? i * (count - 1) / (looks - 1) : 0);
    geometry.set_pulse(pulse_of(rows, burst, rows.band->waveform().burst_pulses() / 2));
    simulate::each_sampled_view(*rows.acquisition->scene, geometry, max_targets,
                                [&](const simulate::ScattererView& view) {
                                  const double weight = view.amplitude_sqrt_w * view.amplitude_sqrt_w;
                                  power += weight;
                                  sum += weight * view.speed_mps;
                                });
  }
  return power > 0.0 ? sum / power : 0.0;
}

std::optional<std::size_t> platform_of_targets(const simulate::Acquisition& acquisition) {
  std::vector<double> rcs_m2(acquisition.scene->platforms.size());
  for (const simulate::Scatterer& s : acquisition.scene->scatterers) rcs_m2[s.platform] += s.rcs_m2;
  for (const simulate::ScattererSheet& sheet : acquisition.scene->sheets)
    rcs_m2[sheet.platform] += sheet.point_rcs_m2 * static_cast<double>(sheet.points_m.size());
  rcs_m2[acquisition.link.platform] = 0.0;
  const auto strongest = std::ranges::max_element(rcs_m2);
  if (strongest == rcs_m2.end() || !(*strongest > 0.0)) return std::nullopt;
  return static_cast<std::size_t>(strongest - rcs_m2.begin());
}

std::vector<double> aspects_rad(const SteppedRows& rows, const ProfileSeries& series) {
  const simulate::Acquisition& acquisition = *rows.acquisition;
  const std::optional<std::size_t> platform = platform_of_targets(acquisition);
  if (!platform) return {};
  std::vector<double> aspects;
  for (const ProfileRow& row : series.rows) {
    const std::int64_t pulse = pulse_of(rows, row.burst, 0);
    const radar::Pose target = acquisition.scene->platforms[*platform].track.at(row.time_s, pulse);
    const radar::Pose radar = acquisition.scene->platforms[acquisition.link.platform].track.at(row.time_s, pulse);
    const core::Vec3 sight =
        core::transposed(target.world_from_platform) * (radar.position_world_m - target.position_world_m);
    const double angle = std::atan2(sight.y, sight.x);
    const double before = aspects.empty() ? angle : aspects.back();
    aspects.push_back(before + std::remainder(angle - before, 2.0 * core::pi));
  }
  return aspects;
}

std::vector<signal::TrackPoint> seen_from_platform(const SteppedRows& rows, std::size_t platform, std::size_t first,
                                                   std::size_t count) {
  const simulate::Acquisition& acquisition = *rows.acquisition;
  const std::size_t per_burst = rows.band->waveform().burst_pulses();
  signal::SarEchoes echoes;
  std::vector<signal::TargetPose> poses;
  for (std::size_t p = 0; p < count * per_burst; ++p) {
    const std::int64_t pulse = pulse_of(rows, first, p);
    const double time_s = acquisition.link.repetition.send_time_s(pulse);
    const radar::Pose radar = acquisition.scene->platforms[acquisition.link.platform].track.at(time_s, pulse);
    const radar::Pose target = acquisition.scene->platforms[platform].track.at(time_s, pulse);
    echoes.track.push_back({time_s, radar.position_world_m, radar.velocity_world_mps});
    poses.push_back(
        {target.position_world_m, target.velocity_world_mps, target.world_from_platform, turn_rate_radps(target)});
  }
  return signal::seen_from_target(echoes, poses).track;
}

}  // namespace sarsim::workflow
