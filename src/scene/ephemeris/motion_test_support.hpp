#pragma once

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "radar/earth/turning_frame.hpp"
#include "radar/motion/path_state.hpp"
#include "radar/orbit/kepler.hpp"
#include "scene/ephemeris/write_motion.hpp"

/// A satellite over a world on the Earth, for tests of what writes motions.
namespace sarsim::scene::motion_test {

/// Earth-fixed state of the orbit of Sentinel-1 under J2: 7070.5 km, 98.18 deg.
inline radar::StateVector orbit_ecef(double time_s) {
  static const radar::SecularOrbit orbit(
      {7070.5e3, 0.00114, 98.1817 * core::rad_per_deg, 1.75, 1.4, 4.6 /* south of the equator, going north */});
  const radar::OrbitMotion motion = orbit.at(time_s);
  const radar::TurningFrame earth =
      radar::turning_about_z(0.3 + radar::earth_rate_rad_per_s * time_s, radar::earth_rate_rad_per_s);
  return earth.to({motion.position_m, motion.velocity_mps});
}

/// A world at 51 deg north, 11 deg east, turned by 0.2 rad.
inline radar::EarthFrame test_earth() { return radar::EarthFrame({{0.89, 0.19, 120.0}, 0.2}); }

/// The orbit in that world.
inline MotionSample orbit_sample(double time_s) {
  const radar::EarthFrame earth = test_earth();
  const radar::StateVector state = orbit_ecef(time_s);
  return {time_s, earth.world_from_ecef(state.position_m), earth.world_axes_from_ecef(state.velocity_mps)};
}

/// The orbit as a path in Earth-fixed axes from the centre of the Earth.
inline radar::PathState orbit_path(double time_s) {
  const radar::StateVector state = orbit_ecef(time_s);
  return {state.position_m, state.velocity_mps, {}, {}};
}

/// Samples of the orbit with that spacing.
inline std::vector<MotionSample> orbit_samples(double first_s, double spacing_s, std::size_t count) {
  std::vector<MotionSample> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(orbit_sample(first_s + static_cast<double>(i) * spacing_s));
  return samples;
}

/// The moment of a time of UTC.
inline radar::Instant utc(std::string_view text) {
  const radar::InstantReading reading = radar::parse_instant(text, radar::TimeScale::utc);
  EXPECT_TRUE(reading.instant) << reading.failure;
  return reading.instant.value_or(radar::Instant{});
}

/// Facts of a satellite.
inline MotionFacts facts_of_satellite() {
  MotionFacts facts;
  facts.object_name = "SENTINEL LIKE";
  facts.object_id = "2014-016A";
  facts.created = "2025-03-14T12:00:00";
  facts.epoch = utc("2024-04-01T22:59:42.25");
  facts.earth = test_earth();
  return facts;
}

/// The message of the only problem; a test failure where there are others or a text.
inline std::string refusal(const MotionText& written) {
  EXPECT_TRUE(written.text.empty());
  EXPECT_EQ(written.problems.size(), 1U);
  for (const core::Problem& problem : written.problems) {
    EXPECT_EQ(problem.severity, core::Severity::error);
    EXPECT_FALSE(problem.expected.empty()) << problem.message;
  }
  return written.problems.empty() ? "" : written.problems.front().message;
}

/// The text of a file without any problem.
inline std::string sound(const MotionText& written) {
  for (const core::Problem& problem : written.problems) ADD_FAILURE() << core::to_string(problem);
  return written.text;
}

}  // namespace sarsim::scene::motion_test
