#include "simulate/plan/range_ambiguities.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/turns.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "support/processor_time.hpp"

namespace sarsim::simulate {
namespace other_pulses_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double c = core::exact_light_speed_mps;

// 10 us at 10 GHz, 1 kHz (149.9 km), 40 to 60 km at 1 MHz, isotropic: 1 m2 at 50 km, 1e4 m2 at 203 km, whose echo of
// the pulse before arrives like one from 53.1 km.
scene::Scene second_time_around() {
  scene::Scene scene;
  scene.platforms.push_back(resting("Earth", {}));
  scene.targets.push_back(target_on("Earth", {0.0, 50e3, 0.0}));
  scene.targets.push_back(target_on("Earth", {0.0, 203e3, 0.0}, 1e4));
  scene::Radar radar;
  radar.pulse_width_s = 10e-6;
  radar.carrier_hz = 10e9;
  radar.prf_hz = 1000.0;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = radar.name;
  simulation.range_start_m = 40e3;
  simulation.range_end_m = 60e3;
  simulation.time_start_s = -1e-3;
  simulation.time_end_s = 2e-3;
  simulation.sample_rate_hz = 1e6;
  scene.simulations.push_back(simulation);
  return scene;
}

std::vector<std::int64_t> pulses_back(const scene::Scene& scene) {
  std::vector<std::int64_t> back;
  for (const RangeAmbiguity& other : make_plan(scene, 0).sources.range_ambiguities.pulses) back.push_back(other.back);
  return back;
}

std::vector<std::complex<double>> recorded(const scene::Scene& scene, Engine engine) {
  raster::RunControl control;
  control.threads = 1;
  return record(make_plan(scene, 0, nullptr, engine), control).samples;
}

// The echo of a resting target in one sample of a row.
std::complex<double> echo_of(double distance_m, double rcs_m2, double carrier_hz) {
  return equation_amplitude(distance_m, rcs_m2, c / carrier_hz) *
         core::turned_exactly(-2.0 * distance_m * carrier_hz / c);
}

std::size_t column_at(double range_m) { return static_cast<std::size_t>(std::ceil((range_m - 40e3) / (c / 2e6))); }

// Amplitude by the radar equation over the whole way, phase of the whole delay, place by what is left of it.
TEST(RangeAmbiguities, AreRecordedByEveryEngineWhereTheyArrive) {
  const scene::Scene scene = second_time_around();
  const std::complex<double> own = echo_of(50e3, 1.0, 10e9);
  const std::complex<double> before = echo_of(203e3, 1e4, 10e9);
  EXPECT_NEAR(std::abs(before) / std::abs(own), 6.067, 1e-3);
  for (const Engine engine : {Engine::reference, Engine::direct, Engine::spectral}) {
    const auto samples = recorded(scene, engine);
    const std::size_t columns = samples.size() / 4;
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t i = 0; i < columns; ++i) {
        std::complex<double> expected;
        if (i >= column_at(50e3) && i < column_at(50e3) + 10) expected = own;
        const std::size_t late = column_at(203e3 - 0.5e-3 * c);
        if (i >= late && i < late + 10) expected = before;
        ASSERT_LT(std::abs(samples[row * columns + i] - expected), 1e-6 * std::abs(before)) << row << " " << i;
      }
  }
}

TEST(RangeAmbiguities, AreLeftOutWhereAskedAndByTheConventionsOf1998) {
  scene::Scene scene = second_time_around();
  EXPECT_THAT(pulses_back(scene), ElementsAre(1));
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::none;
  EXPECT_THAT(pulses_back(scene), IsEmpty());
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::all;
  scene.options.profile = scene::Profile::classic;
  EXPECT_THAT(pulses_back(scene), IsEmpty());
}

// (50/203)^4 is -24.34 dB.
TEST(RangeAmbiguities, CountFromMinusSixtyDecibels) {
  scene::Scene scene = second_time_around();
  for (const double db : {-60.1, -59.9}) {
    scene.targets[1].rcs_m2 = std::pow(10.0, 0.1 * (db + 24.3406));
    scene.options.ambiguous_echoes = scene::AmbiguousEchoes::strong;
    EXPECT_EQ(pulses_back(scene).size(), db > -60.0 ? 1u : 0u) << db;
    scene.options.ambiguous_echoes = scene::AmbiguousEchoes::all;
    const std::vector<RangeAmbiguity> all = make_plan(scene, 0).sources.range_ambiguities.pulses;
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(20.0 * std::log10(all[0].strength), db, 1e-3);
  }
}

TEST(RangeAmbiguities, SentLaterAreHeardFromNearer) {
  scene::Scene scene = second_time_around();
  scene.simulations[0].range_start_m = 195e3;
  scene.simulations[0].range_end_m = 205e3;
  EXPECT_THAT(pulses_back(scene), ElementsAre(-1));  // 50 km, an interval later
  scene.simulations[0].range_start_m = 40e3;
  EXPECT_THAT(pulses_back(scene), ElementsAre(-1, 1));
}

