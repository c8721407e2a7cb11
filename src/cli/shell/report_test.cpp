#include "cli/shell/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sarsim::cli {
namespace report_test {

using testing::HasSubstr;
using testing::Not;

workflow::RecordingReport recording() {
  workflow::RecordingReport report;
  report.file = "a.asc";
  report.simulation.radar = "R";
  report.simulation.lsb_v = 2e-9;
  report.run.rows = 10;
  report.run.columns = 100;
  report.run.maximum_v = 1.27e-7;
  report.run.lsb_v = 2e-9;
  report.run.best_lsb_v = 1e-9;
  report.run.range_used = 0.5;
  report.run.zero = 250;
  report.bytes = 6000.0;
  report.seconds = 1.5;
  report.counts = true;
  return report;
}

TEST(Report, SaysWhatTheOriginalSaid) {
  const std::string text = report_text(recording());
  EXPECT_THAT(text, HasSubstr("a.asc: 10 x 100 samples, 6 kB, 1.5 s\n"));
  EXPECT_THAT(text, HasSubstr("0.000127 mV, 50 % of the converter's range"));
  EXPECT_THAT(text, HasSubstr("2E-06 mV (as given), best 1E-06 mV"));
  EXPECT_THAT(text, HasSubstr("0 % saturated, 25 % zero"));
  EXPECT_THAT(text, Not(HasSubstr("clipped")));
}

TEST(Report, SaysWhenTheLsbWasEstimated) {
  workflow::RecordingReport report = recording();
  report.simulation.lsb_v = 0.0;
  EXPECT_THAT(report_text(report), HasSubstr("(estimated from the data)"));
  report.counts = false;
  EXPECT_THAT(report_text(report), Not(HasSubstr("estimated")));
}

TEST(Report, SaysHowToAvoidSaturation) {
  workflow::RecordingReport report = recording();
  report.run.saturated = 10;
  EXPECT_THAT(report_text(report), HasSubstr("1 % saturated"));
  EXPECT_THAT(report_text(report), HasSubstr("an LSB of 1E-06 mV would avoid clipping"));
}

TEST(Report, JsonOfNothingWrittenHasANullFile) {
  workflow::RecordingReport report = recording();
  report.file.clear();
  core::JsonWriter json;
  write_json(json, report);
  EXPECT_THAT(json.text(), HasSubstr("\"file\": null"));
  EXPECT_THAT(json.text(), HasSubstr("\"lsb_estimated\": false"));
}

TEST(Report, ZeroHasNoSign) {
  EXPECT_EQ(decimals(-0.01, 1), "0.0");
  EXPECT_EQ(decimals(-0.0, 3), "0.000");
  EXPECT_EQ(decimals(-0.06, 1), "-0.1");
  EXPECT_EQ(decimals(-10.0, 1), "-10.0");
  EXPECT_EQ(decimals(2.25, 2), "2.25");
}

}  // namespace report_test
}  // namespace sarsim::cli
