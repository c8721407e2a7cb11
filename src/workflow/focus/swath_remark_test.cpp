#include "workflow/focus/swath_remark.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace swath_remark_test {

using testing::HasSubstr;

// Two points at C band and 1.2 GHz, 14 degrees ahead: one in the middle of the swath, one 75 m beyond.
scene::Scene wide_band_scene(double far_m) {
  scene::Scene scene = sar_scene(700.0, {{0.0, 0.0, 0.0}, {far_m, 0.0, 0.0}}, 0.5);
  scene.platforms[1] = simulate::moving("Plane", {-2800.0, -750.0, 1000.0}, {0.0, 100.0, 0.0});
  scene.radars[0].bandwidth_hz = 1.2e9;
  scene.radars[0].pulse_width_s = 1e-6;
  scene.simulations[0].sample_rate_hz = 1.8e9;
  scene.simulations[0].range_start_m = 2940.0;
  scene.simulations[0].range_end_m = 3220.0;
  return scene;
}

TEST(SwathRemark, NamesTheTargetThatLosesMostAndItsLoss) {
  const auto [plan, rows] = sar_recording(wide_band_scene(90.0));
  signal::FocusOptions options{.method = signal::FocusMethod::range_doppler};
  options.doppler_centroid_hz = geometric_doppler_centroid_hz(*plan);
  const core::Problems problems = remarks_on_swath_loss(*plan, rows, options);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::warning);
  EXPECT_THAT(problems[0].message, HasSubstr("range-Doppler compresses all ranges like the middle of the swath"));
  EXPECT_THAT(problems[0].message, HasSubstr("target 2, 69.3 m off it, loses "));
  const std::size_t at = problems[0].message.find("loses ") + 6;
  const double lost_db = std::stod(problems[0].message.substr(at));
  const signal::ImagePlace place = signal::place_of(signal::image_of(rows, options).frame, {90.0, 0.0, 0.0});
  const double found = focused_point(rows, place, options).amplitude / sar_targets(*plan, rows).at(1).amplitude;
  EXPECT_NEAR(-20.0 * std::log10(found), lost_db, 0.1);
  options.method = signal::FocusMethod::omega_k;
  EXPECT_TRUE(remarks_on_swath_loss(*plan, rows, options).empty());
}

TEST(SwathRemark, SaysNothingOfNarrowBandsAtBroadside) {
  const auto [plan, rows] = sar_recording(sar_scene(600.0, {{0.0, 0.0, 0.0}, {80.0, 0.0, 0.0}}));
  EXPECT_TRUE(remarks_on_swath_loss(*plan, rows, {.method = signal::FocusMethod::chirp_scaling}).empty());
}

// The record and its ranges are a few kilometres long.
TEST(AreaRemark, NamesBothIntervalsWhereNoEchoComesFromTheArea) {
  const auto [plan, rows] = sar_recording(sar_scene(600.0, {{0.0, 0.0, 0.0}}));
  const auto remarks = [&rows = rows](double first_m, double last_m) {
    return remarks_on_area(rows, {.azimuth_area = signal::AxisInterval{first_m, last_m}});
  };
  EXPECT_TRUE(remarks_on_area(rows, {}).empty());
  EXPECT_TRUE(remarks(-1e5, 1e5).empty());
  EXPECT_TRUE(remarks(1000.0, 1e5).empty());
  for (const double side : {-1.0, 1.0}) {
    const core::Problems far = remarks(side * 1e5 - 1.0, side * 1e5 + 1.0);
    ASSERT_EQ(far.size(), 1U);
    EXPECT_EQ(far[0].severity, core::Severity::warning);
    EXPECT_THAT(far[0].found, HasSubstr(side > 0.0 ? "99999 to 100001 m" : "-100001 to -99999 m"));
    EXPECT_THAT(far[0].expected, HasSubstr("the record and the farthest range"));
  }
}

}  // namespace swath_remark_test
}  // namespace sarsim::workflow
