#include "simulate/run.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "base/constants.hpp"
#include "simulate/memory_sink.hpp"

namespace sarsim {
namespace {

// Radar at the origin, one target on the x axis, one pulse at t = 0.
Scene one_target(double distance_m) {
  Scene scene;
  scene.platforms.push_back({});
  Radar radar;
  radar.pulse_width_s = 5e-6;
  scene.radars.push_back(radar);
  Target target;
  target.position_m = {distance_m, 0.0, 0.0};
  scene.targets.push_back(target);
  Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 0.0;
  simulation.range_end_m = 2000.0;
  simulation.time_end_s = 0.0;
  simulation.sample_rate_hz = 4e6;
  scene.simulations.push_back(simulation);
  return scene;
}

Recording recorded(const Scene& scene, unsigned threads = 1) {
  RunControl control;
  control.threads = threads;
  return record(make_plan(scene, 0), control);
}

double equation_amplitude(double distance_m, double rcs_m2, double wavelength_m) {
  return std::sqrt(1000.0 * wavelength_m * wavelength_m * rcs_m2 /
                   (std::pow(4.0 * pi, 3.0) * std::pow(distance_m, 4.0)));
}

TEST(Run, MonochromeEchoHasTheRadarEquationsAmplitudeAndTheTwoWayPhase) {
  const Recording sink = recorded(one_target(1000.0));
  const double wavelength_m = exact_light_speed_mps / 1e9;
  const std::complex<double> expected =
      std::polar(equation_amplitude(1000.0, 1.0, wavelength_m), -4.0 * pi * 1000.0 / wavelength_m);
  const double delay_samples = 2.0 * 1000.0 / exact_light_speed_mps * 4e6;
  ASSERT_EQ(sink.samples.size(), 53u);
  for (std::size_t i = 0; i < sink.samples.size(); ++i) {
    const bool on = static_cast<double>(i) >= delay_samples && static_cast<double>(i) < delay_samples + 20.0;
    EXPECT_LT(std::abs(sink.samples[i] - (on ? expected : 0.0)), 1e-9 * std::abs(expected)) << i;
  }
}

TEST(Run, SameSamplesForAnyNumberOfThreads) {
  Scene scene = one_target(1000.0);
  scene.simulations[0].time_end_s = 2.0;
  scene.radars[0].noise_temperature_k = 300.0;
  const Recording one = recorded(scene, 1);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const Recording many = recorded(scene, threads);
    EXPECT_EQ(many.samples, one.samples) << threads;
    EXPECT_EQ(many.report.maximum_v, one.report.maximum_v);
  }
}

}  // namespace
}  // namespace sarsim
