#include "workflow/stepped/isar_scene.hpp"

#include <gmock/gmock.h>

#include "core/maths/constants.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::workflow {
namespace isar_scene_test {

using testing::HasSubstr;

const core::WorkControl two{2, nullptr};

// A ship of four points, 5 km away, that turns by 3 degrees a second; chirps in 8 steps, or on one carrier.
scene::Scene ship_scene(bool stepped) {
  scene::Scene scene;
  scene.platforms.push_back(simulate::resting("Earth", {}));
  scene.platforms.push_back(simulate::moving("Ship", {0.0, 5000.0, 0.0}, {4.0, 3.0, 0.0}));
  scene.platforms.back().rotation_rate = {core::Angle{}, core::Angle{}, core::Angle::from_deg(3.0)};
  for (const core::Vec3& place :
       {core::Vec3{}, core::Vec3{12.0, 4.0, 0.0}, core::Vec3{-9.0, -6.0, 0.0}, core::Vec3{4.0, -8.0, 3.0}})
    scene.targets.push_back(simulate::target_on("Ship", place, place == core::Vec3{} ? 4.0 : 1.0));
  scene::Radar radar;
  radar.platform = "Earth";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.pulse_width_s = 5e-6;
  radar.carrier_hz = 9.4e9;
  radar.prf_hz = stepped ? 2000.0 : 400.0;
  radar.bandwidth_hz = stepped ? 18e6 : 130e6;
  radar.carrier = stepped ? scene::Radar::Carrier::stepped : scene::Radar::Carrier::single;
  radar.carrier_step_hz = 16e6;
  radar.carrier_steps = 8;
  radar.pulses_per_step = 1;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 4940.0;
  simulation.range_end_m = 5060.0;
  simulation.time_end_s = 0.6;
  simulation.sample_rate_hz = stepped ? 25e6 : 160e6;
  scene.simulations.push_back(simulation);
  return scene;
}

SteppedRows rows_of(scene::Scene scene) {
  const simulate::Acquisition window = simulate::acquisition_of(scene, 0);
  EXPECT_FALSE(core::has_errors(problems_of_stepped(window, SteppedUse::isar, false)));
  scene.simulations[0] = recorded_for_stepped(scene.simulations[0], window);
  return stepped_rows_of_scene(std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0)),
                               window);
}

IsarOptions options_for(const SteppedRows& rows) {
  IsarOptions options;
  options.platform = platform_of_targets(*rows.acquisition).value();
  options.oversampling = 2;
  return options;
}

std::string text_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

void expect_found(const IsarImage& made, double share_of_cell, double amplitude_share) {
  ASSERT_EQ(made.points.size(), 4u);
  for (const HeldPoint& point : made.points) {
    ASSERT_TRUE(point.found) << point.target;
    EXPECT_NEAR(point.found->place.azimuth_m, point.expected.azimuth_m, share_of_cell * made.cross_range_resolution_m);
    EXPECT_NEAR(point.found->place.range_m, point.expected.range_m, share_of_cell * made.range_resolution_m);
    EXPECT_NEAR(point.found->amplitude / point.amplitude, 1.0, amplitude_share);
  }
}

TEST(IsarImage, OfStepsOfChirpsAndOfChirpsOnOneCarrierHasItsPointsInPlace) {
  for (const bool stepped : {true, false}) {
    const SteppedRows rows = rows_of(ship_scene(stepped));
    const IsarImage made = make_isar_image(rows, 0, rows.bursts, options_for(rows), two);
    EXPECT_EQ(text_of(made.problems), "");
    // 3 degrees a second, less what the line of sight turns with the ship: 4 m/s in 5 km.
    EXPECT_NEAR(made.turn_rad / (made.to_s - made.from_s), 3.0 * core::pi / 180.0 - 4.0 / 5000.0, 2e-4);
    EXPECT_NEAR(made.speed_mps, 3.0, 0.01);
    EXPECT_NEAR(made.range_resolution_m, core::exact_light_speed_mps / 2.0 / 130e6, 0.01);
    expect_found(made, 0.1, 0.1);
  }
}

// A wave is a sphere: in the image of range and Doppler a point 12 m aside is x^2/(2 R) = 14 mm farther.
TEST(IsarImage, ExpectsPointsOnTheSphereOfTheWaveOrInThePlane) {
  const SteppedRows rows = rows_of(ship_scene(true));
  IsarOptions options = options_for(rows);
  const IsarImage sphere = plan_isar_image(rows, 0, rows.bursts, options);
  options.algorithm = IsarOptions::Algorithm::back_projection;
  const IsarImage plane = plan_isar_image(rows, 0, rows.bursts, options);
  const double x = plane.points.at(1).expected.azimuth_m;
  const double bend_m = x * x / (2.0 * plane.range_m);
  EXPECT_GT(bend_m, 0.012);
  EXPECT_NEAR(sphere.points.at(1).expected.range_m - plane.points[1].expected.range_m, bend_m, 0.004);
}

