#include "picture/scene/ruler.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/scene/draw_scene.hpp"
#include "picture/scene/drawing.hpp"

namespace sarsim::picture {
namespace ruler_test {

constexpr double deg = core::rad_per_deg;

TEST(Ruler, OverAPlaneMeasuresTheTriangle) {
  const RulerReading reading = measured({{10.0, 20.0, 5.0}, {40.0, 60.0, 125.0}}, std::nullopt);
  EXPECT_DOUBLE_EQ(reading.distance_m, 130.0);
  EXPECT_DOUBLE_EQ(reading.ground_m, 50.0);
  EXPECT_DOUBLE_EQ(reading.height_m, 120.0);
  EXPECT_DOUBLE_EQ(reading.azimuth_rad, std::atan2(30.0, 40.0));
  EXPECT_DOUBLE_EQ(reading.elevation_rad, std::atan2(120.0, 50.0));
}

TEST(Ruler, OverTheEarthMeasuresAlongTheEllipsoid) {
  const radar::EarthFrame earth(radar::Anchor{{54.0 * deg, 10.0 * deg, 0.0}, 0.7});
  const auto north = measured(
      {earth.world_of({54.0 * deg, 10.0 * deg, 100.0}), earth.world_of({55.0 * deg, 10.0 * deg, 400.0})}, earth);
  EXPECT_NEAR(north.height_m, 300.0, 1e-6);
  EXPECT_NEAR(north.azimuth_rad, 0.0, 1e-9);
  // The arc of the meridian by its series.
  const double a = radar::wgs84_semi_major_m;
  const double f = radar::wgs84_flattening;
  const double e2 = f * (2.0 - f);
  double arc = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double s = std::sin((54.0 + (i + 0.5) / 1000.0) * deg);
    arc += a * (1.0 - e2) / std::pow(1.0 - e2 * s * s, 1.5) * deg / 1000.0;
  }
  EXPECT_NEAR(north.ground_m, arc, 1e-6 * arc);
  const auto east = measured({earth.world_of({0.0, 10.0 * deg, 0.0}), earth.world_of({0.0, 11.0 * deg, 0.0})}, earth);
  EXPECT_NEAR(east.ground_m, a * deg, 1e-6 * arc);
  EXPECT_NEAR(east.azimuth_rad, 90.0 * deg, 1e-9);
  // The ground falls away by half the angle between the two.
  EXPECT_NEAR(east.elevation_rad, -0.5 * deg, 1e-6);
}

TEST(Ruler, WordsSayAllOfIt) {
  const auto words = ruler_words({1250.0, 1200.0, -30.0, -45.0 * deg, -1.4 * deg});
  EXPECT_EQ(words,
            (std::vector<std::string>{"1.25 km", "ground 1.2 km  height −30 m", "azimuth 315.00°  elevation −1.40°"}));
}

TEST(Ruler, IsTakenByTheNearerEnd) {
  Camera above = preset(Camera::start(800.0, 600.0), ViewPreset::top);
  above.pixels_per_m = 1.0;
  const Ruler ruler{{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}};
  EXPECT_EQ(ruler_end_at(ruler, above, 402.0, 301.0, 6.0), 0);
  EXPECT_EQ(ruler_end_at(ruler, above, 498.0, 299.0, 6.0), 1);
  EXPECT_FALSE(ruler_end_at(ruler, above, 450.0, 300.0, 6.0));
}

TEST(Ruler, IsDrawnWithItsWords) {
  DrawingOptions options;
  options.coordinate_systems = options.corner_triad = false;
  options.ruler = Ruler{{0.0, 0.0, 0.0}, {3000.0, 0.0, 4000.0}};
  options.ruler_words = ruler_words(measured(*options.ruler, std::nullopt));
  Drawing drawing;
  draw_scene({}, Camera::start(800.0, 600.0), options, drawing);
  EXPECT_EQ(drawing.discs.size(), std::size_t{2});
  EXPECT_EQ(drawing.lines.size(), std::size_t{3});
  ASSERT_EQ(drawing.texts.size(), std::size_t{3});
  EXPECT_EQ(drawing.texts[0].text, "5 km");
}

}  // namespace ruler_test
}  // namespace sarsim::picture
