#include "picture/facts/report_pages.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/maths/constants.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/profiles.hpp"

namespace sarsim::picture::report_pages_test {

namespace {

using testing::ElementsAre;

// "value unit" of a name in the first table.
std::string fact(const ReportPages& pages, const std::string& name) {
  for (const auto& row : pages.tables.front().rows)
    if (row.at(0) == name) return row.at(1) + (row.at(2).empty() ? "" : " " + row.at(2));
  return "none";
}

void expect_whole(const ReportPages& pages) {
  ASSERT_FALSE(pages.tables.empty());
  EXPECT_EQ(pages.tables.front().title, "Result");
  EXPECT_THAT(pages.tables.front().columns, ElementsAre("Name", "Value", "Unit"));
  for (const ReportTable& table : pages.tables) {
    EXPECT_FALSE(table.title.empty());
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.title;
  }
  for (const Figure& figure : pages.figures) EXPECT_FALSE(figure.title.empty());
}

workflow::FocusReport focus_report() {
  workflow::FocusReport report;
  report.image.image.azimuth = {-50.0, 0.5, 201, 0.0};
  report.image.image.range = {10200.0, 1.25, 81, 0.0};
  report.options.doppler_centroid_hz = -1234.5;
  report.algorithm = workflow::FocusAlgorithm::back_projection;
  report.grid = workflow::FocusGrid::ground;
  report.seconds = 2.0;
  return report;
}

workflow::ProfilesReport profiles_report() {
  workflow::ProfilesReport report;
  report.bursts = 3;
  report.series.axis = {100.0, 0.5, 5};
  report.series.band_hz = 512e6;
  report.series.centre_hz = 9.25e9;
  workflow::ScanRecord scan;
  scan.bursts = {0, 1};
  scan.from_s = 0.25;
  scan.to_s = 1.5;
  scan.speed_mps = -20.0;
  report.series.scans.push_back(scan);
  report.series.rows = {{0, 0, 0.25}, {1, 0, 0.5}};
  report.series.values = {1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 0.0, 1e-3, 0.1, 1e-3, 0.0};
  report.held_row = 1;
  workflow::HeldTarget found;
  found.truth = {0, 101.0, 3.0, 0.1};
  found.expected_m = 101.0;
  found.expected_bin = 2.0;
  found.found = signal::ProfilePeak{101.02, 0.1, 0.5, 0.3};
  workflow::HeldTarget lost;
  lost.truth = {1, 102.0, 0.0, 1e-3};
  lost.expected_m = 102.0;
  report.targets = {found, lost};
  report.peaks = {{101.02, 0.1, 0.5, 0.3}};
  return report;
}

}  // namespace

TEST(PagesOfFocusing, GiveAxesAlgorithmAndDoppler) {
  const ReportPages pages = pages_of(focus_report());
  expect_whole(pages);
  EXPECT_EQ(fact(pages, "Algorithm"), "back-projection");
  EXPECT_EQ(fact(pages, "Rows, along azimuth"), "201 samples");
  EXPECT_EQ(fact(pages, "Azimuth to"), "50 m");
  EXPECT_EQ(fact(pages, "Ground range from"), "10.2 km");
  EXPECT_EQ(fact(pages, "Ground range to"), "10.3 km");
  EXPECT_EQ(fact(pages, "Doppler centroid"), "-1.2345 kHz");
  EXPECT_EQ(fact(pages, "Motion compensation"), "none");
  EXPECT_EQ(fact(pages, "Autofocus"), "none");
  EXPECT_TRUE(pages.figures.empty());
}

TEST(PagesOfFocusing, DrawThePhaseThatAutofocusFound) {
  workflow::FocusReport report = focus_report();
  report.autofocus = workflow::AutofocusFinding{12.0, {-1.0, 0.0, 1.0}, {0.1, -0.2, 0.3}, 0.25, 9.0, 8.5, true};
  const ReportPages pages = pages_of(report);
  expect_whole(pages);
  EXPECT_EQ(fact(pages, "Autofocus"), "applied");
  EXPECT_EQ(fact(pages, "Phase error, rms"), "250 mrad");
  ASSERT_EQ(pages.figures.size(), 1U);
  ASSERT_EQ(pages.figures[0].panels.size(), 1U);
  const FigurePanel& panel = pages.figures[0].panels[0];
  EXPECT_EQ(panel.x.unit, "m");
  EXPECT_EQ(panel.y.unit, "rad");
  EXPECT_THAT(panel.curves.at(0).x, ElementsAre(-1.0, 0.0, 1.0));
  EXPECT_THAT(panel.curves.at(0).y, ElementsAre(0.1, -0.2, 0.3));
}

TEST(PagesOfProfiles, HoldTheTargetsAgainstTheProfile) {
  const ReportPages pages = pages_of(profiles_report());
  expect_whole(pages);
  EXPECT_EQ(fact(pages, "Band"), "512 MHz");
  EXPECT_EQ(fact(pages, "Bursts illuminated"), "2");
  ASSERT_EQ(pages.tables.size(), 4U);
  EXPECT_THAT(pages.tables[1].rows.at(0), ElementsAre("1", "1", "2", "0.25", "1.5", "-20"));
  EXPECT_EQ(pages.tables[2].title, "Targets in burst 2");
  EXPECT_THAT(pages.tables[2].rows.at(0),
              ElementsAre("1", "101.000", "3.00", "101.000", "2.00", "101.020", "0.020", "0.300", "0.00"));
  EXPECT_EQ(pages.tables[2].rows.at(1).at(5), "no peak");
  EXPECT_THAT(pages.tables[3].rows.at(0), ElementsAre("101.020", "0.1", "0.500", "0.300"));
}

TEST(PagesOfProfiles, DrawTheProfileWithItsTargets) {
  const ReportPages pages = pages_of(profiles_report());
  ASSERT_EQ(pages.figures.size(), 1U);
  EXPECT_EQ(pages.figures[0].title, "Profile of burst 2");
  const FigurePanel& panel = pages.figures[0].panels.at(0);
  EXPECT_EQ(panel.x.first, 100.0);
  EXPECT_EQ(panel.x.last, 102.0);
  ASSERT_EQ(panel.curves.at(0).y.size(), 5U);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[2], -20.0);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[1], -60.0);
  ASSERT_EQ(panel.marks.size(), 2U);
  EXPECT_EQ(panel.marks[0].x, 101.0);
  EXPECT_DOUBLE_EQ(panel.marks[0].y, -20.0);
  EXPECT_EQ(panel.marks[1].text, "2");
}

