#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

/// The compressed echo of one point, sampled finely about its peak.
struct Response {
  std::vector<double> amplitude;  ///< Magnitudes over the raw echo's amplitude.
  std::size_t peak = 0;
  double step_s = 0.0;  ///< Two-way time between samples.

  [[nodiscard]] double delay_s(std::size_t i) const {
    return (static_cast<double>(i) - static_cast<double>(peak)) * step_s;
  }
};

/// A parabola through three neighbouring values about `i`: its largest value.
inline double parabola_top(const std::vector<double>& y, std::size_t i) {
  const double bend = y[i - 1] - 2.0 * y[i] + y[i + 1];
  const double slope = 0.5 * (y[i + 1] - y[i - 1]);
  return bend == 0.0 ? y[i] : y[i] - 0.5 * slope * slope / bend;
}

/// Highest side lobe beyond the first minimum after the peak, in dB of the peak.
inline double side_lobe_db(const Response& r) {
  std::size_t i = r.peak;
  while (r.amplitude[i + 1] < r.amplitude[i]) ++i;
  std::size_t top = i;
  for (; i + 1 < r.amplitude.size(); ++i)
    if (r.amplitude[i] > r.amplitude[top]) top = i;
  return 20.0 * std::log10(parabola_top(r.amplitude, top) / r.amplitude[r.peak]);
}

/// Width at half power [s], crossings by straight lines in power between fine samples.
inline double half_power_width_s(const Response& r) {
  const auto power = [&](std::size_t i) { return r.amplitude[i] * r.amplitude[i]; };
  const double half = 0.5 * power(r.peak);
  std::size_t right = r.peak;
  while (power(right) > half) ++right;
  std::size_t left = r.peak;
  while (power(left) > half) --left;
  const double right_s = r.delay_s(right) - r.step_s * (half - power(right)) / (power(right - 1) - power(right));
  const double left_s = r.delay_s(left) + r.step_s * (half - power(left)) / (power(left + 1) - power(left));
  return right_s - left_s;
}

/// Compresses the echo of a point that stands `margin` samples into the window, at the scene's sampling rate, through
/// the whole recording path. The scene's radar and its simulation's sampling rate decide; its targets are replaced.
inline Response point_response(scene::Scene scene, std::size_t margin) {
  const double light_speed_mps = simulate::make_plan(
                                     [&] {
                                       scene::Scene any = scene;
                                       set_window(any, 0.0, 1000.0, 1e6);
                                       any.simulations[0].processing = scene::Processing::raw;
                                       return any;
                                     }(),
                                     0)
                                     .acquisition.scene->conventions.light_speed_mps;
  const double spacing_m = 0.5 * light_speed_mps / scene.simulations[0].sample_rate_hz;
  const double start_m = 1000.0;
  scene.targets.clear();
  add_target(scene, {start_m + static_cast<double>(margin) * spacing_m, 0.0, 0.0});
  scene.simulations[0].range_start_m = start_m;
  scene.simulations[0].range_end_m = start_m + static_cast<double>(2 * margin + 1) * spacing_m;
  scene.simulations[0].processing = scene::Processing::raw;
  const double raw_v = recorded(scene).report.maximum_v;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const auto samples = recorded(scene).samples;
  Response response;
  for (const auto& sample : samples) response.amplitude.push_back(std::abs(sample) / raw_v);
  response.peak = margin;
  response.step_s = 1.0 / scene.simulations[0].sample_rate_hz;
  return response;
}

}  // namespace sarsim::workflow::verify
