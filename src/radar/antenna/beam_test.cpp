#include "radar/antenna/beam.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace beam_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double bound = 20.0 * epsilon;

// Elementary right-handed rotation about z, transposed: yaw, clockwise seen from above.
core::Mat3 yawed(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{core::Vec3{c, s, 0}, core::Vec3{-s, c, 0}, core::Vec3{0, 0, 1}}};
}

// Roll about x in the documented sense: +y goes down, +z towards +y.
core::Mat3 rolled(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{core::Vec3{1, 0, 0}, core::Vec3{0, c, s}, core::Vec3{0, -s, c}}};
}

Beam fixed(double azimuth, double elevation) {
  Beam beam;
  beam.azimuth_rad = azimuth;
  beam.elevation_rad = elevation;
  return beam;
}

Pointing pointing(const Beam& beam, PointingRule rule, const core::Mat3& world_from_platform = {},
                  const std::array<double, 3>& angles = {}, double time_s = 0.0, const core::Vec3& radar = {}) {
  return {beam, rule, time_s, radar, world_from_platform, angles};
}

constexpr std::array both_rules{PointingRule::boresight, PointingRule::added_angles};

TEST(Pointing, OfAZeroBeamLooksAlongY) {
  for (const PointingRule rule : both_rules) {
    EXPECT_LT(core::norm(pointing(fixed(0, 0), rule).axis_world() - core::Vec3{0, 1, 0}), bound);
    EXPECT_LT(core::norm(pointing(fixed(core::pi / 2, 0), rule).axis_world() - core::Vec3{1, 0, 0}), bound);
    EXPECT_LT(core::norm(pointing(fixed(0, core::pi / 2), rule).axis_world() - core::Vec3{0, 0, 1}), bound);
  }
}

TEST(Pointing, HasNoOffsetAlongItsAxis) {
  for (const PointingRule rule : both_rules) {
    const Pointing p = pointing(fixed(0.7, -0.4), rule, yawed(0.3), {0, 0, 0.3});
    const BeamOffset offset = p.offset(1234.0 * p.axis_world());
    EXPECT_NEAR(offset.azimuth_rad, 0.0, bound);
    EXPECT_NEAR(offset.elevation_rad, 0.0, bound);
  }
}

// On the horizon of a level beam both rules measure the same angles, apart from the sign, which no pattern knows.
TEST(Pointing, RulesAgreeForALevelPlatformThatYaws) {
  for (const double yaw : {0.0, 0.5, -2.0}) {
    const Pointing boresight = pointing(fixed(0.4, 0), PointingRule::boresight, yawed(yaw), {0, 0, yaw});
    const Pointing added = pointing(fixed(0.4, 0), PointingRule::added_angles, yawed(yaw), {0, 0, yaw});
    EXPECT_LT(core::norm(boresight.axis_world() - added.axis_world()), bound);
    for (const double az : {-1.0, 0.2, 0.9, 2.5})
      for (const double el : {-0.5, 0.0, 0.3}) {
        const BeamOffset a = boresight.offset(core::direction(az, el)), b = added.offset(core::direction(az, el));
        EXPECT_NEAR(std::abs(a.azimuth_rad), std::abs(b.azimuth_rad), bound);
        EXPECT_NEAR(std::abs(a.elevation_rad), std::abs(b.elevation_rad), bound);
      }
  }
}

TEST(Pointing, AddedAnglesTakeYawAndPitchAndIgnoreRoll) {
  const Pointing p = pointing(fixed(0.1, 0.2), PointingRule::added_angles, {}, {9.0, 0.03, 0.04});
  EXPECT_LT(core::norm(p.axis_world() - core::direction(0.14, 0.23)), bound);
  EXPECT_NEAR(p.axis_azimuth_rad(), 0.14, bound);
  EXPECT_NEAR(p.axis_elevation_rad(), 0.23, bound);
  const BeamOffset offset = p.offset(core::direction(0.5, 0.1));
  EXPECT_NEAR(std::abs(offset.azimuth_rad), 0.36, bound);
  EXPECT_NEAR(std::abs(offset.elevation_rad), 0.13, bound);
}

TEST(Pointing, AddedAnglesWrapTheDifferenceOfAzimuths) {
  Beam beam;
  beam.kind = Beam::Kind::rotating;
  beam.rate_rad_per_s = 2.0 * core::pi;
  const Pointing p = pointing(beam, PointingRule::added_angles, {}, {}, 10.25);  // 10 turns and a quarter
  EXPECT_NEAR(p.offset({1, 0, 0}).azimuth_rad, 0.0, 100.0 * epsilon);
  EXPECT_NEAR(std::abs(p.offset({1, 1, 0}).azimuth_rad), core::pi / 4, 100.0 * epsilon);
}

