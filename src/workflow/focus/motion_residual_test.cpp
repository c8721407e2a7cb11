#include "workflow/focus/motion_residual.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_test_script.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/sar_theory.hpp"

namespace sarsim::workflow {
namespace motion_residual_test {

using testing::HasSubstr;

// X band from 3.2 km, 15 degrees ahead; the track sways by half a metre to the side.
scene::Scene swaying_scene() {
  scene::Scene scene = sar_scene(800.0, {{0.0, 0.0, 0.0}, {0.0, 30.0, 0.0}}, 0.8);
  const double ground_m = 2900.0;
  const double behind_m = std::hypot(ground_m, 1000.0) * std::tan(core::pi / 12.0);
  scene.platforms[1] = simulate::moving("Plane", {-ground_m, -behind_m, 1000.0}, {0.0, 100.0, 0.0});
  std::vector<core::Knot> sway;
  for (double t = -1.0; t < 1.0; t += 0.002) sway.push_back({t, -ground_m + 0.5 * std::sin(2.0 * core::pi * t / 1.3)});
  scene.platforms[1].trajectory_m.part[0] = simulate::lines(sway);
  scene.radars[0].carrier_hz = 9.6e9;
  scene.radars[0].pulse_width_s = 5e-6;
  scene.simulations[0].range_start_m = 3100.0;
  scene.simulations[0].range_end_m = 3300.0;
  return scene;
}

class MotionResidualOfASquint : public FocusOfScript {
 protected:
  MotionResidualOfASquint() : FocusOfScript(swaying_scene()) { request_.ground_m = 0.0; }