TEST(PagesOfTurningTargets, ListSeveralImagesAndDescribeASingleOne) {
  workflow::IsarReport report;
  report.algorithm = "isar-range-doppler";
  workflow::WrittenIsarImage image;
  image.bursts = 64;
  image.image.image.azimuth = {-10.0, 0.25, 81, 0.0};
  image.image.image.range = {-5.0, 0.5, 21, 0.0};
  image.image.range_m = 8000.0;
  image.image.turn_rad = core::pi / 90.0;
  image.image.points.push_back({3, {1.0, -2.0}, 0.5, {}});
  report.images = {image};
  const ReportPages one = pages_of(report);
  expect_whole(one);
  EXPECT_EQ(fact(one, "Algorithm"), "range-doppler");
  EXPECT_EQ(fact(one, "Bursts"), "1 to 64");
  EXPECT_EQ(fact(one, "Range of the centre"), "8 km");
  EXPECT_EQ(fact(one, "Turned by"), "2 deg");
  ASSERT_EQ(one.tables.size(), 2U);
  EXPECT_THAT(one.tables[1].rows.at(0), ElementsAre("1", "4", "1.000", "-2.000", "no peak", "", "", "", ""));

  image.first_burst = 64;
  report.images.push_back(image);
  const ReportPages two = pages_of(report);
  expect_whole(two);
  EXPECT_EQ(fact(two, "Bursts"), "none");
  ASSERT_EQ(two.tables.size(), 3U);
  EXPECT_EQ(two.tables[1].title, "Images");
  EXPECT_EQ(two.tables[1].rows.at(1).at(1), "65");
}

TEST(PagesOfPulses, ListTargetsAndDetections) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "sarsim_report_pages_test.csv";
  std::ofstream(file) << "interval,time_s,range_m,target\n1,0.012345678901,5000.123456789,\n2,0.5,5001,1\n";
  workflow::DopplerReport report;
  report.table = file;
  report.detections = 2;
  report.intervals = 4;
  report.options.pulses = 64;
  report.options.canceller = 1;
  report.columns = 100;
  report.range_first_m = 4700.0;
  workflow::TargetFinding finding;
  finding.sight.in_window = true;
  finding.sight.range_m = 5000.0;
  finding.sight.snr = 100.0;
  finding.found = 2;
  finding.best = workflow::SearchDetection{};
  finding.best->range_m = 5001.5;
  finding.best->snr = std::numeric_limits<double>::infinity();
  workflow::TargetFinding outside;
  outside.target = 1;
  report.findings = {finding, outside};
  const ReportPages pages = pages_of(report);
  std::filesystem::remove(file);
  expect_whole(pages);
  EXPECT_EQ(fact(pages, "Canceller"), "2 pulses");
  EXPECT_EQ(fact(pages, "Range from"), "4.7 km");
  EXPECT_EQ(fact(pages, "Detections"), "2");
  ASSERT_EQ(pages.tables.size(), 3U);
  EXPECT_THAT(pages.tables[1].rows.at(0), ElementsAre("1", "0.00", "5000.0", "0.0", "0.0", "0", "0", "20.0", "", "",
                                                      "2", "1.50", "0.0", "0.000", ""));
  EXPECT_EQ(pages.tables[1].rows.at(1).at(1), "not in the window");
  EXPECT_THAT(pages.tables[2].columns, ElementsAre("Interval", "Time (s)", "Range (m)", "Target"));
  EXPECT_THAT(pages.tables[2].rows,
              ElementsAre(ElementsAre("1", "0.0123", "5000.12", ""), ElementsAre("2", "0.5000", "5001.00", "1")));
}

TEST(PagesOfPulses, SayThatNothingWasLookedForWithoutADetector) {
  workflow::SearchReport report;
  report.options.detect = false;
  report.picture = workflow::PictureReport{{-1000.0, 1000.0, 20.0, 101, 101}, 3};
  const ReportPages pages = pages_of(report);
  expect_whole(pages);
  EXPECT_EQ(fact(pages, "Detector"), "none");
  EXPECT_EQ(fact(pages, "Detections"), "none");
  EXPECT_EQ(fact(pages, "Turns of the antenna"), "3");
  EXPECT_EQ(fact(pages, "Side of a pixel"), "20 m");
  EXPECT_EQ(pages.tables.size(), 1U);
}

}  // namespace sarsim::picture::report_pages_test
