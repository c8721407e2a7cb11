#include "scene/ephemeris/state_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "scene/ephemeris/sample_test_support.hpp"

namespace sarsim::scene::ephemeris {

namespace state_consistency_test {

using namespace sample_test;

StateFindings findings_of(const radar::StateSamples& samples) {
  return examine_states({samples.time_s, samples.position_m, samples.velocity_mps});
}

void round_to(double unit, std::vector<core::Vec3>& values) {
  for (core::Vec3& v : values)
    v = {std::round(v.x / unit) * unit, std::round(v.y / unit) * unit, std::round(v.z / unit) * unit};
}

// Orbits at the spacings of their files, with the digits of these.
radar::StateSamples orbit_samples(Draw& draw, bool velocities, std::size_t count) {
  const double eccentricity = draw(0.0, 0.02);
  const double step_s = velocities ? draw(5.0, 120.0) : draw(5.0, 60.0);
  radar::StateSamples samples = samples_of(
      orbit((6378e3 + draw(300e3, 1500e3)) / (1.0 - eccentricity), eccentricity, draw), 0.0, step_s, count, velocities);
  const double unit = std::pow(10.0, -std::floor(draw(3.0, 7.0)));
  round_to(unit, samples.position_m);
  round_to(unit, samples.velocity_mps);
  return samples;
}

TEST(StateConsistency, SoundOrbitsAreNotSuspected) {
  Draw draw(3);
  for (int k = 0; k < 400; ++k) {
    const StateFindings found = findings_of(orbit_samples(draw, k % 2 == 1, static_cast<std::size_t>(draw(2.0, 60.0))));
    EXPECT_TRUE(found.odd.empty()) << k << ' ' << found.odd.front().position_off_m;
    EXPECT_FALSE(found.velocities) << k;
    EXPECT_TRUE(found.steps.gaps.empty()) << k;
  }
}

// With few states a turn, and on long ellipses.
TEST(StateConsistency, SoundMotionsWithWideSpacingAreNotSuspected) {
  Draw draw(4);
  for (int k = 0; k < 400; ++k) {
    const auto [motion, turn_s, is_orbit] = drawn_motion(draw, k);
    const StateFindings found = findings_of(samples_of(motion, draw(-1.0, 1.0) * turn_s, turn_s / draw.log(3.5, 60.0),
                                                       static_cast<std::size_t>(draw(2.0, 60.0)), k % 2 == 1));
    EXPECT_TRUE(found.odd.empty()) << k;
    EXPECT_FALSE(found.velocities) << k;
  }
}

TEST(StateConsistency, NamesAJump) {
  Draw draw(12);
  radar::StateSamples samples = samples_of(orbit(7078e3, 0.001, draw), 0.0, 30.0, 21, true);
  for (std::size_t i = 11; i < 21; ++i) samples.position_m[i].x += 100.0;
  const StateFindings found = findings_of(samples);
  ASSERT_FALSE(found.odd.empty());
  for (const OddState& odd : found.odd) {
    EXPECT_GT(odd.index, 8U);
    EXPECT_LT(odd.index, 13U);
    EXPECT_GT(odd.position_off_m, 30.0);
  }
}

// Turns that begin between two states, noise, uneven spacing: at most 1 % are suspected.
TEST(StateConsistency, FlightsAreNotSuspected) {
  Draw draw(5);
  int suspected = 0;
  constexpr int flights = 600;
  for (int k = 0; k < flights; ++k) {
    const double noise_m = k % 4 == 0 ? draw.log(1e-4, 3.0) : 0.0;
    const StateFindings found = findings_of(flown_samples(draw, static_cast<std::size_t>(draw(6.0, 300.0)),
                                                          draw.log(0.01, 30.0), k % 2 == 1, k % 5 != 0, noise_m));
    if (!found.odd.empty() || found.velocities || !found.steps.gaps.empty()) ++suspected;
  }
  EXPECT_LE(suspected, flights / 100);
}

TEST(StateConsistency, NamesTheStateThatIsOff) {
  Draw draw(6);
  int found_right = 0;
  constexpr int files = 300;
  for (int k = 0; k < files; ++k) {
    radar::StateSamples samples = orbit_samples(draw, k % 2 == 1, static_cast<std::size_t>(draw(15.0, 60.0)));
    const auto index = static_cast<std::size_t>(draw(0.0, static_cast<double>(samples.time_s.size()) - 1e-9));
    const double size_m = draw.log(100.0, 3000.0);
    samples.position_m[index].y += size_m;
    const StateFindings found = findings_of(samples);
    const bool right = found.odd.size() == 1 && found.odd.front().index == index;
    if (right) {
      EXPECT_NEAR(found.odd.front().position_off_m / size_m, 1.0, 0.1) << k;
      ++found_right;
    }
    for (const OddState& odd : found.odd) EXPECT_EQ(odd.index, index) << k;  // No other one is blamed.
  }
  EXPECT_GT(found_right, files * 97 / 100);
}

TEST(StateConsistency, NamesTheStateWhoseVelocityIsOff) {
  Draw draw(8);
  radar::StateSamples samples = samples_of(orbit(7078e3, 0.001, draw), 0.0, 10.0, 17, true);
  samples.velocity_mps[8].z += 10.0;
  const StateFindings found = findings_of(samples);
  ASSERT_EQ(found.odd.size(), 1U);
  EXPECT_EQ(found.odd.front().index, 8U);
  EXPECT_NEAR(found.odd.front().velocity_off_mps, 10.0, 0.01);
}

TEST(StateConsistency, TellsVelocitiesOfOtherAxesAndUnits) {
  Draw draw(9);
  for (int k = 0; k < 60; ++k) {
    radar::StateSamples samples = orbit_samples(draw, true, 20);
    for (std::size_t i = 0; i < samples.time_s.size(); ++i) {
      const core::Vec3& p = samples.position_m[i];
      core::Vec3& v = samples.velocity_mps[i];
      if (k % 3 == 0) v = 1e-3 * v;
      if (k % 3 == 1) v = v + core::Vec3{-7.29e-5 * p.y, 7.29e-5 * p.x, 0.0};  // What stars see.
      if (k % 3 == 2) v = -1.0 * v;
    }
    const StateFindings found = findings_of(samples);
    ASSERT_TRUE(found.velocities) << k;
    EXPECT_GT(found.velocities->off_mps, 1.0) << k;  // A polar orbit at the pole turns least.
  }
}

TEST(StateConsistency, GapsAreStepsThatAreLongerThanTheOthers) {
  std::vector<double> time_s;
  for (int i = 0; i < 50; ++i)
    if (i != 20 && (i < 30 || i > 33)) time_s.push_back(10.0 * i);
  const SampleSteps steps = steps_of(time_s);
  EXPECT_EQ(steps.usual_s, 10.0);
  ASSERT_EQ(steps.gaps.size(), 2U);
  EXPECT_EQ(steps.gaps[0].before, 19U);
  EXPECT_EQ(steps.gaps[0].length_s, 20.0);
  EXPECT_EQ(steps.gaps[1].length_s, 50.0);
  EXPECT_TRUE(steps_of(std::vector<double>{0.0, 1.0}).gaps.empty());
  // Dense in turns, wide on straight legs.
  std::vector<double> uneven{0.0};
  for (int i = 0; i < 60; ++i) uneven.push_back(uneven.back() + (i % 3 == 0 ? 3.0 : 1.0));
  EXPECT_TRUE(steps_of(uneven).gaps.empty());
}

}  // namespace state_consistency_test

}  // namespace sarsim::scene::ephemeris