  // Of the second target, relative to the ideal one.
  [[nodiscard]] static std::complex<double> response(const FocusReport& report, double azimuth_m,
                                                     double range_m = 0.0) {
    const auto [acquisition, rows] = sar_recording(swaying_scene());
    const signal::FocusedImage image = signal::in_memory(report.image);
    signal::ImagePlace place = signal::place_of(image.frame, {0.0, 30.0, 0.0});
    const double turns = 2.0 * place.range_m * image.carrier_hz / image.light_speed_mps;
    place.azimuth_m += azimuth_m;
    place.range_m += range_m;
    return signal::test::value_at(image, place) *
           std::polar(1.0 / sar_targets(*acquisition, rows).at(1).amplitude, 2.0 * core::pi * turns);
  }
};

TEST_F(MotionResidualOfASquint, IsWhatTheImageLoses) {
  request_.algorithm = FocusAlgorithm::omega_k;
  const FocusReport report = focus(request_, {});
  FocusInput input = open_focus_input(request_.input, {});
  TakenFlight flight{.kind = TakenFlight::Kind::compensated,
                     .how = compensation_of(input, MotionOrder::second, 0.0, report.options)};
  flight.carrier_per_m = report.image.image.azimuth.spectrum_centre_per_m;
  flight.range_carrier_per_m = report.image.image.range.spectrum_centre_per_m;
  const auto residual = worst_motion_residual(*input.acquisition, input.echoes, flight);
  ASSERT_TRUE(residual);
  // Carried to its place as `measure` does.
  const double carried = flight.carrier_per_m * residual->azimuth_m + flight.range_carrier_per_m * residual->range_m;
  const std::complex<double> found =
      response(report, residual->azimuth_m, residual->range_m) * std::polar(1.0, -2.0 * core::pi * carried);
  ASSERT_EQ(residual->target, 1U);
  EXPECT_GT(residual->rms_rad, 0.5);
  EXPECT_NEAR(residual->amplitude, std::abs(found), 0.005);
  EXPECT_NEAR(residual->phase_rad, std::arg(found), 0.01);
  EXPECT_LT(residual->amplitude, 0.9);
  ASSERT_FALSE(report.problems.empty());
  EXPECT_THAT(report.problems[0].message,
              HasSubstr("leaves 0.55 rad rms residual phase at target 2: peak loss 1.3 dB"));
  EXPECT_THAT(report.problems[0].hint, HasSubstr("--algorithm back-projection"));
}

// Over 37 degrees of a climb that sways, with 2.5 MHz: moved in range by a part of its cell of 59 m a peak bends its
// phases so that they add up better. Along the track alone it would have the phase 0.04 rad.
TEST(MotionResidual, FollowsThePeakInRangeWhereTheBandIsNarrow) {
  const test::TestFolder folder;
  test::put(folder / "climb.toml", R"(format = "sarsim 2"
[[platform]]
name = "Plane"
path = { type = "line", start = [0, 0, 71.336], velocity = [7.766922, 0, 1.289675] }
oscillations = [{ axis = "y", amplitude = "1.48215 m", frequency = "0.0422721 Hz", phase = "176.772 deg" }, { axis = "z", amplitude = "1.45077 m", frequency = "0.0431865 Hz", phase = "281.839 deg" }]
[[target]]
position = [11.845, 705.67, 0]
rcs = "100 m2"
[[radar]]
name = "Radar"
platform = "Plane"
pulse = { type = "chirp", bandwidth = "2.5288 MHz", width = "44.68 us" }
repetition = "20.53177 Hz"
carrier = "1.477216 GHz"
power = "1 kW"
antenna = { type = "sinx", elevation_width = "36.974 deg", azimuth_width = "36.974 deg" }
beam = { type = "fixed", elevation = "-5.7174 deg", azimuth = "-6.3047 deg" }
[[recording]]
radar = "Radar"
file = "echoes.h5"
format = "hdf5"
range = ["47.47 m", "7885 m"]
time = ["-7.598 s", "7.598 s"]
sample_rate = "4.26978 MHz"
)");
  FocusRequest request;
  request.input.path = (folder / "climb.toml").string();
  request.algorithm = FocusAlgorithm::omega_k;
  request.threads = 2;
  const FocusReport report = focus(request, {});
  const signal::FocusedImage image = signal::in_memory(report.image);
  FocusInput input = open_focus_input(request.input, {});
  TakenFlight flight{.kind = TakenFlight::Kind::compensated,
                     .how = compensation_of(input, MotionOrder::second, std::nullopt, report.options)};
  flight.carrier_per_m = image.azimuth.spectrum_centre_per_m;
  flight.range_carrier_per_m = image.range.spectrum_centre_per_m;
  const auto residual = worst_motion_residual(*input.acquisition, input.echoes, flight);
  ASSERT_TRUE(residual);
  const TargetTheory theory =
      theory_on_image({*input.acquisition, input.echoes, report.options, false, true}, image, {}).at(0);
  const auto found = signal::measure_point(image, signal::reader_of(image), theory.place, 20.0);
  ASSERT_TRUE(found);
  const double azimuth_m = found->place.azimuth_m - theory.place.azimuth_m;
  const double range_m = found->place.range_m - theory.place.range_m;
  const double carried = flight.carrier_per_m * azimuth_m + flight.range_carrier_per_m * range_m;
  EXPECT_NEAR(std::remainder(found->phase_rad - theory.phase_rad - 2.0 * core::pi * carried - residual->phase_rad,
                             2.0 * core::pi),
              0.0, 0.02);
  EXPECT_NEAR(20.0 * std::log10(found->amplitude / theory.amplitude), -residual->lost_db(), 0.06);
  EXPECT_GT(std::abs(residual->range_m), 0.2);
}

TEST_F(MotionResidualOfASquint, IsNotLookedAtWhereCompensationWasAskedFor) {
  request_.motion = MotionOrder::second;
  EXPECT_EQ(focus(request_, {}).algorithm, FocusAlgorithm::omega_k);
}

TEST_F(MotionResidualOfASquint, MakesAutoTakeBackProjection) {
  const FocusReport report = focus(request_, {});
  EXPECT_EQ(report.algorithm, FocusAlgorithm::back_projection);
  EXPECT_EQ(report.motion, MotionOrder::none);
  const std::complex<double> found = response(report, 0.0);
  EXPECT_NEAR(20.0 * std::log10(std::abs(found)), 0.0, 0.1);
  EXPECT_NEAR(std::arg(found), 0.0, 0.01);
  EXPECT_TRUE(std::ranges::any_of(report.problems, [](const core::Problem& problem) {
    return problem.message.find("back-projection instead of omega-k: motion compensation would leave") !=
           std::string::npos;
  }));
}

}  // namespace motion_residual_test
}  // namespace sarsim::workflow
