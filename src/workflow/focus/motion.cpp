#include "workflow/focus/motion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/motion_compensation.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/sar_rows.hpp"

namespace sarsim::workflow {

namespace {

// Otherwise nothing says from where the echoes came.
void expect_ground_in_reach(const signal::EchoRows& echoes, const signal::MotionCompensation& how) {
  const signal::GroundSight sight(how.reference, how.scene_m, how.squint_rad);
  if (core::norm(core::cross(sight.ahead(), {0.0, 0.0, 1.0})) < 1e-6)
    return;  // straight up or down: it has no use for the ground
  const signal::SarWaveform& wave = echoes.waveform;
  const double last_s = echoes.first_delay_s + static_cast<double>(echoes.columns) / wave.sample_rate_hz;
  const double last_m = radar::range_of(last_s, wave.light_speed_mps);
  const auto reaches = [&](const signal::TrackPoint& point) {
    const core::Vec3 ground_m = sight.point_at(sight.foot_of(point.position_m), last_m);
    return std::abs(ground_m.z - how.scene_m.z) < 1e-6 * last_m;
  };
  if (reaches(echoes.track.front()) || reaches(echoes.track.back())) return;
  throw core::InvalidRequest("motion compensation: the ground is beyond all ranges of the recording",
                             "give the ground another --height, or leave it out with --motion-compensation none");
}

}  // namespace

std::string to_string(MotionOrder order) {
  if (order == MotionOrder::none) return "none";
  return order == MotionOrder::first ? "first" : "second";
}

bool wants_compensation(const core::Problems& problems) {
  return std::ranges::any_of(problems,
                             [](const core::Problem& problem) { return problem.subject.field == signal::track_field; });
}

void expect_one_way(const signal::EchoRows& echoes) {
  const signal::ReferenceTrack line = signal::fitted_track(echoes.track);
  if (core::norm(line.velocity_mps) > 0.0 && std::isinf(signal::unevenness(echoes.track, line)))
    throw core::InvalidRequest(
        "the antenna reverses along its track: motion compensation cannot put its pulses in azimuth order",
        "use --algorithm back-projection");
}

signal::MotionCompensation compensation_of(const FocusInput& input, MotionOrder order, std::optional<double> ground_m,
                                           const signal::FocusOptions& options) {
  signal::MotionCompensation how;
  how.reference = signal::fitted_track(input.echoes.track);
  const signal::SarWaveform& wave = input.echoes.waveform;
  const double speed_mps = core::norm(how.reference.velocity_mps);
  const double sine =
      radar::range_of_cycle(wave.carrier_hz * speed_mps, wave.light_speed_mps) * options.doppler_centroid_hz;
  how.squint_rad = std::asin(std::clamp(sine, -0.999, 0.999));
  how.scene_m = scene_middle_m(*input.acquisition);
  if (ground_m) how.scene_m.z = *ground_m;
  how.second_order = order == MotionOrder::second;
  expect_ground_in_reach(input.echoes, how);
  return how;
}

void compensate(FocusInput& input, MotionOrder order, std::optional<double> ground_m,
                const signal::FocusOptions& options, const core::WorkControl& control,
                const core::ProgressReport& progress) {
  if (order == MotionOrder::none) return;
  const signal::MotionCompensation how = compensation_of(input, order, ground_m, options);
  const double speed_mps = core::norm(how.reference.velocity_mps);
  const double uneven = speed_mps > 0.0 ? signal::unevenness(input.echoes.track, how.reference) : 0.0;
  expect_one_way(input.echoes);
  if (uneven > max_uneven)
    throw core::InvalidRequest(
        fmt::format("the along-track pulse spacing changes by up to {:.3g} % from one to the next: motion compensation "
                    "cannot resample them",
                    100.0 * uneven),
        fmt::format("expected up to {:.0f} %; use --algorithm back-projection", 100.0 * max_uneven));
  input.echoes = signal::compensate_motion(input.echoes, how, {options.memory_bytes / 2, options.scratch_folder},
                                           control, progress);
}

}  // namespace sarsim::workflow
