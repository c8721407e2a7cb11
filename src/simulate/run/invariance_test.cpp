// What must not change the samples of a recording, and what must change them in a known way (decisions 3, 5 and 27).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace invariance_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double c = core::exact_light_speed_mps;
using Samples = std::vector<std::complex<double>>;

scene::Scene noisy_chirp_scene() {
  scene::Scene scene = one_target_scene();
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 3e6;
  scene.radars[0].noise_temperature_k = 1e5;
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.1;
  scene.platforms.push_back(moving("Car", {1300, 20, 0}, {-25, 3, 0}));
  scene.targets.push_back(target_on("Car", {}, 2.0));
  scene.simulations[0].time_end_s = 0.002;
  return scene;
}

double largest(const Samples& samples) {
  double most = 0.0;
  for (const auto& s : samples) most = std::max(most, std::abs(s));
  return most;
}

// Starts differ by whole samples, ends are equal: the samples at the same ranges are the same numbers, with their
// noise, but for the rounding of times (1e-5 s, turned by at most pi B).
void expect_same_samples(scene::Scene scene, double start_m, std::size_t later) {
  scene::Simulation& simulation = scene.simulations[0];
  simulation.range_start_m = start_m;
  const Samples wide = samples_of(scene);
  const std::size_t columns = make_plan(scene, 0).acquisition.reception.columns;
  simulation.range_start_m = start_m + static_cast<double>(later) * c / (2.0 * simulation.sample_rate_hz);
  const Samples narrow = samples_of(scene);
  const std::size_t fewer = make_plan(scene, 0).acquisition.reception.columns;
  ASSERT_EQ(fewer, columns - later);
  const double bound = largest(wide) * (core::pi * 3e6 * 1e-5 * 4.0 + 500.0) * epsilon;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t i = 0; i < fewer; ++i)
      ASSERT_LT(std::abs(narrow[row * fewer + i] - wide[row * columns + i + later]), bound) << row << " " << i;
}

TEST(Recording, SamplesDoNotDependOnWhereTheWindowBegins) {
  for (const scene::Processing processing : {scene::Processing::raw, scene::Processing::matched_filter})
    for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre})
      for (const double start_m : {0.0, 0.25 * c / 8e6, 300.0, 4.5 * c / 8e6})
        for (const std::size_t later : {1u, 7u, 20u}) {
          scene::Scene scene = noisy_chirp_scene();
          scene.simulations[0].processing = processing;
          scene.simulations[0].pulse_position = position;
          expect_same_samples(scene, start_m, later);
        }
}

// Half a pulse of 5.25 us holds ten and a half samples, so that the first raw sample of a compressed CENTRE recording
// lies halfway between two whole numbers of intervals after the pulse has left: rounding must not tell windows apart.
TEST(Recording, NoiseStaysWithItsSampleWhenTheWindowBeginsHalfwayBetweenSamples) {
  for (const double width_s : {5.25e-6, 5.75e-6})
    for (const std::size_t first : {0u, 3u, 9u, 11u, 13u})
      for (const std::size_t later : {1u, 2u, 5u, 12u, 13u}) {
        scene::Scene scene = noisy_chirp_scene();
        scene.radars[0].pulse_width_s = width_s;
        scene.simulations[0].processing = scene::Processing::matched_filter;
        scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
        expect_same_samples(scene, static_cast<double>(first) * c / 8e6, later);
      }
}

TEST(Recording, PulsesDoNotDependOnWhenTheWindowBegins) {
  scene::Scene scene = noisy_chirp_scene();
  const Samples early = samples_of(scene);
  scene.simulations[0].time_start_s = 0.001;
  scene.simulations[0].time_end_s = 0.004;
  const Samples late = samples_of(scene);
  for (std::size_t i = 0; i < 2 * 53; ++i) EXPECT_EQ(late[i], early[53 + i]);
}

