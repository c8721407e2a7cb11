#include "workflow/focus/matched_filter_coverage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace recorded_gain_test {

const signal::WindowFunction even = [](double) { return 1.0; };

// 120 samples of a chirp of 800 ns in rows of 200.
double delay_of_sample(const simulate::Acquisition& acquisition, double sample) {
  return acquisition.reception.raw_grid.first_s + acquisition.reception.pulse.lead_s +
         sample * acquisition.reception.raw_grid.interval_s;
}

TEST(MatchedFilterCoverage, IsOneForEchoesThatAreWhole) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene::Scene scene = sar_scene(600.0, {}, 0.1);
    scene.simulations[0].pulse_position = position;
    const simulate::Acquisition acquisition = simulate::acquisition_of(scene, 0);
    const MatchedFilterCoverage gain(acquisition, acquisition.reception.columns, even);
    for (const double sample : {0.0, 17.3, 79.0}) {
      EXPECT_NEAR(gain.share(delay_of_sample(acquisition, sample)), 1.0, 1e-12) << sample;
      EXPECT_EQ(gain.gain(delay_of_sample(acquisition, sample)), 1.0);
      EXPECT_NEAR(gain.noise(delay_of_sample(acquisition, sample)), 1.0, 1e-12);
    }
  }
}

TEST(MatchedFilterCoverage, FallsOverTheLastPulseOfARawRowAndIsNoneOutside) {
  const simulate::Acquisition acquisition = simulate::acquisition_of(sar_scene(600.0, {}, 0.1), 0);
  ASSERT_EQ(acquisition.reception.columns, 200U);
  const MatchedFilterCoverage gain(acquisition, acquisition.reception.columns, even);
  // 60 of 120 samples are left from sample 140 on.
  EXPECT_NEAR(gain.share(delay_of_sample(acquisition, 140.0)), 0.5, 1e-9);
  EXPECT_NEAR(gain.noise(delay_of_sample(acquisition, 140.0)), 0.5, 1e-9);
  EXPECT_NEAR(gain.share(delay_of_sample(acquisition, 199.0)), 1.0 / 120.0, 1e-9);
  EXPECT_EQ(gain.share(delay_of_sample(acquisition, 200.0)), 0.0);
  EXPECT_EQ(gain.share(delay_of_sample(acquisition, -1.0)), 0.0);
  EXPECT_NEAR(gain.last_whole_s(), delay_of_sample(acquisition, 80.0), 1e-15);
  // Under a triangle a quarter of the pulse holds an eighth of the weights.
  const MatchedFilterCoverage tapered(acquisition, acquisition.reception.columns,
                                      [](double x) { return 1.0 - std::abs(2.0 * x - 1.0); });
  EXPECT_NEAR(tapered.share(delay_of_sample(acquisition, 170.0)), 0.125, 0.005);
}

TEST(MatchedFilterCoverage, OfCompressedRowsIsOneToTheirEnd) {
  scene::Scene scene = sar_scene(600.0, {}, 0.1);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const simulate::Acquisition acquisition = simulate::acquisition_of(scene, 0);
  const MatchedFilterCoverage gain(acquisition, acquisition.reception.columns, even);
  EXPECT_NEAR(gain.share(delay_of_sample(acquisition, 199.0)), 1.0, 1e-12);
  EXPECT_EQ(gain.share(delay_of_sample(acquisition, 200.0)), 0.0);
  EXPECT_NEAR(gain.held(delay_of_sample(acquisition, 259.0)), 0.5, 0.01);
  EXPECT_NEAR(gain.last_whole_s(), delay_of_sample(acquisition, 199.0), 1e-15);
}

TEST(MatchedFilterCoverage, IsTheMeanOfTheReceiversGainOverTheEcho) {
  scene::Scene scene = sar_scene(600.0, {}, 0.1);
  scene.radars[0].stc = scene::Radar::Stc::range_law;
  const simulate::Acquisition acquisition = simulate::acquisition_of(scene, 0);
  ASSERT_FALSE(acquisition.reception.stc_gain.empty());
  const MatchedFilterCoverage gain(acquisition, acquisition.reception.columns, even);
  // R^2 at the ranges of an echo's 120 samples, their mean: with s the spacing, R^2 + 119 R s + 119 239/6 s^2.
  const double spacing_m = 0.5 * core::exact_light_speed_mps / 150e6;
  const double range_m = 10098.0 + 10.0 * spacing_m;
  const double mean = range_m * range_m + 119.0 * range_m * spacing_m + 119.0 * 239.0 / 6.0 * spacing_m * spacing_m;
  EXPECT_NEAR(gain.gain(delay_of_sample(acquisition, 10.0)) / mean, 1.0, 1e-9);
  EXPECT_NEAR(gain.noise(delay_of_sample(acquisition, 10.0)) / (mean * mean), 1.0, 1e-4);
}

}  // namespace recorded_gain_test
}  // namespace sarsim::workflow
