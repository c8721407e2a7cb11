#include "simulate/sar_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulate/sar_test_scene.hpp"

namespace sarsim {
namespace {

void expect_like(const ResponseFigures& found, const ResponseFigures& theory) {
  EXPECT_NEAR(found.width, theory.width, 0.01 * theory.width);
  EXPECT_NEAR(found.pslr_db, theory.pslr_db, 0.2);
  EXPECT_NEAR(found.islr_db, theory.islr_db, 0.3);
}

void expect_as_theory(const Scene& scene, const FocusOptions& options) {
  const auto [plan, rows] = sar_recording(scene);
  const TargetTheory theory = theory_of_targets(*plan, rows, options).at(0);
  const PointResponse response = focused_point(rows, theory.place, options);
  EXPECT_NEAR(response.place.azimuth_m, theory.place.azimuth_m, 0.02);
  EXPECT_NEAR(response.place.range_m, theory.place.range_m, 0.03);
  EXPECT_NEAR(response.amplitude, theory.amplitude, 0.01 * theory.amplitude);
  EXPECT_NEAR(std::remainder(response.phase_rad - theory.phase_rad, 2.0 * pi), 0.0, 0.01);
  ASSERT_TRUE(theory.range && theory.azimuth);
  expect_like(response.range, *theory.range);
  expect_like(response.azimuth, *theory.azimuth);
}

TEST(TheoryOfTargets, IsWhatAPlainImageShows) { expect_as_theory(sar_scene(600.0, {{3.0, -31.0, 0.0}}), {}); }

TEST(TheoryOfTargets, IsWhatAnAntennaThatTapersTheEchoesShows) {
  // A beam of 1.5 degrees across track: echoes at both ends of 2.2 degrees of track are much weaker.
  Scene scene = sar_scene(600.0, {{3.0, 0.0, 0.0}});
  Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = Angle::from_deg(1.5);
  radar.transmit_antenna.elevation_beamwidth = Angle::from_deg(30.0);
  radar.beam_azimuth = Angle::from_deg(90.0);
  radar.beam_elevation = Angle::from_deg(-11.3);
  expect_as_theory(scene, {.method = FocusMethod::chirp_scaling});
}

TEST(TheoryOfTargets, FollowsTheDopplerBandThatIsKept) {
  expect_as_theory(sar_scene(600.0, {{3.0, 20.0, 0.0}}), {.doppler_bandwidth_hz = 150.0});
}

TEST(TheoryOfTargets, HasNoRangeFiguresForOtherPulsesThanChirps) {
  Scene scene = sar_scene(600.0, {{}}, 0.1);
  scene.radars[0].pulse = Radar::Pulse::mono;
  const auto [plan, rows] = sar_recording(scene);
  EXPECT_FALSE(theory_of_targets(*plan, rows, {}).at(0).range);
}

}  // namespace
}  // namespace sarsim