TEST(RangeAmbiguities, OfASatelliteAreHeardOnlyFromOtherRanges) {
  scene::Scene scene = second_time_around();
  scene.platforms.push_back(moving("Satellite", {0.0, 0.0, 0.0}, {7500.0, 0.0, 0.0}));
  scene.radars[0].platform = "Satellite";
  scene.radars[0].prf_hz = 3000.0;  // 49.97 km
  scene.targets = {target_on("Earth", {0.0, 800e3, 0.0})};
  scene.simulations[0].range_start_m = 795e3;
  scene.simulations[0].range_end_m = 806e3;
  scene.simulations[0].time_start_s = scene.simulations[0].time_end_s = 0.0;
  EXPECT_THAT(pulses_back(scene), IsEmpty());
  scene.targets.push_back(target_on("Earth", {0.0, 800e3 + 3.0 * c / 6000.0, 0.0}));
  scene.targets.push_back(target_on("Earth", {0.0, 800e3 - 2.0 * c / 6000.0, 0.0}));
  EXPECT_THAT(pulses_back(scene), ElementsAre(-2, 3));
}

// Intervals of 1 and 1.2 ms in turn: the target at 50 + 149.9 or 179.9 km arrives in every second row only.
TEST(RangeAmbiguities, FollowEachIntervalOfAStaggeredPrf) {
  scene::Scene scene = second_time_around();
  scene.radars[0].repetition = scene::Radar::Repetition::user;
  scene.radars[0].pri_s.part[0].knots = {{0, 1e-3}, {0, 1.2e-3}};
  scene.simulations[0].time_start_s = 0.0;
  scene.simulations[0].time_end_s = 3.5e-3;
  scene.targets[1].position_m.y = 50e3 + 0.6e-3 * c;
  EXPECT_THAT(pulses_back(scene), ElementsAre(1));
  const auto samples = recorded(scene, Engine::reference);
  const std::size_t columns = samples.size() / 4;
  for (std::size_t row = 0; row < 4; ++row) {
    const std::complex<double> found = samples[row * columns + column_at(50e3) + 5];
    std::complex<double> expected = echo_of(50e3, 1.0, 10e9);
    if (row % 2 == 0) expected += echo_of(50e3 + 0.6e-3 * c, 1e4, 10e9);
    EXPECT_LT(std::abs(found - expected), 3e-8 * std::abs(expected)) << row;  // of 1.2e7 turns in double
  }
}

// The carriers of successive pulses differ by 0.2 MHz: the echo of the pulse before beats, from the pulse's middle.
TEST(RangeAmbiguities, OfAnotherCarrierBeatAgainstTheRows) {
  scene::Scene scene = second_time_around();
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 0.2e6;
  scene.radars[0].carrier_steps = 2;
  scene.radars[0].pulses_per_step = 1;
  for (const Engine engine : {Engine::reference, Engine::direct}) {
    const auto samples = recorded(scene, engine);
    const std::size_t columns = samples.size() / 4;
    const std::size_t first = column_at(203e3 - 0.5e-3 * c);
    for (std::size_t i = first; i < first + 10; ++i) {
      const double after_middle_s = 2.0 * 40e3 / c + static_cast<double>(i) * 1e-6 - 5e-6;
      const std::complex<double> expected =
          echo_of(203e3, 1e4, 10.0002e9) * core::turned_exactly(0.2e6 * after_middle_s);
      const std::complex<double> found = samples[columns + i];  // pulse 0, of 10 GHz
      ASSERT_LT(std::abs(found - expected), 1e-6 * std::abs(expected)) << i;
    }
  }
  scene.radars[0].carrier_step_hz = 1.1e6;  // beyond the sampled band
  const auto samples = recorded(scene, Engine::reference);
  EXPECT_EQ(samples[samples.size() / 4 + column_at(203e3 - 0.5e-3 * c)], std::complex<double>());
}

TEST(RangeAmbiguities, AreCompressedToTheRangesAtWhichTheyArrive) {
  scene::Scene scene = second_time_around();
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 0.8e6;
  scene.radars[0].pulse_width_s = 50e-6;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  for (const Engine engine : {Engine::direct, Engine::spectral}) {
    const auto samples = recorded(scene, engine);
    const auto row = std::span(samples).first(samples.size() / 4);
    const auto peak = std::ranges::max_element(row, {}, [](const auto& s) { return std::abs(s); });
    EXPECT_NEAR(40e3 + static_cast<double>(peak - row.begin()) * c / 2e6, 203e3 - 0.5e-3 * c, c / 4e6);
  }
}

TEST(RangeAmbiguities, OfPlatformsBetweenTwoLooksAreNotMissed) {
  scene::Scene scene = second_time_around();
  // Through the ambiguous window in 0.1 s of 20: at one of 200 looks.
  scene.platforms.push_back(moving("Fast", {0.0, 0.0, 0.0}, {0.0, 200e3 / 10.0, 0.0}));
  scene.targets[1].platform = "Fast";
  scene.targets[1].position_m = {0.0, 0.0, 0.0};
  scene.simulations[0].range_start_m = 52e3;
  scene.simulations[0].range_end_m = 54e3;
  scene.simulations[0].time_start_s = 5.0;
  scene.simulations[0].time_end_s = 15.0;
  EXPECT_THAT(pulses_back(scene), testing::Contains(1));
}

