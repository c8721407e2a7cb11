#include "workflow/image/map_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::workflow {
namespace map_fields_test {

radar::EarthFrame earth_at(double latitude_deg, double longitude_deg, double heading_deg = 0.0) {
  return radar::EarthFrame(
      {{core::rad_per_deg * latitude_deg, core::rad_per_deg * longitude_deg, 0.0}, core::rad_per_deg * heading_deg});
}

// 201 lines of 101 samples about the anchor. Lines go on `along`, samples on `across`.
signal::FocusedImage grid_of(const core::Vec3& along, const core::Vec3& across, double line_m, double sample_m) {
  signal::FocusedImage grid;
  grid.frame = {signal::ImagePlane::ground_grid, {}, along, across, 100.0};
  grid.azimuth = {-100.0 * line_m, line_m, 201, 0.0};
  grid.range = {-50.0 * sample_m, sample_m, 101, 0.0};
  return grid;
}

std::string field(const std::vector<std::pair<std::string, std::string>>& fields, const std::string& name) {
  for (const auto& [key, value] : fields)
    if (key == name) return value;
  return {};
}

const core::Vec3 east{1.0, 0.0, 0.0};
const core::Vec3 north{0.0, 1.0, 0.0};
const core::Vec3 south{0.0, -1.0, 0.0};

TEST(MapFields, HaveStepsOfTheMap) {
  const auto map = grid_on_map(grid_of(north, east, 2.0, 3.0), earth_at(52.3, 13.4));
  ASSERT_TRUE(map);
  const double scale = map->middle.scale;
  const double turn = map->middle.convergence_rad;
  // East and north of the ground lie to the left of the grid's by the convergence. The tangent plane is level at the
  // anchor; steps over 400 m are as long as those on the ellipsoid within (200 m/R)^2, and the scale changes by as
  // much.
  EXPECT_NEAR(map->sample_east_m, 3.0 * scale * std::cos(turn), 1e-8);
  EXPECT_NEAR(map->sample_north_m, 3.0 * scale * std::sin(turn), 1e-8);
  EXPECT_NEAR(map->line_east_m, -2.0 * scale * std::sin(turn), 1e-8);
  EXPECT_NEAR(map->line_north_m, 2.0 * scale * std::cos(turn), 1e-8);
}

TEST(MapFields, SayHowFarThePlaneIsFromTheMapAndTheEllipsoid) {
  const auto near = grid_on_map(grid_of(north, east, 2.0, 3.0), earth_at(52.3, 13.4));
  const auto far = grid_on_map(grid_of(north, east, 200.0, 300.0), earth_at(52.3, 13.4));
  ASSERT_TRUE(near && far);
  // d^2/2R at the corners, 250 m and 25 km away.
  EXPECT_NEAR(near->highest_height_m, 250.0 * 250.0 / (2.0 * 6.378e6), 1e-4);
  EXPECT_NEAR(near->lowest_height_m, 0.0, 1e-9);
  EXPECT_NEAR(far->highest_height_m, 25e3 * 25e3 / (2.0 * 6.378e6), 0.5);
  // The scale changes by x/R^2 per metre, x = 109 km from the middle of the zone: half of it times d^2 is 0.3 m at the
  // eastern edge, 15 km away, and a ten thousandth of it at that of the small grid.
  EXPECT_GT(far->error_m, 0.3);
  EXPECT_LT(far->error_m, 3.0);
  EXPECT_LT(near->error_m, 3e-4);
}

TEST(MapFields, OfGridsThatAreNotMirroredHaveMapInfo) {
  const auto earth = earth_at(0.0, 15.0);  // Grid north is true north here.
  const auto fields = map_fields(grid_of(south, east, 2.0, 3.0), earth);
  // The outer corner of the first pixel: 151.5 m west and 201 m north of the anchor, on the map 0.9996 of it.
  EXPECT_EQ(field(fields, "map info").substr(0, 29), "UTM, 1, 1, 499848.5606, 200.9");
  EXPECT_NE(field(fields, "map info").find(", 33, North, WGS-84, units=Meters, rotation="), std::string::npos);
  EXPECT_EQ(field(fields, "utm zone"), "33 North");
  EXPECT_TRUE(field(map_fields(grid_of(north, east, 2.0, 3.0), earth), "map info").empty());
  // Turned by the heading: pixels that are not square are read in two ways.
  EXPECT_TRUE(field(map_fields(grid_of(south, east, 2.0, 3.0), earth_at(0.0, 15.0, 30.0)), "map info").empty());
  EXPECT_NE(
      field(map_fields(grid_of(south, east, 2.0, 2.0), earth_at(0.0, 15.0, 30.0)), "map info").find("rotation=-30.0"),
      std::string::npos);
}

TEST(MapFields, HaveGeoPointsOfTheCorners) {
  const auto grid = grid_of(north, east, 2.0, 3.0);
  const auto earth = earth_at(52.3, 13.4);
  const std::string points = field(map_fields(grid, earth), "geo points");
  const radar::Geodetic last = earth.geodetic_of({150.0, 200.0, 0.0});
  EXPECT_TRUE(points.starts_with("1.5, 1.5, 52.29"));
  EXPECT_NE(points.find(", 101.5, 1.5, "), std::string::npos);
  EXPECT_NE(points.find(", 1.5, 201.5, "), std::string::npos);
  EXPECT_TRUE(points.ends_with(fmt::format("101.5, 201.5, {:.11f}, {:.11f}", core::deg_per_rad * last.latitude_rad,
                                           core::deg_per_rad * last.longitude_rad)));
}

TEST(MapFields, BeyondUtmHaveGeoPointsAlone) {
  const auto fields = map_fields(grid_of(north, east, 2.0, 3.0), earth_at(86.0, 13.4));
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].first, "geo points");
}

