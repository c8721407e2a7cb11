#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::workflow {
namespace measure_report_test {

// One target of a ground grid about the anchor at 60 deg north, 10 deg east, found 10 m farther east.
MeasureReport report_on_earth() {
  MeasureReport report;
  report.origin.earth = radar::EarthFrame({{core::rad_per_deg * 60.0, core::rad_per_deg * 10.0, 40.0}, 0.0});
  report.frame = {signal::ImagePlane::ground_grid, {-100.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 100.0};
  MeasuredTarget& target = report.targets.emplace_back();
  target.theory.amplitude = 1.0;
  target.theory.place = {100.0, 0.0};
  target.found.emplace().place = {110.0, 0.0};
  return report;
}

TEST(MeasureReport, HasPlacesOnTheEarthOfGroundGridsAlone) {
  MeasureReport report = report_on_earth();
  const auto place = report.on_earth({100.0, 0.0});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->latitude_rad, core::rad_per_deg * 60.0, 1e-15);
  EXPECT_NEAR(place->height_m, 40.0, 1e-8);
  report.frame.plane = signal::ImagePlane::slant_range;
  EXPECT_FALSE(report.on_earth({100.0, 0.0}));
  EXPECT_EQ(csv_of(report).find("latitude"), std::string::npos);
  report.frame.plane = signal::ImagePlane::ground_grid;
  report.origin.earth.reset();
  EXPECT_FALSE(report.on_earth({100.0, 0.0}));
}

TEST(MeasureReport, CsvEndsWithBothPlaces) {
  const std::string text = csv_of(report_on_earth());
  const std::size_t end = text.find('\n');
  const std::string names = text.substr(0, end);
  const std::string line = text.substr(end + 1);
  EXPECT_TRUE(
      names.ends_with(",theory_latitude_deg,theory_longitude_deg,theory_height_m,latitude_deg,longitude_deg,height_m"));
  EXPECT_EQ(std::ranges::count(names, ','), std::ranges::count(line, ','));
  const std::size_t last = line.rfind(',');
  const std::size_t before = line.rfind(',', last - 1);
  // 10 m over (N + h) cos 60 deg.
  EXPECT_NEAR(core::parse_number(line.substr(before + 1, last - before - 1)).value(),
              10.0 + core::deg_per_rad * 10.0 / (6.3942e6 * 0.5), 1e-8);
}

// A target expected at (0, 0) with 1 V and widths of 2 m along the flight and 1 m across, over noise of a ratio.
MeasuredTarget expected_target(double snr_db) {
  MeasuredTarget target;
  target.theory.amplitude = 1.0;
  target.theory.azimuth = signal::ResponseFigures{.width = 2.0, .null = 2.2};
  target.theory.range = signal::ResponseFigures{.width = 1.0, .null = 1.1};
  target.noise_v = std::pow(10.0, -snr_db / 20.0);
  return target;
}

TargetState state_at(const MeasuredTarget& target, double azimuth_m, double range_m, double amplitude_db,
                     const signal::ResponseAxes& axes = {}) {
  signal::PointResponse peak;
  peak.place = {azimuth_m, range_m};
  peak.amplitude = std::pow(10.0, amplitude_db / 20.0);
  return state_of(target, peak, axes);
}

TEST(TargetStates, AreThoseOfPlaceAndStrength) {
  const MeasuredTarget target = expected_target(60.0);
  EXPECT_EQ(state_at(target, 0.99, -0.49, 0.0), TargetState::found);
  EXPECT_EQ(state_at(target, 1.01, 0.0, 0.0), TargetState::displaced);
  EXPECT_EQ(state_at(target, 0.0, 0.51, -5.3), TargetState::displaced);
  EXPECT_EQ(state_at(target, 0.0, 0.51, -19.0), TargetState::displaced);
  EXPECT_EQ(state_at(target, 0.0, 0.51, -29.0), TargetState::not_found);
  EXPECT_EQ(state_at(target, 0.3, 0.1, -2.9), TargetState::found);
  EXPECT_EQ(state_at(target, 0.3, 0.1, -3.1), TargetState::weak);
  EXPECT_EQ(state_at(target, 0.3, 0.1, -41.0), TargetState::weak);
  EXPECT_EQ(state_at(target, 0.3, 0.1, 3.1), TargetState::strong);
  // Along the cuts of the response, which squint turns.
  const double half = std::sqrt(0.5);
  const signal::ResponseAxes squinted{{half, half}, {half, -half}};
  EXPECT_EQ(state_at(target, 0.6, 0.0, 0.0, squinted), TargetState::found);
  EXPECT_EQ(state_at(target, 0.6, 0.6, 0.0, squinted), TargetState::displaced);
  EXPECT_EQ(state_at(target, 0.6, -0.6, 0.0, squinted), TargetState::found);
}

// Places and amplitudes as noise moves them: of a thousand targets at 12 dB or more, nearly all are found.
TEST(TargetStates, AllowForTheNoise) {
  std::mt19937 random(20261129);
  std::normal_distribution<double> normal;
  int found = 0;
  for (int n = 0; n < 1000; ++n) {
    const double snr_db = std::uniform_real_distribution<double>(12.0, 30.0)(random);
    const MeasuredTarget target = expected_target(snr_db);
    const double deviation = target.noise_v * std::sqrt(0.5);
    // sqrt(12)/(2 pi B sqrt(2 S)) with B of 0.886 over the width.
    const double per_width = std::sqrt(12.0) / (2.0 * core::pi * 0.886) * deviation;
    const double amplitude = 1.0 + deviation * normal(random);
    found += state_at(target, 2.0 * per_width * normal(random), per_width * normal(random),
                      20.0 * std::log10(std::max(amplitude, 0.01))) == TargetState::found
                 ? 1
                 : 0;
  }
  EXPECT_GE(found, 985);  // 1.3 in 1000 beyond three deviations at either end, in three figures, and what that adds.
}

TEST(MeasureReport, TellsDisplacedAndWeakTargetsFromThoseFound) {
  MeasureReport report = report_on_earth();
  report.targets[0].state = TargetState::found;
  MeasuredTarget& weak = report.targets.emplace_back(expected_target(20.0));
  weak.theory.target = 1;
  weak.state = TargetState::weak;
  weak.peak.emplace().amplitude = 0.1;
  const MeasureSummary sum = summary_of(report);
  EXPECT_EQ(sum.expected, 2U);
  EXPECT_EQ(sum.found, 1U);
  EXPECT_EQ(sum.weak, 1U);
  const std::string text = csv_of(report);
  EXPECT_NE(text.find("theory_range_islr_db,state,false_alarm_probability"), std::string::npos);
  EXPECT_NE(text.find("\n2,0,"), std::string::npos);
  EXPECT_NE(text.find(",weak,"), std::string::npos);
  EXPECT_NEAR(weak.amplitude_error_db(), -20.0, 1e-9);
}

}  // namespace measure_report_test
}  // namespace sarsim::workflow
