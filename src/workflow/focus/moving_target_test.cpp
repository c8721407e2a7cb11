#include <gtest/gtest.h>

#include <cmath>

#include "workflow/focus/sar_test_scene.hpp"

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
    const auto [plan, rows] = sar_recording(scene);
    const signal::ImagePlace resting = signal::place_of(signal::image_of(rows, {}).frame, {});
    const double shift_m = closest_m * recession_mps / 200.0;
    const signal::PointResponse found = focused_point(rows, {resting.azimuth_m - shift_m, resting.range_m});
    // 400 m of flight make a cell of lambda R/(2 L) = 0.72 m.
    const double cell_m = 0.5 * core::exact_light_speed_mps / 5.3e9 * closest_m / 400.0;
    EXPECT_NEAR(found.place.azimuth_m - resting.azimuth_m, -shift_m, 0.1 * cell_m) << recession_mps;
  }
}

}  // namespace moving_target_test
}  // namespace sarsim::workflow
