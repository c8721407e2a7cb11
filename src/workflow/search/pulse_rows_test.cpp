#include "workflow/search/pulse_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "simulate/run/computed_rows.hpp"
#include "workflow/search/search_test_scene.hpp"

namespace sarsim::workflow {
namespace pulse_rows_test {

std::vector<std::complex<float>> row_of(const PulseRows& rows, std::size_t pulse) {
  std::vector<std::complex<float>> row(rows.samples());
  rows.read(pulse, row);
  return row;
}

// The rows of a recording that a run of the scene would have made.
PulseRows recorded(const scene::Scene& scene) {
  const auto acquisition = std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0));
  return pulse_rows_of_recording(acquisition, simulate::computed_rows(acquisition));
}

std::size_t peak_of(const std::vector<std::complex<float>>& row) {
  return static_cast<std::size_t>(std::ranges::max_element(row, {}, [](std::complex<float> v) { return std::abs(v); }) -
                                  row.begin());
}

TEST(PulseRows, OfARawRecordingAreThoseOfTheSceneWhereverThePulseLies) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene::Scene scene = pulse_scene(12.0, 4);
    scene.simulations[0].pulse_position = position;
    scene.simulations[0].range_start_m = 3000.0;
    scene.simulations[0].range_end_m = 8000.0;
    const PulseRows of_scene = pulse_rows_of(scene);
    const PulseRows of_data = recorded(scene);
    ASSERT_EQ(of_scene.samples(), of_data.samples());
    const auto expected = row_of(of_scene, 3);
    const auto got = row_of(of_data, 3);
    const std::size_t from = peak_of(expected);
    const std::size_t at = peak_of(got);
    // A centred pulse lies half a pulse elsewhere in the raw row: the ranges say so.
    EXPECT_NEAR(of_data.range_m[at], of_scene.range_m[from], 6.1);
    EXPECT_NEAR(of_scene.range_m[from], 5000.0, 12.0);
    if (position == scene::Simulation::PulsePosition::centre) continue;
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_LT(std::abs(got[i] - expected[i]), 1e-4F * std::abs(expected[from])) << i;
  }
}

TEST(PulseRows, OfACompressedRecordingAreTheRecording) {
  scene::Scene scene = pulse_scene(0.0, 2);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  EXPECT_EQ(row_of(recorded(scene), 1), row_of(pulse_rows_of(scene), 1));
}

TEST(PulseRows, KnowTheHeightOfAPeakInEitherProfile) {
  for (const scene::Profile profile : {scene::Profile::physical, scene::Profile::classic}) {
    scene::Scene scene = pulse_scene(0.0, 1);
    scene.options.profile = profile;
    // On the sampling grid, where the peak is not between two samples.
    scene.simulations[0].range_start_m = 5000.0 - 25.0 * 0.5 * core::exact_light_speed_mps / 12.5e6;
    const PulseRows rows = pulse_rows_of(scene);
    const auto row = row_of(rows, 0);
    const double echo_v = simulate::equation_amplitude(5000.0, 1.0, core::exact_light_speed_mps / 10e9);
    EXPECT_NEAR(static_cast<double>(std::abs(row[peak_of(row)])) / (rows.peak_gain * echo_v), 1.0, 0.01);
  }
}

TEST(PulseRows, KnowThePowerOfTheirNoise) {
  scene::Scene scene = pulse_scene(0.0, 200);
  scene.targets.clear();
  scene.radars[0].noise_temperature_k = 290.0;
  const PulseRows rows = pulse_rows_of(scene);
  double power = 0.0;
  double count = 0.0;
  for (std::size_t p = 0; p < rows.pulses(); ++p)
    for (const std::complex<float> value : row_of(rows, p)) {
      power += static_cast<double>(std::norm(value));
      count += 1.0;
    }
  // Neighbours are correlated over at most two samples.
  EXPECT_NEAR(power / count / rows.noise_w, 1.0, 5.0 * std::sqrt(2.0 / count));
  EXPECT_EQ(recorded(scene).noise_w, rows.noise_w);
}

TEST(PulseRows, RefuseWhatHoldsNone) {
  scene::Scene scene = pulse_scene(0.0, 2);
  EXPECT_THROW(
      (void)pulse_rows_of_scene(std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0))),
      std::invalid_argument);
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_steps = 2;
  scene.radars[0].pulses_per_step = 1;
  scene.simulations[0].processing = scene::Processing::srp;
  const auto acquisition = std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0));
  EXPECT_THROW((void)pulse_rows_of_recording(acquisition, {}), std::invalid_argument);
}

}  // namespace pulse_rows_test
}  // namespace sarsim::workflow
