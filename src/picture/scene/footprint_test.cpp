#include "picture/scene/footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::picture {
namespace footprint_test {

constexpr double deg = core::pi / 180.0;

// Looks along azimuth 0 (+y), downwards.
Snapshot::Radar radar_at(const core::Vec3& position_m, double depression_rad, double azimuth_width_rad,
                         double elevation_width_rad) {
  Snapshot::Radar radar;
  radar.position_world_m = position_m;
  radar.axis_world = core::direction(0.0, -depression_rad);
  radar.across_world = {1.0, 0.0, 0.0};
  radar.azimuth_width_rad = azimuth_width_rad;
  radar.elevation_width_rad = elevation_width_rad;
  radar.isotropic = false;
  return radar;
}

TEST(Footprint, LiesOnThePlaneBetweenTheEdgesOfTheBeam) {
  const double height_m = 2000.0;
  const auto contour = footprint_of(radar_at({100.0, -50.0, height_m}, 40.0 * deg, 3.0 * deg, 10.0 * deg), {});
  ASSERT_EQ(contour.size(), 64U);
  for (const core::Vec3& point : contour) EXPECT_NEAR(point.z, 0.0, 1e-9);
  const auto [near, far] = std::ranges::minmax_element(contour, {}, &core::Vec3::y);
  EXPECT_NEAR(near->y, -50.0 + height_m / std::tan(45.0 * deg), 1e-6);
  EXPECT_NEAR(far->y, -50.0 + height_m / std::tan(35.0 * deg), 1e-6);
  // Abeam of the middle the half width seen from the antenna, at its distance.
  const auto side = std::ranges::max_element(contour, {}, &core::Vec3::x);
  EXPECT_NEAR(side->x - 100.0, height_m / std::sin(40.0 * deg) * std::tan(1.5 * deg), 1.5);
}

TEST(Footprint, IsNoneWhereSomeOfTheBeamMissesTheGroundOrThereIsNoBeam) {
  EXPECT_TRUE(footprint_of(radar_at({0.0, 0.0, 1000.0}, 3.0 * deg, 2.0 * deg, 10.0 * deg), {}).empty());
  Snapshot::Radar round = radar_at({0.0, 0.0, 1000.0}, 40.0 * deg, 2.0 * deg, 2.0 * deg);
  round.isotropic = true;
  EXPECT_TRUE(footprint_of(round, {}).empty());
}

TEST(Footprint, OfASatelliteLiesOnTheEllipsoid) {
  scene::World world;
  world.frame = scene::World::Frame::earth;
  world.latitude = core::Angle::from_deg(45.0);
  world.longitude = core::Angle::from_deg(7.0);
  const auto earth = scene::earth_of(world);
  ASSERT_TRUE(earth.has_value());
  const Snapshot::Radar radar = radar_at({0.0, 0.0, 700e3}, 60.0 * deg, 0.3 * deg, 3.0 * deg);
  const auto contour = footprint_of(radar, earth);
  ASSERT_EQ(contour.size(), 64U);
  for (const core::Vec3& point : contour) EXPECT_NEAR(earth->geodetic_of(point).height_m, 0.0, 2e-3);
  const auto arc = range_on_ground(radar, 820e3, earth);
  ASSERT_FALSE(arc.empty());
  for (const core::Vec3& point : arc) {
    EXPECT_NEAR(core::norm(point - radar.position_world_m), 820e3, 1.0);
    EXPECT_NEAR(earth->geodetic_of(point).height_m, 0.0, 2e-3);
  }
}

TEST(RangeOnGround, IsAnArcAtTheSlantRange) {
  const Snapshot::Radar radar = radar_at({0.0, 0.0, 3000.0}, 30.0 * deg, 4.0 * deg, 20.0 * deg);
  const auto arc = range_on_ground(radar, 5000.0, {});
  ASSERT_EQ(arc.size(), 25U);
  for (const core::Vec3& point : arc) {
    EXPECT_NEAR(point.z, 0.0, 1e-9);
    EXPECT_NEAR(std::hypot(point.x, point.y), 4000.0, 0.01);
  }
  EXPECT_NEAR(arc.back().x, 4000.0 * std::sin(4.0 * deg), 0.1);
  EXPECT_TRUE(range_on_ground(radar, 2999.0, {}).empty());
}

}  // namespace footprint_test
}  // namespace sarsim::picture
