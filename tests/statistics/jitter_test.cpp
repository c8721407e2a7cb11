// Jitter of positions, rotations, cross-sections and directions, measured in the phase and amplitude of echoes.

#include <gtest/gtest.h>

#include <cmath>

#include "support/moments.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace jitter_test {

using namespace test;

constexpr std::size_t pulses = 4000;
constexpr double wavelength_m = core::exact_light_speed_mps / 1e9;

// Monochrome pulses of a scene whose only echo comes from about 1 km; one sample of each.
std::vector<std::complex<double>> echo_history(scene::Scene scene) {
  set_pulses(scene, 0, static_cast<int>(pulses) - 1);
  set_window(scene, 1300.0, 1300.0 + 0.5 * core::exact_light_speed_mps / 4e6, 4e6);
  const simulate::Recording recording = recorded(scene);
  EXPECT_EQ(recording.report.rows, pulses);
  EXPECT_EQ(recording.report.columns, 1u);
  return recording.samples;
}

// Range deviations from the nominal range by the phase -4 pi R/lambda; unambiguous up to lambda/4.
std::vector<double> range_deviations_m(const std::vector<std::complex<double>>& echoes, double nominal_m) {
  std::vector<double> deviations;
  for (const auto& echo : echoes)
    deviations.push_back(-wavelength_m / (4.0 * core::pi) *
                         wrapped_rad(std::arg(echo) + 4.0 * core::pi * std::remainder(nominal_m / wavelength_m, 0.5)));
  return deviations;
}

void expect_white_normal(const std::vector<double>& x, double stddev) {
  EXPECT_NEAR(mean(x), 0.0, mean_gate(stddev, x.size()));
  EXPECT_NEAR(mean_square(x), stddev * stddev, variance_gate(stddev * stddev, x.size()));
  double fourth = 0.0;
  for (const double value : x) fourth += std::pow(value / stddev, 4) / static_cast<double>(x.size());
  EXPECT_NEAR(fourth, 3.0, gate_sigmas * std::sqrt(96.0 / static_cast<double>(x.size())));
  for (const std::size_t lag : {1U, 2U, 7U})
    EXPECT_NEAR(mean_product(x, lag) / (stddev * stddev), 0.0, correlation_gate(x.size() - lag)) << lag;
}