// A beam along the nose: rolling the platform by a quarter turn exchanges the azimuth and the elevation of its pattern.
TEST(Pointing, RollOfThePlatformRollsThePatternOfAFixedBeam) {
  const Beam nose = fixed(core::pi / 2, 0);
  const Pointing level = pointing(nose, PointingRule::boresight);
  const Pointing banked = pointing(nose, PointingRule::boresight, rolled(core::pi / 2), {core::pi / 2, 0, 0});
  const core::Vec3 above = core::direction(core::pi / 2, 0.1);
  EXPECT_NEAR(level.offset(above).elevation_rad, 0.1, bound);
  EXPECT_NEAR(level.offset(above).azimuth_rad, 0.0, bound);
  EXPECT_NEAR(std::abs(banked.offset(above).azimuth_rad), 0.1, bound);
  EXPECT_NEAR(banked.offset(above).elevation_rad, 0.0, bound);
  EXPECT_LT(core::norm(banked.axis_world() - core::Vec3{1, 0, 0}), bound);
}

// A beam to the side (along +y) of a platform that rolls +y down looks down.
TEST(Pointing, RollOfThePlatformTiltsASideLookingBeam) {
  const Pointing p = pointing(fixed(0, 0), PointingRule::boresight, rolled(0.3), {0.3, 0, 0});
  EXPECT_LT(core::norm(p.axis_world() - core::direction(0.0, -0.3)), bound);
}

TEST(Pointing, AzimuthOffsetIsPositiveClockwiseAndElevationOffsetUpwards) {
  const Pointing p = pointing(fixed(0.3, 0.2), PointingRule::boresight);
  EXPECT_GT(p.offset(core::direction(0.4, 0.2)).azimuth_rad, 0.0);
  EXPECT_GT(p.offset(core::direction(0.3, 0.25)).elevation_rad, 0.0);
  EXPECT_NEAR(p.offset(core::direction(0.3, 0.25)).elevation_rad, 0.05, bound);
}

TEST(Pointing, SteeredBeamsLookAtTheirPointWhateverTheRotation) {
  const core::Vec3 radar{100, -200, 3000};
  Beam spot;
  spot.kind = Beam::Kind::spot;
  spot.spot_world_m = {900, 400, 0};
  Beam user;
  user.kind = Beam::Kind::user;
  user.target_world_m = {core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0, 500}, {1, 900}}}),
                         core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0, 400}}}),
                         core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0, 0}}})};
  const core::Vec3 look = spot.spot_world_m - radar;
  for (const PointingRule rule : both_rules)
    for (const Beam& beam : {spot, user}) {
      const Pointing p = pointing(beam, rule, rolled(0.8) * yawed(1.0), {0.8, 0.3, 1.0}, 1.0, radar);
      EXPECT_LT(core::norm(p.axis_world() - (1.0 / core::norm(look)) * look), bound);
      EXPECT_NEAR(p.offset(look).azimuth_rad, 0.0, bound);
      EXPECT_NEAR(p.offset(look).elevation_rad, 0.0, bound);
    }
}

TEST(Pointing, RotatingBeamTurnsClockwiseOnThePlatform) {
  Beam beam;
  beam.kind = Beam::Kind::rotating;
  beam.rate_rad_per_s = 0.5;
  beam.elevation_rad = -0.1;
  for (const PointingRule rule : both_rules)
    EXPECT_LT(core::norm(pointing(beam, rule, yawed(0.2), {0, 0, 0.2}, 3.0).axis_world() - core::direction(1.7, -0.1)),
              bound);
}

// Turning the platform, the beam with it and the target about any axis leaves the boresight rule's offsets alone.
TEST(Pointing, OffsetsDoNotDependOnHowTheWorldIsTurned) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  const Beam beam = fixed(0.6, -0.3);
  const core::Vec3 look_platform = core::direction(0.75, -0.1);
  const BeamOffset level = pointing(beam, PointingRule::boresight).offset(look_platform);
  for (int i = 0; i < 50; ++i) {
    const core::Mat3 turned = rolled(angle(random)) * yawed(angle(random)) * rolled(angle(random));
    const BeamOffset offset = pointing(beam, PointingRule::boresight, turned).offset(turned * look_platform);
    EXPECT_NEAR(offset.azimuth_rad, level.azimuth_rad, bound);
    EXPECT_NEAR(offset.elevation_rad, level.elevation_rad, bound);
  }
}

}  // namespace beam_test
}  // namespace sarsim::radar
