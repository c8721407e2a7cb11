#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <ostream>

#include "core/maths/constants.hpp"
#include "scene/script/writer.hpp"
#include "signal/sar/image_test_value.hpp"
#include "support/test_folder.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/seen_spectrum.hpp"

namespace sarsim::workflow {
namespace focus_grid_test {

using testing::HasSubstr;

// 20 degrees ahead at X band from 3 km, along 190 m of flight: range frequencies of 283 MHz, sampled at 150.
scene::Scene squinted_scene() {
  scene::Scene scene = sar_scene(1000.0, {{0.0, 0.0, 0.0}}, 0.95);
  const double ground_m = std::sqrt(3000.0 * 3000.0 - 1e6);
  scene.platforms[1] =
      simulate::moving("Plane", {-ground_m, -3000.0 * std::tan(core::pi / 9.0), 1000.0}, {0.0, 100.0, 0.0});
  scene.radars[0].carrier_hz = 9.6e9;
  scene.radars[0].pulse_width_s = 5e-6;
  scene.simulations[0].range_start_m = 3100.0;
  scene.simulations[0].range_end_m = 3300.0;
  return scene;
}

struct ImageCase {
  const char* name;
  FocusAlgorithm algorithm;
  FocusGrid grid = FocusGrid::slant;
};

void PrintTo(const ImageCase& one, std::ostream* out) { *out << one.name; }

class FocusGridOf : public testing::TestWithParam<ImageCase> {};

INSTANTIATE_TEST_SUITE_P(Methods, FocusGridOf,
                         testing::Values(ImageCase{"OmegaK", FocusAlgorithm::omega_k},
                                         ImageCase{"RangeDoppler", FocusAlgorithm::range_doppler},
                                         ImageCase{"ChirpScaling", FocusAlgorithm::chirp_scaling},
                                         ImageCase{"BackProjection", FocusAlgorithm::back_projection},
                                         ImageCase{"Ground", FocusAlgorithm::back_projection, FocusGrid::ground}),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(FocusGridOf, HoldsASquintedSpectrumAndSaysWhichSpacingItTook) {
  const test::TestFolder folder;
  std::ofstream(folder / "sar.scr") << scene::write_script(squinted_scene());
  FocusRequest request;
  request.input.path = (folder / "sar.scr").string();
  request.algorithm = GetParam().algorithm;
  request.grid = GetParam().grid;
  request.ground_m = 0.0;
  request.threads = 2;
  const FocusReport report = focus(request, {});
  const signal::FocusedImage image = signal::in_memory(report.image);
  const std::complex<double> value = signal::test::value_at(image, signal::place_of(image.frame, {}));
  // A point at 3190 m: the radar equation.
  const auto [acquisition, rows] = sar_recording(squinted_scene());
  const std::vector<SarTarget> targets = sar_targets(*acquisition, rows);
  EXPECT_NEAR(20.0 * std::log10(std::abs(value) / targets.at(0).amplitude), 0.0, 0.1);
  const double turns = 2.0 * 3000.0 * 9.6e9 / core::exact_light_speed_mps;
  EXPECT_NEAR(std::remainder(std::arg(value) + 2.0 * core::pi * turns, 2.0 * core::pi), 0.0, 0.01);
  const std::string spacing = fmt::format("columns {:.4g} m apart instead of 0.9", image.range.step_m);
  EXPECT_TRUE(std::ranges::any_of(report.problems, [&](const core::Problem& problem) {
    return problem.message.find(spacing) != std::string::npos;
  })) << spacing;
}

// A squinted response leans, so that its peak is read a little off its place: here 0.13 mm along the track and 0.3 mm
// across, by which the image's carrier turns by 0.009 rad.
TEST(SquintedImage, MeasuresThePhaseOfTheTargetsPlace) {
  const test::TestFolder folder;
  std::ofstream(folder / "sar.scr") << scene::write_script(squinted_scene());
  FocusRequest request;
  request.input.path = (folder / "sar.scr").string();
  request.output = folder / "sar.img";
  request.algorithm = FocusAlgorithm::omega_k;
  request.threads = 2;
  static_cast<void>(focus(request, {}));
  MeasureRequest measured;
  measured.image = request.output;
  measured.threads = 2;
  const MeasureReport report = measure(measured, {});
  ASSERT_EQ(report.targets.size(), 1U);
  const MeasuredTarget& target = report.targets[0];
  ASSERT_TRUE(target.found);
  // 3000 m is the closest distance of the line of flight.
  const double turns = 2.0 * 3000.0 * 9.6e9 / core::exact_light_speed_mps;
  EXPECT_NEAR(std::remainder(target.found->phase_rad + 2.0 * core::pi * turns, 2.0 * core::pi), 0.0, 0.002);
  EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.002);
  EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.1);
}

// From a steep flight the sine of the angle of incidence goes from 0.16 to 0.43: the spectra of the three points on the
// ground are centred a cycle per metre apart.
TEST(SquintedImage, MeasuresTargetsOfAGroundGridByTheirOwnSpectra) {
  const test::TestFolder folder;
  scene::Scene scene = squinted_scene();
  scene.targets = sar_scene(1000.0, {{-300.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {600.0, 0.0, 0.0}}).targets;
  scene.platforms[1] = simulate::moving(
      "Plane", {-std::sqrt(9e6 - 2900.0 * 2900.0), -3000.0 * std::tan(core::pi / 9.0), 2900.0}, {0.0, 100.0, 0.0});
  scene.simulations[0].range_end_m = 3500.0;
  std::ofstream(folder / "sar.scr") << scene::write_script(scene);
  FocusRequest request;
  request.input.path = (folder / "sar.scr").string();
  request.output = folder / "sar.img";
  request.algorithm = FocusAlgorithm::back_projection;
  request.grid = FocusGrid::ground;
  request.ground_m = 0.0;
  request.threads = 2;
  static_cast<void>(focus(request, {}));
  MeasureRequest measured;
  measured.image = request.output;
  measured.threads = 2;
  const MeasureReport report = measure(measured, {});
  ASSERT_EQ(report.targets.size(), 3U);
  for (const MeasuredTarget& target : report.targets) {
    ASSERT_TRUE(target.found) << target.theory.target;
    EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.02) << target.theory.target;
    EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.1) << target.theory.target;
    EXPECT_NEAR(target.found->place.azimuth_m, target.theory.place.azimuth_m, 0.02) << target.theory.target;
    EXPECT_NEAR(target.found->place.range_m, target.theory.place.range_m, 0.1) << target.theory.target;
  }
}

