// Images of echoes through an atmosphere, which focusing does not correct: theory has them where they appear.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "core/maths/constants.hpp"
#include "scene/language/scene_writer.hpp"
#include "support/test_folder.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace ionosphere_focus_test {

constexpr double c = core::exact_light_speed_mps;
constexpr double carrier_hz = 1.257e9;
constexpr double height_m = 700e3;
constexpr double across_m = 400e3;
constexpr double speed_mps = 7500.0;

// L band from 806 km: 85 MHz, 1 s of straight flight past one point, or the second from `middle_s` on.
scene::Scene scene_at(double middle_s) {
  scene::Scene scene = sar_scene(1200.0, {{0.0, across_m, 0.0}}, 0.5);
  scene.platforms[1] = simulate::moving("Plane", {0.0, 0.0, height_m}, {speed_mps, 0.0, 0.0});
  scene.targets[0].rcs_m2 = 1e6;
  scene.radars[0].carrier_hz = carrier_hz;
  scene.radars[0].bandwidth_hz = 85e6;
  scene.radars[0].pulse_width_s = 5e-6;
  scene::Simulation& simulation = scene.simulations[0];
  const double range_m = std::hypot(across_m, height_m, speed_mps * middle_s);
  simulation.sample_rate_hz = 120e6;
  simulation.range_start_m = range_m - 150.0;
  simulation.range_end_m = range_m + 200.0;
  simulation.time_start_s += middle_s;
  simulation.time_end_s += middle_s;
  return scene;
}

// One way at the closest distance: electrons in a shell of a flat world, and N0 exp(-h/H) up to the radar.
double electrons_m(double tec_units) {
  return 40.3e16 * tec_units / (carrier_hz * carrier_hz) * std::hypot(across_m, height_m) / height_m;
}
double air_m(const scene::Atmosphere& air) {
  if (air.refraction == scene::Atmosphere::Refraction::none) return 0.0;
  return 1e-6 * air.refractivity * air.scale_height_m * std::hypot(across_m, height_m) / height_m;
}

struct Image {
  signal::ImageFrame frame;
  MeasuredTarget target;
};

Image measured(const scene::Scene& scene, FocusAlgorithm algorithm, FocusGrid grid = FocusGrid::slant) {
  const test::TestFolder folder;
  std::ofstream(folder / "scene.toml") << scene::write_format_2(scene);
  FocusRequest request;
  request.input.path = (folder / "scene.toml").string();
  request.output = folder / "image.img";
  request.algorithm = algorithm;
  request.grid = grid;
  request.threads = 2;
  (void)focus(request, {});
  MeasureRequest wanted;
  wanted.image = request.output;
  wanted.threads = 2;
  MeasureReport report = measure(wanted, {});
  return {report.frame, report.targets.at(0)};
}

class IonosphereImage : public testing::TestWithParam<FocusAlgorithm> {};

INSTANTIATE_TEST_SUITE_P(Methods, IonosphereImage,
                         testing::Values(FocusAlgorithm::omega_k, FocusAlgorithm::back_projection,
                                         FocusAlgorithm::range_doppler, FocusAlgorithm::chirp_scaling));

TEST_P(IonosphereImage, HasThePlaceOfTheGroupAndThePhaseOfThePhasePath) {
  for (const double tec_units : {3.0, 30.0, 31.0}) {
    scene::Scene scene = scene_at(0.0);
    scene.atmosphere.tec_units = tec_units;
    const auto [frame, target] = measured(scene, GetParam());
    ASSERT_TRUE(target.found) << tec_units;
    const double closest_m = std::hypot(across_m, height_m);
    const double group_m = electrons_m(tec_units);
    EXPECT_NEAR(target.found->place.range_m, closest_m + group_m, 0.01);
    EXPECT_NEAR(target.found->place.range_m, target.theory.place.range_m, 0.01);
    EXPECT_NEAR(target.found->place.azimuth_m, target.theory.place.azimuth_m, 0.05);
    EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.02);
    EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.05);
    const double turns = 2.0 * (closest_m - group_m) * carrier_hz / c;
    EXPECT_NEAR(std::remainder(target.found->phase_rad + 2.0 * core::pi * turns, 2.0 * core::pi), 0.0, 0.03);
  }
}

// Over a whole aperture near the ground the way through air grows in another way than the distance from where the
// target appears: that turns the sum by 0.08 rad.
TEST_P(IonosphereImage, HasThePhaseThatTheAirLeavesOverAnAperture) {
  scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}});
  scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
  const auto [frame, target] = measured(scene, GetParam());
  ASSERT_TRUE(target.found);
  EXPECT_NEAR(target.found->place.range_m, target.theory.place.range_m, 0.01);
  EXPECT_NEAR(target.found->place.azimuth_m, target.theory.place.azimuth_m, 0.01);
  EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.02);
  EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.05);
}

class IonosphereImageUnderSquint : public testing::TestWithParam<FocusAlgorithm> {};

INSTANTIATE_TEST_SUITE_P(Methods, IonosphereImageUnderSquint,
                         testing::Values(FocusAlgorithm::omega_k, FocusAlgorithm::back_projection));

// The air moves it along the track too where the beam looks ahead.
TEST_P(IonosphereImageUnderSquint, IsThatOfTheoryBehindTheWholeAtmosphere) {
  scene::Scene scene = scene_at(-4.0);
  scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
  scene.atmosphere.tec_units = 20.0;
  const auto [frame, target] = measured(scene, GetParam());
  ASSERT_TRUE(target.found);
  EXPECT_NEAR(target.found->place.range_m, std::hypot(across_m, height_m) + electrons_m(20.0) + air_m(scene.atmosphere),
              0.05);
  EXPECT_NEAR(target.found->place.range_m, target.theory.place.range_m, 0.02);
  EXPECT_NEAR(target.found->place.azimuth_m, target.theory.place.azimuth_m, 0.1);
  EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.02);
}

TEST(IonosphereGround, HasThePointWhereTheGroupPathMeetsTheGround) {
  scene::Scene scene = scene_at(0.0);
  scene.atmosphere.tec_units = 30.0;
  const auto [frame, target] = measured(scene, FocusAlgorithm::back_projection, FocusGrid::ground);
  ASSERT_TRUE(target.found);
  const double group_m = electrons_m(30.0);
  const double closest_m = std::hypot(across_m, height_m);
  const double on_ground_m = std::sqrt(std::pow(closest_m + group_m, 2) - height_m * height_m) - across_m;
  const signal::ImagePlace is_at = signal::place_of(frame, {0.0, across_m, 0.0});
  EXPECT_NEAR(std::abs(target.found->place.range_m - is_at.range_m), on_ground_m, 0.02);
  EXPECT_NEAR(target.found->place.range_m, target.theory.place.range_m, 0.01);
  EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.02);
}

}  // namespace ionosphere_focus_test
}  // namespace sarsim::workflow