TEST(IsarImage, OfBackProjectionHasItsPointsInPlace) {
  const SteppedRows rows = rows_of(ship_scene(true));
  IsarOptions options = options_for(rows);
  options.algorithm = IsarOptions::Algorithm::back_projection;
  const IsarImage made = make_isar_image(rows, 20, 80, options, two);
  expect_found(made, 0.1, 0.1);
  // In the plane, not on the sphere of the wave.
  EXPECT_NEAR(std::abs(made.points[1].expected.azimuth_m), 12.0, 0.5);
}

TEST(IsarImage, FindsTheMotionInTheEchoes) {
  const SteppedRows rows = rows_of(ship_scene(true));
  IsarOptions options = options_for(rows);
  options.motion = IsarOptions::Motion::estimated;
  options.fastest_mps = 30.0;
  options.autofocus = true;
  const IsarImage made = make_isar_image(rows, 0, rows.bursts, options, two);
  EXPECT_NEAR(made.speed_mps, 3.0, 0.3);
  for (const HeldPoint& point : made.points) {
    ASSERT_TRUE(point.found) << point.target;
    EXPECT_NEAR(point.found->place.azimuth_m, point.expected.azimuth_m, made.cross_range_resolution_m);
    EXPECT_NEAR(point.found->place.range_m, point.expected.range_m, made.range_resolution_m);
    EXPECT_GT(point.found->amplitude / point.amplitude, 0.6);
  }
}

// Autofocus straightens phases that bend slowly as well; what it leaves is said.
TEST(IsarImage, KeepsALonePointWhoseMotionIsEstimated) {
  for (const double ahead_mps : {13.5, -6.0}) {
    scene::Scene scene = ship_scene(true);
    scene.platforms[1] = simulate::moving("Ship", {0.0, 5000.0, 0.0}, {ahead_mps, 2.26, 0.0});
    scene.platforms[1].rotation_rate = {core::Angle{}, core::Angle{}, core::Angle::from_deg(4.21)};
    scene.targets = {simulate::target_on("Ship", {11.82, 5.76, 0.0}, 4.0)};
    scene.simulations[0].time_end_s = 0.47;
    const SteppedRows rows = rows_of(scene);
    IsarOptions options = options_for(rows);
    options.motion = IsarOptions::Motion::estimated;
    options.fastest_mps = 40.0;
    options.autofocus = true;
    const IsarImage made = make_isar_image(rows, 0, rows.bursts, options, two);
    ASSERT_TRUE(made.points.at(0).found);
    EXPECT_NEAR(20.0 * std::log10(made.points[0].found->amplitude / made.points[0].amplitude), 0.0, 0.1) << ahead_mps;
    EXPECT_EQ(text_of(made.losses), "");
  }
}

TEST(IsarImage, HoldsTheFirstThousandTargetsAgainstIt) {
  scene::Scene scene = ship_scene(true);
  while (scene.targets.size() < 1100) scene.targets.push_back(simulate::target_on("Ship", {1.0, 1.0, 0.0}, 1e-6));
  const SteppedRows rows = rows_of(scene);
  const IsarImage made = make_isar_image(rows, 0, 4, options_for(rows), two);
  ASSERT_EQ(made.points.size(), max_held_targets);
  EXPECT_EQ(made.points.back().target, max_held_targets - 1);
}

TEST(IsarImage, TakesAGivenTurningForItsScale) {
  const SteppedRows rows = rows_of(ship_scene(true));
  IsarOptions options = options_for(rows);
  options.turn_rate_radps = 0.1;
  const IsarImage made = plan_isar_image(rows, 0, rows.bursts, options);
  EXPECT_NEAR(made.turn_rad, 0.1 * (made.to_s - made.from_s), 1e-9);
}

TEST(IsarImage, SaysWhatStandsAgainstIt) {
  const SteppedRows rows = rows_of(ship_scene(true));
  IsarOptions options = options_for(rows);
  const auto said = [&](const IsarOptions& o, const SteppedRows& r) {
    return text_of(plan_isar_image(r, 0, r.bursts, o).problems);
  };
  EXPECT_EQ(said(options, rows), "");
  options.cross_range_m = 400.0;
  EXPECT_THAT(said(options, rows), HasSubstr("points appear more than once"));
  options.cross_range_m = 4e8;
  EXPECT_THAT(said(options, rows), HasSubstr("cannot be made this large"));
  options = options_for(rows);
  options.range_m = 3000.0;
  EXPECT_THAT(said(options, rows), HasSubstr("points away from its centre blur"));
  options.algorithm = IsarOptions::Algorithm::back_projection;
  EXPECT_THAT(said(options, rows), testing::Not(HasSubstr("blur")));
  scene::Scene still = ship_scene(true);
  still.platforms[1] = simulate::resting("Ship", {0.0, 5000.0, 0.0});
  const SteppedRows resting_rows = rows_of(still);
  EXPECT_THAT(said(options_for(resting_rows), resting_rows), HasSubstr("does not rotate"));
  EXPECT_THROW((void)make_isar_image(resting_rows, 0, 3, options_for(resting_rows), two), std::invalid_argument);
}

}  // namespace isar_scene_test
}  // namespace sarsim::workflow