TEST(FocusGridSteps, StayThoseOfTheRecordingWhereTheyHoldTheSpectrum) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{0.0, 0.0, 0.0}}));
  signal::FocusOptions options;
  const signal::FocusedImage coarse = signal::image_of(rows, options);
  options.spectrum = seen_spectrum(*acquisition, rows, {}, SeenPulses::sampled);
  ASSERT_TRUE(options.spectrum);
  const signal::FocusedImage image = signal::image_of(rows, options);
  EXPECT_EQ(image.range.step_m, coarse.range.step_m);
  EXPECT_EQ(image.azimuth.step_m, coarse.azimuth.step_m);
  EXPECT_EQ(image.range.spectrum_centre_per_m, coarse.range.spectrum_centre_per_m);
  // 100 MHz seen over 400 m from 10.2 km: +-20 mrad.
  const double per_m = 2.0 * 5.3e9 / core::exact_light_speed_mps;
  EXPECT_NEAR(options.spectrum->azimuth.width_per_m(), per_m * 2.0 * std::sin(std::atan(200.0 / 10198.0)), 0.02);
  EXPECT_NEAR(options.spectrum->range.width_per_m(), 2.0 * 100e6 / core::exact_light_speed_mps, 0.01);
}

}  // namespace focus_grid_test
}  // namespace sarsim::workflow
