// Synthetic range profiles of a point target.

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.hpp"

namespace sarsim {
namespace profile_test {

constexpr int steps = 64;
constexpr double step_hz = 1e6;

// Two bursts of 64 steps with two pulses each, one range gate at 1000 m.
scene::Scene stepped_scene(double range_m) {
  scene::Scene scene = test::radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.pulse_width_s = 1e-6;
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_hz = 10e9;
  radar.carrier_step_hz = step_hz;
  radar.carrier_steps = steps;
  radar.pulses_per_step = 2;
  test::add_target(scene, {range_m, 0.0, 0.0});
  test::set_window(scene, 1000.0, 1000.0 + 0.5 * core::exact_light_speed_mps / 1e6, 1e6);
  test::set_pulses(scene, 0, 4 * steps - 1);
  scene.simulations[0].processing = scene::Processing::srp;
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  return scene;
}

TEST(RangeProfile, PutsATargetIntoItsBinWithItsAmplitudeAndItsPhaseAtTheFirstCarrier) {
  const double bin_m = 0.5 * core::exact_light_speed_mps / (steps * step_hz);
  for (const int bin : {0, 1, 20, 31}) {
    const double range_m = 1000.0 + bin * bin_m;
    const simulate::Recording recording = test::recorded(stepped_scene(range_m));
    ASSERT_EQ(recording.report.rows, 2u);
    ASSERT_EQ(recording.report.columns, static_cast<std::size_t>(steps));
    // The amplitude follows each step's wavelength; the peak is their mean.
    double amplitude_v = 0.0;
    for (int n = 0; n < steps; ++n)
      amplitude_v += std::sqrt(1000.0) * core::exact_light_speed_mps / (10e9 + n * step_hz) /
                     (std::pow(4.0 * core::pi, 1.5) * range_m * range_m) / steps;
    const double cycles = 2.0 * range_m * 10e9 / core::exact_light_speed_mps;
    const std::complex<double> expected = std::polar(amplitude_v, -2.0 * core::pi * std::remainder(cycles, 1.0));
    for (std::size_t row = 0; row < 2; ++row) {
      const auto peak = recording.samples[row * steps + static_cast<std::size_t>(bin)];
      EXPECT_LT(std::abs(peak - expected), 1e-9 * amplitude_v) << bin;
      // Elsewhere only what the amplitude's slope of 0.6 % over the burst leaves.
      for (std::size_t k = 0; k < steps; ++k)
        if (k != static_cast<std::size_t>(bin)) {
          EXPECT_LT(std::abs(recording.samples[row * steps + k]), 0.0064 * amplitude_v) << k;
        }
    }
  }
}

TEST(RangeProfile, LeavesIncompleteBurstsOut) {
  scene::Scene scene = stepped_scene(1000.0);
  test::set_pulses(scene, 5, 4 * steps + 7);
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  EXPECT_EQ(plan.acquisition.timing.rows, 1u);
  EXPECT_EQ(plan.acquisition.timing.dropped_pulses, 4 * steps + 3 - 2 * steps);
}

}  // namespace profile_test
}  // namespace sarsim