TEST(PositionJitter, OfATargetHasItsStandardDeviationAlongEachAxis) {
  std::vector<std::vector<double>> axes;
  for (int axis = 0; axis < 3; ++axis) {
    scene::Scene scene = radar_at_origin();
    const core::Vec3 unit{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    scene::Target& target = add_target(scene, 1000.0 * unit);
    target.traits.edit().position_stddev_m = {0.010, 0.008, 0.006};
    axes.push_back(range_deviations_m(echo_history(scene), 1000.0));
    expect_white_normal(axes.back(), axis == 0 ? 0.010 : axis == 1 ? 0.008 : 0.006);
  }
  EXPECT_NEAR(correlation_coefficient(axes[0], axes[1]), 0.0, correlation_gate(pulses));
  EXPECT_NEAR(correlation_coefficient(axes[0], axes[2]), 0.0, correlation_gate(pulses));
  EXPECT_NEAR(correlation_coefficient(axes[1], axes[2]), 0.0, correlation_gate(pulses));
}

TEST(PositionJitter, OfAPlatformHasItsStandardDeviationAlongEachAxisAndMovesTheRadar) {
  std::vector<std::vector<double>> axes;
  for (int axis = 0; axis < 3; ++axis) {
    scene::Scene scene = radar_at_origin();
    scene::Platform& shaking = add_platform(scene, "Shaking", {});
    shaking.position_stddev_m = {0.010, 0.008, 0.006};
    scene.radars[0].platform = "Shaking";
    add_target(scene, {axis == 0 ? 1000.0 : 0.0, axis == 1 ? 1000.0 : 0.0, axis == 2 ? 1000.0 : 0.0});
    axes.push_back(range_deviations_m(echo_history(scene), 1000.0));
    expect_white_normal(axes.back(), axis == 0 ? 0.010 : axis == 1 ? 0.008 : 0.006);
  }
  EXPECT_NEAR(correlation_coefficient(axes[0], axes[1]), 0.0, correlation_gate(pulses));
  EXPECT_NEAR(correlation_coefficient(axes[1], axes[2]), 0.0, correlation_gate(pulses));
}

TEST(PositionJitter, OfAPlatformIsCommonToAllThatItCarries) {
  scene::Scene scene = radar_at_origin();
  scene::Platform& shaking = add_platform(scene, "Shaking", {1000.0, 0.0, 0.0});
  shaking.position_stddev_m = {0.010, 0.0, 0.0};
  add_target(scene, {}, 1.0, "Shaking");
  const auto first = range_deviations_m(echo_history(scene), 1000.0);
  scene.targets[0].position_m = {30.0, 0.0, 0.0};
  const auto second = range_deviations_m(echo_history(scene), 1030.0);
  for (std::size_t i = 0; i < pulses; i += 97) EXPECT_NEAR(first[i], second[i], 1e-9);
}

TEST(PositionJitter, DoesNotTouchTheSpeed) {
  scene::Scene scene = radar_at_origin();
  scene::Target& target = add_target(scene, {1000.0, 0.0, 0.0});
  target.traits.edit().position_stddev_m = {1.0, 1.0, 1.0};
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  for (int pulse = 0; pulse < 20; ++pulse) {
    geometry.set_pulse(pulse);
    EXPECT_EQ(geometry.view(0).speed_mps, 0.0);
  }
}

TEST(RotationJitter, MovesAPointOnAnArmByTheAngleTimesTheArm) {
  struct Case {
    int axis;
    core::Vec3 arm_m;
  };
  // Each arm stands across the line of sight, so that a small turn moves its point along it.
  std::vector<std::vector<double>> turns;
  for (const Case& c : {Case{1, {0.0, 0.0, 10.0}}, Case{2, {0.0, 10.0, 0.0}}}) {
    scene::Scene scene = radar_at_origin();
    scene::Platform& shaking = add_platform(scene, "Shaking", {1000.0, 0.0, 0.0});
    shaking.rotation_stddev[static_cast<std::size_t>(c.axis)] = core::Angle::from_deg(0.05);
    add_target(scene, c.arm_m, 1.0, "Shaking");
    const double range_m = std::hypot(1000.0, 10.0);
    turns.push_back(range_deviations_m(echo_history(scene), range_m));
    // dR = arm * angle * cos of the line of sight; the square of the angle shifts by 10 m * 4e-7.
    expect_white_normal(turns.back(), 10.0 * 0.05 * core::pi / 180.0 * 1000.0 / range_m);
  }
  EXPECT_NEAR(correlation_coefficient(turns[0], turns[1]), 0.0, correlation_gate(pulses));
}

TEST(CrossSection, HasItsMeanAndStandardDeviation) {
  scene::Scene scene = radar_at_origin();
  add_target(scene, {1000.0, 0.0, 0.0}, 2.0);
  const double unit_w = std::norm(echo_history(scene)[0]) / 2.0;
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.3;  // never below 0: 6.7 sigma
  std::vector<double> deviation;
  for (const auto& echo : echo_history(scene)) deviation.push_back(std::norm(echo) / unit_w - 2.0);
  expect_white_normal(deviation, 0.3);
}

TEST(CrossSection, BelowZeroIsZero) {
  scene::Scene scene = radar_at_origin();
  add_target(scene, {1000.0, 0.0, 0.0}, 1.0);
  scene.targets[0].traits.edit().rcs_stddev_m2 = 1.0;
  std::size_t silent = 0;
  for (const auto& echo : echo_history(scene)) silent += echo == std::complex<double>() ? 1U : 0U;
  const double share = 0.5 * std::erfc(1.0 / std::sqrt(2.0));  // below -1 sigma
  EXPECT_NEAR(static_cast<double>(silent) / pulses, share, gate_sigmas * std::sqrt(share * (1.0 - share) / pulses));
}

TEST(PointingJitter, OfADirectionalTargetTurnsItsNormal) {
  // The normal stands at 45 deg to the line of sight: power cos(45 deg + a), slope sin(45 deg).
  for (const bool vertical : {false, true}) {
    scene::Scene scene = radar_at_origin();
    scene::Target& target = add_target(scene, {1000.0, 0.0, 0.0});
    const double facing_w = std::norm(echo_history(scene)[0]);
    scene.targets[0].traits.edit().reflectivity = scene::Target::Reflectivity::directional;
    scene.targets[0].traits.edit().azimuth = core::Angle::from_deg(vertical ? 270.0 : 225.0);
    scene.targets[0].traits.edit().elevation = core::Angle::from_deg(vertical ? 45.0 : 0.0);
    scene::TargetTraits& traits = target.traits.edit();
    (vertical ? traits.elevation_stddev : traits.azimuth_stddev) = core::Angle::from_deg(1.0);
    std::vector<double> turns_deg;
    for (const auto& echo : echo_history(scene))
      turns_deg.push_back(std::acos(std::norm(echo) / facing_w) * 180.0 / core::pi - 45.0);
    expect_white_normal(turns_deg, 1.0);
  }
}

}  // namespace jitter_test
}  // namespace sarsim