TEST(Recording, OfTwoTargetsIsTheSumOfTheRecordingsOfEach) {
  scene::Scene scene = noisy_chirp_scene();
  scene.radars[0].noise_temperature_k = 0.0;
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.0;
  const Samples both = samples_of(scene);
  scene::Scene first = scene, second = scene;
  first.targets.pop_back();
  second.targets.erase(second.targets.begin());
  const Samples a = samples_of(first), b = samples_of(second);
  for (std::size_t i = 0; i < both.size(); ++i)
    EXPECT_LT(std::abs(both[i] - a[i] - b[i]), largest(both) * 4.0 * epsilon);
}

TEST(Recording, AddingATargetAddsItsEchoesAndNothingElse) {
  scene::Scene scene = noisy_chirp_scene();
  const Samples before = samples_of(scene);
  scene.targets.push_back(target_on("Earth", {900.0, 0, 0}, 0.0));  // reflects nothing, draws nothing from the others
  scene.targets.back().traits.edit().position_stddev_m = {5, 5, 5};
  EXPECT_EQ(samples_of(scene), before);
}

TEST(Recording, FollowsTheSeed) {
  scene::Scene scene = noisy_chirp_scene();
  const Samples one = samples_of(scene);
  EXPECT_EQ(samples_of(scene), one);
  scene.options.seed = 2;
  EXPECT_NE(samples_of(scene), one);
}

TEST(Recording, DoesNotDependOnWhereTheWorldHasItsOrigin) {
  scene::Scene scene = noisy_chirp_scene();
  scene.radars[0].noise_temperature_k = 0.0;
  const Samples here = samples_of(scene);
  scene.platforms[0].position_m = {4096, -2048, 512};  // exact shifts
  for (auto& knot : scene.platforms[1].trajectory_m.part[0].knots) knot.y += 4096;
  for (auto& knot : scene.platforms[1].trajectory_m.part[1].knots) knot.y -= 2048;
  for (auto& knot : scene.platforms[1].trajectory_m.part[2].knots) knot.y += 512;
  const Samples there = samples_of(scene);
  // Positions are rounded to 5000 m epsilon: 20 cycles per 3 m of it.
  for (std::size_t i = 0; i < here.size(); ++i)
    EXPECT_LT(std::abs(there[i] - here[i]), largest(here) * 4.0 * core::pi * 5e3 / 0.3 * 8.0 * epsilon);
}

// The classic profile divides the window into N samples whatever the sampling rate: band-limited pulses must be sampled
// on those. The window's 53.37 intervals hold 53 samples, so that the last is off by a third of one otherwise.
TEST(Recording, BandLimitedPulsesAreSampledWhereTheClassicProfilesSamplesLie) {
  scene::Scene scene = one_target_scene();
  scene.options.pulse = scene::PulseDefinition::band_limited;
  scene.options.profile = scene::Profile::classic;
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 3e6;
  scene.radars[0].pulse_width_s = 9e-6;
  scene.targets[0].position_m = {100.0, 0, 0};
  const Plan plan = make_plan(scene, 0);
  const Samples samples = samples_of(scene);
  const double amplitude = equation_amplitude(100.0, 1.0, core::classic_light_speed_mps / 1e9);
  const double delay_s = 200.0 / core::classic_light_speed_mps;
  const radar::BandLimitedPulse shape(plan.acquisition.reception.pulse.pulse, 2e6, 4e6, 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::complex<double> expected = amplitude *
                                          std::polar(1.0, -2.0 * core::pi * std::remainder(1e9 * delay_s, 1.0)) *
                                          shape.value(plan.acquisition.reception.raw_grid.time_s(i) - delay_s);
    // Two tables, each within 1e-8 of the pulse's largest value, 1.2 or so.
    EXPECT_LT(std::abs(samples[i] - expected), amplitude * 3e-8) << i;
  }
}

}  // namespace invariance_test
}  // namespace sarsim::simulate
