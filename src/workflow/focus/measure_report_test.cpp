#include <algorithm>
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

}  // namespace measure_report_test
}  // namespace sarsim::workflow
