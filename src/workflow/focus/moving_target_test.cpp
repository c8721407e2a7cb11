#include <gtest/gtest.h>

#include <cmath>

#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/sar_theory.hpp"

namespace sarsim::workflow {
namespace moving_target_test {

// Simulated, compressed and focused: a target that recedes from the track appears R u/v behind where it is
// (R. K. Raney, IEEE Trans. AES-7, 1971).
TEST(MovingTarget, IsDisplacedByRangeTimesRecessionOverSpeedWithinATenthOfACell) {
  for (const double recession_mps : {-4.0, 1.5, 3.0}) {
    scene::Scene scene = sar_scene(600.0, {});
    const double closest_m = std::hypot(10000.0, 2000.0);
    // Along the ground by so much that the slant range changes by the recession.
    scene.platforms.push_back(simulate::moving("Car", {}, {recession_mps * closest_m / 10000.0, 0.0, 0.0}));
    scene.targets.push_back(simulate::target_on("Car", {}));
    const auto [acquisition, rows] = sar_recording(scene);
    const signal::ImagePlace resting = signal::place_of(signal::image_of(rows, {}).frame, {});
    const double shift_m = closest_m * recession_mps / 200.0;
    const signal::PointResponse found = focused_point(rows, {resting.azimuth_m - shift_m, resting.range_m});
    // 400 m of flight make a cell of lambda R/(2 L) = 0.72 m.
    const double cell_m = 0.5 * core::exact_light_speed_mps / 5.3e9 * closest_m / 400.0;
    EXPECT_NEAR(found.place.azimuth_m - resting.azimuth_m, -shift_m, 0.1 * cell_m) << recession_mps;
  }
}

// A car along the track is focused with the wrong rate: its peak is lower and wider, as theory says. One that
// accelerates away from the track does the same.
TEST(MovingTarget, HasTheLossAndTheWidthThatTheoryExpects) {
  struct Motion {
    core::Vec3 velocity_mps;
    double acceleration_mps2;
  };
  for (const Motion& motion :
       {Motion{{0.0, 0.45, 0.0}, 0.0}, Motion{{2.0, -0.55, 0.0}, 0.0}, Motion{{1.0, 0.0, 0.0}, 0.02}}) {
    scene::Scene scene = sar_scene(600.0, {});
    scene.platforms.push_back(simulate::moving("Car", {}, motion.velocity_mps));
    if (motion.acceleration_mps2 != 0.0) {
      std::vector<core::Knot> along;
      for (double t = -1.2; t <= 1.2; t += 0.01)
        along.push_back({t, motion.velocity_mps.x * t + 0.5 * motion.acceleration_mps2 * t * t});
      scene.platforms.back().trajectory_m.part[0] = simulate::lines(along);
    }
    scene.targets.push_back(simulate::target_on("Car", {}));
    const auto [acquisition, rows] = sar_recording(scene);
    const TargetTheory theory = theory_of_targets(*acquisition, rows, {}).at(0);
    const double whole = sar_targets(*acquisition, rows).at(0).amplitude;
    const signal::PointResponse found = focused_point(rows, theory.place);
    const double cell_m = 0.72;
    EXPECT_LT(theory.amplitude, 0.95 * whole);
    EXPECT_NEAR(20.0 * std::log10(found.amplitude / theory.amplitude), 0.0, 0.2) << motion.velocity_mps.y;
    EXPECT_NEAR(found.place.azimuth_m, theory.place.azimuth_m, 0.1 * cell_m) << motion.velocity_mps.y;
    ASSERT_TRUE(theory.azimuth);
    EXPECT_GT(theory.azimuth->width, 0.67);
    EXPECT_NEAR(found.azimuth.width / theory.azimuth->width, 1.0, 0.05) << motion.velocity_mps.y;
  }
}

}  // namespace moving_target_test
}  // namespace sarsim::workflow
