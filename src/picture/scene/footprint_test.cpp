#include "picture/scene/footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "picture/scene/half_power.hpp"
#include "picture/scene/snapshot_maker.hpp"
#include "picture/scene/track_figure.hpp"
#include "scene/model/world_frame.hpp"
#include "simulate/resolve/resolved.hpp"

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

// The half-power outline of a sin(x)/x antenna that looks as `radar_at` does.
std::vector<std::optional<core::Vec3>> edges_of(double depression_rad, double azimuth_width_rad,
                                                double elevation_width_rad) {
  radar::AntennaPattern pattern;
  pattern.kind = radar::AntennaPattern::Kind::sinx;
  pattern.azimuth_beamwidth_rad = azimuth_width_rad;
  pattern.elevation_beamwidth_rad = elevation_width_rad;
  std::vector<std::optional<core::Vec3>> edges;
  for (const auto& offset : half_power_outline(pattern, radar::PatternRule::amplitude, 65)) {
    if (!offset) return {};
    const core::Vec3 off = core::direction(offset->azimuth_rad, offset->elevation_rad);
    const double c = std::cos(depression_rad);
    const double d = std::sin(depression_rad);
    edges.emplace_back(core::Vec3{off.x, c * off.y + d * off.z, -d * off.y + c * off.z});
  }
  return edges;
}

TEST(Footprint, LiesOnThePlaneBetweenTheEdgesOfTheBeam) {
  const double height_m = 2000.0;
  const auto points =
      ground_points({100.0, -50.0, height_m}, edges_of(40.0 * deg, 3.0 * deg, 10.0 * deg), std::nullopt);
  ASSERT_EQ(points.size(), 65U);
  double near_m = 1e9;
  double far_m = 0.0;
  double side_m = 0.0;
  for (const auto& point : points) {
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(point->z, 0.0, 1e-9);
    near_m = std::min(near_m, point->y + 50.0);
    far_m = std::max(far_m, point->y + 50.0);
    side_m = std::max(side_m, point->x - 100.0);
  }
  // Beamwidths are between half-power points.
  EXPECT_NEAR(near_m, height_m / std::tan(45.0 * deg), 5.0);
  EXPECT_NEAR(far_m, height_m / std::tan(35.0 * deg), 5.0);
  EXPECT_NEAR(side_m, height_m / std::sin(40.0 * deg) * std::tan(1.5 * deg), 1.5);
}

TEST(Footprint, HasGapsWhereTheBeamMissesTheGround) {
  const auto points = ground_points({0.0, 0.0, 1000.0}, edges_of(3.0 * deg, 2.0 * deg, 10.0 * deg), std::nullopt);
  ASSERT_EQ(points.size(), 65U);
  const auto missing = std::ranges::count_if(points, [](const auto& point) { return !point; });
  EXPECT_GT(missing, 10);
  EXPECT_LT(missing, 55);
}

TEST(Footprint, OfASatelliteLiesOnTheEllipsoid) {
  scene::World world;
  world.frame = scene::World::Frame::earth;
  world.latitude = core::Angle::from_deg(45.0);
  world.longitude = core::Angle::from_deg(7.0);
  const auto earth = scene::earth_of(world);
  ASSERT_TRUE(earth.has_value());
  const Snapshot::Radar radar = radar_at({0.0, 0.0, 700e3}, 60.0 * deg, 0.3 * deg, 3.0 * deg);
  const auto points = ground_points(radar.position_world_m, edges_of(60.0 * deg, 0.3 * deg, 3.0 * deg), earth);
  ASSERT_EQ(points.size(), 65U);
  for (const auto& point : points) {
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(earth->geodetic_of(*point).height_m, 0.0, 2e-3);
  }
  const auto arc = range_on_ground(radar, 820e3, earth);
  ASSERT_FALSE(arc.empty());
  for (const core::Vec3& point : arc) {
    EXPECT_NEAR(core::norm(point - radar.position_world_m), 820e3, 1.0);
    EXPECT_NEAR(earth->geodetic_of(point).height_m, 0.0, 2e-3);
  }
}

// What the workbench shows is what `sarsim plot --draw footprint` draws.
TEST(Footprint, OfASnapshotIsThatOfThePlot) {
  scene::Scene scene;
  scene::Platform& platform = scene.platforms.emplace_back();
  platform.position_m = {0.0, -3000.0, 2000.0};
  scene::Radar& radar = scene.radars.emplace_back();
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(4.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(9.0);
  radar.beam_elevation = core::Angle::from_deg(-33.0);
  const auto shown = SnapshotMaker(scene).at(0.0).radars.at(0).footprint_world_m;
  const Figure figure = footprint_figure(scene, simulate::resolve(scene), 0, {0.0, 1.0});
  const FigureCurve& drawn = figure.panels.at(0).curves.at(0);
  for (std::size_t quarter = 0; quarter <= 4; ++quarter) {
    ASSERT_TRUE(shown.at(16 * quarter).has_value());
    EXPECT_NEAR(shown[16 * quarter]->x, drawn.x.at(45 * quarter), 0.01);
    EXPECT_NEAR(shown[16 * quarter]->y, drawn.y.at(45 * quarter), 0.01);
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
