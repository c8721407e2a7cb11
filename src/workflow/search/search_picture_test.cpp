#include "workflow/search/search_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/report/invalid_request.hpp"
#include "workflow/search/search_test_scene.hpp"

namespace sarsim::workflow {
namespace search_picture_test {

// A beam of 4 degrees that turns once in 1000 pulses, on a platform at a height, over one target on the ground.
scene::Scene turning_scene(double height_m, const core::Vec3& target_m, double turns = 1.0) {
  scene::Scene scene;
  scene.platforms.push_back(simulate::resting("Earth", {}));
  scene.platforms.push_back(simulate::resting("Plane", {100.0, -200.0, height_m}));
  scene.targets.push_back(simulate::target_on("Earth", target_m));
  scene::Radar radar;
  radar.platform = "Plane";
  radar.pulse_width_s = 0.5e-6;
  radar.prf_hz = 1000.0;
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(4.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(80.0);
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_elevation = core::Angle::from_deg(-30.0);
  radar.beam_rate = core::Angle::from_deg(360.0);
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 2500.0;
  simulation.range_end_m = 6000.0;
  simulation.time_end_s = turns - 0.0005;
  simulation.sample_rate_hz = 2e6;
  scene.simulations.push_back(simulation);
  return scene;
}

struct Painted {
  core::Vec3 place_m;  // of the brightest pixel
  std::size_t lines = 0;
  std::size_t scans = 0;
  std::size_t pixels = 0;  // above half of it
};

Painted painted(const scene::Scene& scene, const PictureArguments& arguments, std::size_t pulses = 5) {
  const PulseRows rows = pulse_rows_of(scene);
  SearchOptions options;
  options.pulses = pulses;
  options.detect = false;
  SearchPicture picture(rows, arguments);
  each_interval(rows, options, {2, nullptr}, {}, [&](const SearchInterval& interval) { picture.take(interval); });
  picture.finish();
  const auto& values = picture.picture().values();
  const signal::PpiGrid& grid = picture.picture().grid();
  const auto at = static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
  Painted result;
  result.place_m = {grid.x_m(at % grid.columns), grid.y_m(at / grid.columns), 0.0};
  result.lines = picture.lines();
  result.scans = picture.scans();
  result.pixels =
      static_cast<std::size_t>(std::ranges::count_if(values, [&](float value) { return value > 0.5F * values[at]; }));
  return result;
}

TEST(SearchPicture, ShowsTargetsOnTheGroundBelowARadarInTheAir) {
  // 4 km along the ground and 3 km below are 5 km of slant range.
  const core::Vec3 target_m{100.0 + 4000.0 * std::sin(2.2), -200.0 + 4000.0 * std::cos(2.2), 0.0};
  const Painted picture = painted(turning_scene(3000.0, target_m), {});
  // A sample of 75 m of slant range is 94 m on the ground; the beam is met within half a line, 0.9 degrees.
  EXPECT_NEAR(std::hypot(picture.place_m.x - 100.0, picture.place_m.y + 200.0), 4000.0, 110.0);
  EXPECT_NEAR(std::atan2(picture.place_m.x - 100.0, picture.place_m.y + 200.0), 2.2, 0.025);
  EXPECT_EQ(picture.lines, 200u);
  EXPECT_EQ(picture.scans, 1u);
}

TEST(SearchPicture, ShowsThePlaneOfItsHeight) {
  const core::Vec3 target_m{100.0, 3800.0, 1000.0};
  PictureArguments arguments;
  arguments.height_m = 1000.0;
  EXPECT_NEAR(painted(turning_scene(3000.0, target_m), arguments).place_m.y, 3800.0, 110.0);
  // On the ground the same slant range is nearer: sqrt(4000^2 + 2000^2 - 3000^2) = 3317 m away.
  EXPECT_NEAR(painted(turning_scene(3000.0, target_m), {}).place_m.y, 3117.0, 120.0);
}

TEST(SearchPicture, ChoosesATurn) {
  // 600 m/s away from a radar at (100, -200): the beam meets it in the south, at 0.5, 1.5 and 2.5 s.
  scene::Scene scene = turning_scene(0.0, {}, 3.0);
  scene.platforms.push_back(simulate::moving("Boat", {100.0, -3700.0, 0.0}, {0.0, -600.0, 0.0}));
  scene.targets[0] = simulate::target_on("Boat", {});
  for (std::size_t scan = 0; scan < 3; ++scan) {
    PictureArguments arguments;
    arguments.scan = scan;
    const Painted picture = painted(scene, arguments, 1);
    EXPECT_EQ(picture.scans, 3u);
    EXPECT_EQ(picture.lines, 3000u);
    EXPECT_NEAR(picture.place_m.y, -3700.0 - 600.0 * (0.5 + static_cast<double>(scan)), 120.0) << scan;
  }
  // All turns together: the nearest echo is the strongest.
  EXPECT_NEAR(painted(scene, {}, 1).place_m.y, -4000.0, 120.0);
}

TEST(SearchPicture, DrawsABeamThatStandsStillAsWideAsItIs) {
  scene::Scene scene = turning_scene(0.0, {100.0, 3800.0, 0.0});
  scene.radars[0].beam = scene::Radar::Beam::fixed;
  scene.radars[0].beam_elevation = core::Angle();
  const Painted still = painted(scene, {}, 100);
  EXPECT_EQ(still.scans, 1u);
  EXPECT_NEAR(still.place_m.x, 100.0, 4000.0 * 2.1 * core::pi / 180.0);
  EXPECT_NEAR(still.place_m.y, 3800.0, 100.0);
  // One cell of range and 4 degrees are 75 m by 279 m, on pixels of 75 m.
  EXPECT_GE(still.pixels, 3u);
  EXPECT_LE(still.pixels, 8u);
}

TEST(PictureGrid, RefusesWhatCannotBeShown) {
  const PulseRows rows = pulse_rows_of(turning_scene(3000.0, {100.0, 3800.0, 0.0}));
  const auto refuses = [&](const PictureArguments& arguments) {
    EXPECT_THROW((void)picture_grid(rows, arguments), core::InvalidRequest);
  };
  refuses({.pixel_m = 0.0});
  refuses({.pixel_m = 0.01});
  refuses({.extent_m = -1.0});
  refuses({.height_m = 10000.0});
  const signal::PpiGrid grid = picture_grid(rows, {.pixel_m = 50.0, .extent_m = 1000.0});
  EXPECT_EQ(grid.columns, 41u);
  EXPECT_EQ(grid.x_m(20), 100.0);
}

TEST(GroundRange, IsThatOfPythagoras) {
  EXPECT_NEAR(ground_range_m(5000.0, 3000.0), 4000.0, 1e-9);
  EXPECT_NEAR(ground_range_m(5000.0, -3000.0), 4000.0, 1e-9);
  EXPECT_EQ(ground_range_m(2000.0, 3000.0), 0.0);
}

}  // namespace search_picture_test
}  // namespace sarsim::workflow