TEST(RangeAmbiguities, FarTooManyAreSaid) {
  scene::Scene scene = second_time_around();
  scene.radars[0].prf_hz = 5e6;
  scene.radars[0].pulse_width_s = 1e-7;
  scene.simulations[0].time_end_s = 0.0;
  scene.targets[0].position_m.y = 100e3;  // 3336 pulses
  EXPECT_EQ(make_plan(scene, 0).sources.range_ambiguities.farther, 1.0);
}

TEST(RangeAmbiguities, FarTooManyAreSaidOnlyWhereTheyMayBeHeard) {
  scene::Scene scene = second_time_around();
  scene.radars[0].prf_hz = 5e6;
  scene.radars[0].pulse_width_s = 1e-7;
  scene.simulations[0].time_end_s = 0.0;
  scene.simulations[0].sample_rate_hz = 100e6;
  scene.simulations[0].range_start_m = 1000.0;
  scene.simulations[0].range_end_m = 1020.0;
  scene.targets.resize(2);
  scene.targets[0].position_m = {0.0, 1010.0, 0.0};
  scene.targets[0].rcs_m2 = 1.0;
  scene.targets[1].position_m = {0.0, 101e3, 0.0};  // 3336 pulses, -80 dB
  scene.targets[1].rcs_m2 = 1.0;
  EXPECT_EQ(make_plan(scene, 0).sources.range_ambiguities.farther, 0.0);
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::all;
  EXPECT_NEAR(make_plan(scene, 0).sources.range_ambiguities.farther, 1e-4, 1e-8);
}

// Pulses leave at 0 and, a millisecond or 1000 samples, later; 10 samples each, noise included.
// A pulse that is so long that all echoes of 2000 pulses touch a row: what 40000 targets take must not grow with that
// number. Each echo of each pulse at 65 looks would be 5e9 steps, half a minute at least.
TEST(RangeAmbiguities, TakeNoLongerWhereManyHearMany) {
  scene::Scene scene = second_time_around();
  scene.radars[0].pulse_width_s = 1e6;
  scene.simulations[0].time_start_s = 0.0;
  scene.simulations[0].time_end_s = 0.1;
  for (int i = 0; i < 40'000; ++i) scene.targets.push_back(target_on("Earth", {0.0, 50e3 + i, 0.0}));
  const sarsim::test::ProcessorTime time;
  const Plan plan = make_plan(scene, 0);
  EXPECT_LT(time.seconds(), 10.0);
  ASSERT_EQ(plan.sources.range_ambiguities.pulses.size(), 2 * static_cast<std::size_t>(max_pulses_away));
  // The strongest, with 1e4 m2 at 203 km, is one of all that each of them may have sent.
  for (const RangeAmbiguity& other : plan.sources.range_ambiguities.pulses)
    ASSERT_EQ(other.strength, 1.0) << other.back;
}

TEST(Eclipsing, BlanksSamplesWhileTheRadarSends) {
  scene::Scene scene = second_time_around();
  scene.radars[0].noise_temperature_k = 300.0;
  scene.options.eclipsing = scene::Eclipsing::blanked;
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene.simulations[0].pulse_position = position;
    scene.simulations[0].range_start_m = 0.0;
    scene.simulations[0].range_end_m = 160e3;
    const auto samples = recorded(scene, Engine::direct);
    const std::size_t lead = position == scene::Simulation::PulsePosition::centre ? 5 : 0;
    const std::size_t columns = samples.size() / 4;
    for (std::size_t i = 0; i < columns; ++i) {
      const bool sending = i < 10 - lead || (i >= 1000 - lead && i < 1010 - lead);
      ASSERT_EQ(samples[columns + i] == std::complex<double>(), sending) << i;
    }
  }
}

// All that an echo has goes with it where those before it are left out.
TEST(KeepHeard, KeepsTheColumnsOfEachEcho) {
  const Plan plan = make_plan(second_time_around(), 0);
  radar::EchoBatch echoes;
  for (int k = 0; k < 6; ++k) {
    echoes.add((k % 2 == 0 ? 50e3 : 500e3) * 2.0 / c + 1e-6 * k, 1.0 + k, radar::PulseClock{1e-6 * k, 1e-3 * k});
    echoes.ahead_turns.push_back(0.1 * k);
  }
  clip_to_window(echoes, 0.0, plan.acquisition.reception.pulse, plan.acquisition.reception.raw_grid);
  ASSERT_TRUE(echoes.is_whole());
  ASSERT_EQ(echoes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(echoes.amplitude_sqrt_w[i], 1.0 + 2.0 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(echoes.ahead_turns[i], 0.2 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(echoes.dilation_rate[i], 2e-3 * static_cast<double>(i));
  }
}

}  // namespace other_pulses_test
}  // namespace sarsim::simulate
