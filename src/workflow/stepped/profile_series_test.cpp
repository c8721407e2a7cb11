#include "workflow/stepped/profile_series.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "workflow/stepped/stepped_test_scene.hpp"

namespace sarsim::workflow {
namespace profile_series_test {

constexpr double c = core::exact_light_speed_mps;

// Pulses of 30 m, samples 15 m apart over 126 m: eight of them.
scene::Scene short_scene(scene::Simulation::PulsePosition position) {
  scene::Scene scene = stepped_scene();
  scene.targets.push_back(simulate::target_on("Earth", {1000.0, 0.0, 0.0}));
  scene::Simulation& simulation = scene.simulations[0];
  simulation.range_start_m = 950.0;
  simulation.range_end_m = 1076.0;
  simulation.pulse_position = position;
  return scene;
}

SteppedRows recorded(const scene::Scene& scene) {
  return stepped_rows_of_recording(std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0)),
                                   {});
}

double last_sample_m(const SteppedRows& rows) {
  const signal::SteppedWaveform& w = rows.band->waveform();
  return 0.5 * c * (w.first_sample_s + (static_cast<double>(w.samples) - 1.0) / w.sample_rate_hz);
}

TEST(ShownRanges, OfARecordingEndWithTheEchoThatTheLastSampleHoldsTheBeginningOf) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    const SteppedRows rows = recorded(short_scene(position));
    const RangeResampling shown = shown_ranges(rows);
    const double ahead_m = position == scene::Simulation::PulsePosition::centre ? 0.25 * c * 200e-9 : 0.0;
    EXPECT_EQ(shown.from_m, 950.0);
    EXPECT_NEAR(shown.to_m, last_sample_m(rows) + ahead_m, 1e-6);
    EXPECT_LT(shown.to_m, 1075.0);
    const signal::ProfileAxis axis = signal::ProfileMaker(*rows.band, {}, shown.from_m, shown.to_m, 4).axis();
    for (std::size_t k = 0; k < axis.count; ++k)
      EXPECT_LT(rows.band->gate_of(2.0 * axis.at(static_cast<double>(k)) / c), rows.band->gates()) << k;
    EXPECT_EQ(rows.band->gate_of(2.0 * (shown.to_m + 0.1) / c), rows.band->gates());
  }
}

TEST(ShownRanges, OfASceneAreAllOfItsWindow) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene::Scene scene = short_scene(position);
    const simulate::Acquisition window = simulate::acquisition_of(scene, 0);
    scene.simulations[0] = recorded_for_stepped(scene.simulations[0], window);
    const SteppedRows rows = stepped_rows_of_scene(
        std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0)), window);
    const RangeResampling shown = shown_ranges(rows);
    EXPECT_EQ(shown.from_m, 950.0);
    EXPECT_EQ(shown.to_m, 1076.0);
  }
}

TEST(ShownRanges, AreNoneWhereNoChirpIsRecordedByHalf) {
  scene::Scene scene = short_scene(scene::Simulation::PulsePosition::begin);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 6e6;
  scene.radars[0].pulse_width_s = 10e-6;
  const SteppedRows rows = recorded(scene);
  const RangeResampling shown = shown_ranges(rows);
  EXPECT_LT(shown.to_m, shown.from_m);
}

}  // namespace profile_series_test
}  // namespace sarsim::workflow
