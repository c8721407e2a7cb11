#include "workflow/focus/motion_residual.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/reference_track.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_test_script.hpp"
#include "workflow/focus/sar_test_scene.hpp"

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
  [[nodiscard]] static std::complex<double> response(const FocusReport& report, double azimuth_m) {
    const auto [plan, rows] = sar_recording(swaying_scene());
    const signal::FocusedImage image = signal::in_memory(report.image);
    signal::ImagePlace place = signal::place_of(image.frame, {0.0, 30.0, 0.0});
    const double turns = 2.0 * place.range_m * image.carrier_hz / image.light_speed_mps;
    place.azimuth_m += azimuth_m;
    return signal::test::value_at(image, place) *
           std::polar(1.0 / sar_targets(*plan, rows).at(1).amplitude, 2.0 * core::pi * turns);
  }
};

TEST_F(MotionResidualOfASquint, IsWhatTheImageLoses) {
  request_.algorithm = FocusAlgorithm::omega_k;
  const FocusReport report = focus(request_, {});
  FocusInput input = open_focus_input(request_.input, {});
  TakenFlight flight{.kind = TakenFlight::Kind::compensated,
                     .how = compensation_of(input, MotionOrder::second, 0.0, report.options)};
  flight.carrier_per_m = report.options.doppler_centroid_hz / report.image.image.frame.speed_mps;
  const auto residual = worst_motion_residual(*input.plan, input.echoes, flight);
  ASSERT_TRUE(residual);
  // Carried to its place as `measure` does.
  const std::complex<double> found = response(report, residual->azimuth_m) *
                                     std::polar(1.0, -2.0 * core::pi * flight.carrier_per_m * residual->azimuth_m);
  ASSERT_EQ(residual->target, 1U);
  EXPECT_GT(residual->rms_rad, 0.5);
  EXPECT_NEAR(residual->amplitude, std::abs(found), 0.005);
  EXPECT_NEAR(residual->phase_rad, std::arg(found), 0.01);
  EXPECT_LT(residual->amplitude, 0.9);
  ASSERT_FALSE(report.problems.empty());
  EXPECT_THAT(report.problems[0].message,
              HasSubstr("leaves 0.55 rad rms in the echoes of target 2: its peak loses 1.3 dB"));
  EXPECT_THAT(report.problems[0].hint, HasSubstr("--algorithm back-projection"));
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
