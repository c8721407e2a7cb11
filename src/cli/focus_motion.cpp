#include "cli/focus_motion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "process/motion_compensation.hpp"
#include "process/reference_track.hpp"
#include "simulate/sar_rows.hpp"

namespace sarsim::cli {

std::string to_string(MotionOrder order) {
  if (order == MotionOrder::none) return "none";
  return order == MotionOrder::first ? "first" : "second";
}

bool wants_compensation(const EchoRows& echoes, const FocusOptions& options) {
  return std::ranges::any_of(problems_of_focusing(echoes, options),
                             [](const Problem& problem) { return problem.subject.field == track_field; });
}

void compensate(FocusInput& input, MotionOrder order, std::optional<double> ground_m, FocusOptions& options,
                const WorkControl& control, const ProgressReport& progress) {
  if (order == MotionOrder::none) return;
  constexpr double most_uneven = 0.02;
  MotionCompensation how;
  how.reference = fitted_track(input.echoes.track);
  const double speed_mps = norm(how.reference.velocity_mps);
  const double uneven = speed_mps > 0.0 ? unevenness(input.echoes.track, how.reference) : 0.0;
  if (uneven > most_uneven)
    throw BadInput(
        fmt::format(
            "the distance between pulses changes by up to {:.3g} % from one to the next: no motion compensation "
            "can interpolate between them",
            100.0 * uneven),
        fmt::format("expected up to {:.0f} %; use --algorithm back-projection", 100.0 * most_uneven));
  const SarWaveform& wave = input.echoes.waveform;
  const double sine = 0.5 * wave.light_speed_mps / (wave.carrier_hz * speed_mps) * options.doppler_centroid_hz;
  how.squint_rad = std::asin(std::clamp(sine, -0.999, 0.999));
  how.scene_m = scene_middle_m(*input.plan);
  if (ground_m) how.scene_m.z = *ground_m;
  how.second_order = order == MotionOrder::second;
  options.memory_bytes /= 2;
  input.echoes =
      compensate_motion(input.echoes, how, {options.memory_bytes, options.scratch_folder}, control, progress);
}

}  // namespace sarsim::cli
