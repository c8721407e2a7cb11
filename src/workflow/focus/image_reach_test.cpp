#include "workflow/focus/image_reach.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/focus/seen_spectrum.hpp"
#include "workflow/focus/swath_remark.hpp"

namespace sarsim::workflow {
namespace image_reach_test {

using testing::HasSubstr;

// One point beside the track near the end of the recorded ranges, one 1500 m ahead: from 100 m of flight the first is
// seen across the track, the second under 8 degrees.
scene::Scene two_looks() {
  const double across_m = std::sqrt(10290.0 * 10290.0 - 2000.0 * 2000.0) - 10000.0;
  const double ahead_m = std::sqrt(10200.0 * 10200.0 - 1500.0 * 1500.0 - 2000.0 * 2000.0) - 10000.0;
  return sar_scene(1500.0, {{across_m, 0.0, 0.0}, {ahead_m, 1500.0, 0.0}}, 0.25);
}

// Columns end where the middle of the beam, here 4 degrees ahead, sees the last recorded ranges.
TEST(ImageReach, ShowsWhatOtherDirectionsSee) {
  const auto [acquisition, rows] = sar_recording(two_looks());
  for (const auto method : {signal::FocusMethod::omega_k, signal::FocusMethod::range_doppler}) {
    const bool exact = method == signal::FocusMethod::omega_k;
    signal::FocusOptions options{.method = method};
    options.doppler_centroid_hz = geometric_doppler_centroid_hz(*acquisition);
    const auto targets = targets_to_show(*acquisition, rows, {options.doppler_centroid_hz, 1500.0});
    ASSERT_EQ(targets.size(), 2U);
    options.spectrum = seen_spectrum(*acquisition, rows, {options.doppler_centroid_hz, 0.0}, SeenPulses::sampled);
    const signal::FocusedImage before = signal::image_of(rows, options);
    EXPECT_LT(before.range.at(static_cast<double>(before.range.count)), 10290.0);
    reach_targets(targets, rows, options);
    const signal::FocusedImage after = signal::image_of(rows, options);
    EXPECT_GT(after.range.at(static_cast<double>(after.range.count)), 10290.0);
    EXPECT_LT(after.azimuth.first_m, 0.0);
    EXPECT_GT(after.azimuth.at(static_cast<double>(after.azimuth.count)), 1500.0);
    EXPECT_TRUE(diagnose_outside(targets, after, options, false).empty());
    for (const TargetTheory& theory : theory_of_targets(*acquisition, rows, options)) {
      const signal::PointResponse found = focused_point(rows, theory.place, options);
      EXPECT_NEAR(20.0 * std::log10(found.amplitude / theory.amplitude), 0.0, exact ? 0.1 : 0.3) << theory.target;
      EXPECT_NEAR(found.place.azimuth_m, theory.place.azimuth_m, 0.2) << theory.target;
      EXPECT_NEAR(found.place.range_m, theory.place.range_m, 0.1) << theory.target;
    }
  }
}

TEST(ImageReach, LeavesAnImageThatShowsItsTargetsAsItIs) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{3.0, -31.0, 0.0}, {}}));
  signal::FocusOptions options;
  reach_targets(targets_to_show(*acquisition, rows, {0.0, 600.0}), rows, options);
  EXPECT_FALSE(options.azimuth_reach);
  EXPECT_FALSE(options.range_reach);
}

// What is not shown is not taken for aliased.
TEST(ImageReach, SaysWhichTargetsAnImageDoesNotShow) {
  const auto [acquisition, rows] = sar_recording(two_looks());
  signal::FocusOptions options;
  options.doppler_centroid_hz = geometric_doppler_centroid_hz(*acquisition);
  const auto targets = targets_to_show(*acquisition, rows, {options.doppler_centroid_hz, 1500.0});
  const signal::FocusedImage image = signal::image_of(rows, options);
  const core::Problems problems = diagnose_outside(targets, image, options, false);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::warning);
  EXPECT_THAT(problems[0].message, HasSubstr("2 targets (1, 2) are outside the image: target "));
  EXPECT_THAT(problems[0].message, HasSubstr("m along the track, the image covers "));
  EXPECT_THAT(problems[0].hint, HasSubstr("--azimuth "));
  EXPECT_THAT(problems[0].hint, HasSubstr("--range "));
  const core::Problems single = diagnose_outside({targets[0]}, image, options, false);
  EXPECT_THAT(single.at(0).message, HasSubstr("target 1 is outside the image: at "));
  EXPECT_THAT(single.at(0).message, HasSubstr("at 10290.0 m of closest distance, the image covers "));
  EXPECT_LT(excess_of(worst_method_loss(*acquisition, rows, options)), 1.0);
  options.azimuth_area = signal::AxisInterval{0.0, 10.0};
  options.range_area = signal::AxisInterval{10200.0, 10210.0};
  EXPECT_TRUE(diagnose_outside(targets, image, options, false).empty());
  reach_targets(targets, rows, options);
  EXPECT_FALSE(options.azimuth_reach);
}

// A point that lies along the track beyond the rows, and whose Doppler frequencies are partly aliased, is nothing that
// the choice of a method could mend.
TEST(ImageReach, OfRowsDecidesWhatAMethodLoses) {
  const auto [acquisition, rows] = sar_recording(sar_scene(760.0, {{}, {0.0, 500.0, 0.0}}, 0.5));
  signal::FocusOptions options;
  const signal::FocusedImage image = signal::image_of(rows, options);
  ASSERT_FALSE(shows(image, {500.0, 10198.0}));
  EXPECT_LT(excess_of(worst_method_loss(*acquisition, rows, options)), 0.5);
  options.azimuth_reach = signal::AxisInterval{-100.0, 600.0};
  ASSERT_TRUE(shows(signal::image_of(rows, options), {500.0, 10198.0}));
  EXPECT_GT(excess_of(worst_method_loss(*acquisition, rows, options)), 1.0);
}

// Side lobes of the response that an image was made longer for are in it.
TEST(ImageReach, LeavesRoomForTheWholeResponse) {
  const auto [acquisition, rows] = sar_recording(sar_scene(4000.0, {{}, {0.0, 700.0, 0.0}}, 0.1));
  signal::FocusOptions options;
  const auto targets = targets_to_show(*acquisition, rows, {0.0, 4000.0});
  reach_targets(targets, rows, options);
  const signal::FocusedImage image = signal::image_of(rows, options);
  const double width_m = image.frame.speed_mps / (targets[1].highest_doppler_hz - targets[1].lowest_doppler_hz);
  EXPECT_GT(image.azimuth.at(static_cast<double>(image.azimuth.count)), 700.0 + 3.0 * width_m);
}

}  // namespace image_reach_test
}  // namespace sarsim::workflow