double number_fact(const raster::Facts& facts, const std::string& name) {
  for (const auto& [key, value] : facts)
    if (key == name && std::holds_alternative<double>(value)) return std::get<double>(value);
  ADD_FAILURE() << name << " is missing";
  return 0.0;
}

std::string text_fact(const raster::Facts& facts, const std::string& name) {
  for (const auto& [key, value] : facts)
    if (key == name && std::holds_alternative<std::string>(value)) return std::get<std::string>(value);
  return {};
}

TEST(GridFacts, SayTheMapWithItsTurnAndMirror) {
  const auto earth = earth_at(0.0, 15.0);
  const GridFacts facts = grid_facts(grid_of(north, east, 2.0, 3.0), earth);
  EXPECT_EQ(text_fact(facts.map, "spatial_ref"), "EPSG:32633");
  EXPECT_EQ(number_fact(facts.map, "longitude_of_central_meridian"), 15.0);
  EXPECT_EQ(number_fact(facts.map, "false_northing"), 0.0);
  // The outer corner of the first pixel: 151.5 m west and 201 m south of the anchor, on the map 0.9996 of it.
  std::istringstream numbers(text_fact(facts.map, "GeoTransform"));
  std::array<double, 6> transform{};
  for (double& number : transform) ASSERT_TRUE(numbers >> number);
  EXPECT_NEAR(transform[0], 500e3 - 0.9996 * 151.5, 1e-3);
  EXPECT_NEAR(transform[1], 0.9996 * 3.0, 1e-6);
  EXPECT_NEAR(transform[2], 0.0, 1e-6);
  EXPECT_NEAR(transform[3], -0.9996 * 201.0, 1e-3);
  EXPECT_NEAR(transform[4], 0.0, 1e-6);
  EXPECT_NEAR(transform[5], 0.9996 * 2.0, 1e-6);
  EXPECT_EQ(text_fact(grid_facts(grid_of(north, east, 2.0, 3.0), earth_at(-34.0, 18.5)).map, "spatial_ref"),
            "EPSG:32734");
  EXPECT_TRUE(grid_facts(grid_of(north, east, 2.0, 3.0), earth_at(87.0, 15.0)).map.empty());
}

TEST(GridFacts, SayTheBoundsAlsoAcrossTheDateLine) {
  const auto grid = grid_of(north, east, 2.0, 3.0);
  const raster::Facts facts = grid_facts(grid, earth_at(0.0, 180.0)).file;
  const double half_deg = core::deg_per_rad * 150.0 / 6'378'137.0;
  EXPECT_NEAR(number_fact(facts, "geospatial_lon_min"), 180.0 - half_deg, 1e-7);
  EXPECT_NEAR(number_fact(facts, "geospatial_lon_max"), -180.0 + half_deg, 1e-7);
  EXPECT_NEAR(number_fact(facts, "geospatial_lat_max"), -number_fact(facts, "geospatial_lat_min"), 1e-9);
  EXPECT_NEAR(number_fact(facts, "geospatial_lat_max"), core::deg_per_rad * 200.0 / 6'335'439.0, 1e-7);
  EXPECT_NEAR(number_fact(facts, "geospatial_vertical_max"), 250.0 * 250.0 / (2.0 * 6.378e6), 1e-4);
  // Around the grid and back: first line from its first sample to its last, then the last line.
  const std::string bounds = text_fact(grid_facts(grid, earth_at(10.0, 20.0)).file, "geospatial_bounds");
  EXPECT_EQ(std::ranges::count(bounds, ','), 4);
  EXPECT_EQ(bounds.substr(0, 16), "POLYGON ((9.9981") << bounds;
  EXPECT_EQ(bounds.substr(10, bounds.find(',') - 10), bounds.substr(bounds.rfind(',') + 2, bounds.find(',') - 10));
}

}  // namespace map_fields_test
}  // namespace sarsim::workflow
