#include "picture/image/target_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sarsim::picture {
namespace target_table_test {

// Found, lost in the noise, without echoes, and beside the image.
workflow::MeasureReport report() {
  workflow::MeasureReport report;
  for (std::size_t i = 0; i < 4; ++i) {
    workflow::MeasuredTarget& target = report.targets.emplace_back();
    target.theory.target = i;
    target.theory.amplitude = i == 2 ? 0.0 : 1.0;
    target.theory.place = {10.0 * static_cast<double>(i), 5000.0};
    target.noise_v = 0.01;
    target.peak_v = i == 0 ? 1.0 : 0.02;
  }
  signal::PointResponse& found = report.targets[0].found.emplace();
  found.place = {0.0125, 4999.75};
  found.amplitude = 1.0;
  found.azimuth = {0.65, 0.7, -13.26, -9.7};
  found.range = {1.33, 1.5, -13.1, -9.5};
  report.targets[3].outside = true;
  return report;
}

std::size_t column(const TargetTable& table, const std::string& heading) {
  const auto at = std::ranges::find(table.columns, heading);
  EXPECT_NE(at, table.columns.end()) << heading;
  return static_cast<std::size_t>(at - table.columns.begin());
}

TEST(TargetTable, SaysOffsetsWidthsSidelobesAndSnrOfWhatWasFound) {
  const TargetTable table = target_table(report());
  ASSERT_EQ(table.rows.size(), 4U);
  ASSERT_EQ(table.columns.size(), table.meanings.size());
  const auto words = [&](std::size_t row, const std::string& heading) {
    return table.rows[row].words.at(column(table, heading));
  };
  EXPECT_EQ(words(0, "Target"), "1");
  EXPECT_EQ(words(0, "State"), "found");
  EXPECT_EQ(words(0, "Offset az. (m)"), "+0.0125");
  EXPECT_EQ(words(0, "Offset rg. (m)"), "-0.2500");
  EXPECT_EQ(words(0, "Width az. (m)"), "0.650");
  EXPECT_EQ(words(0, "Width rg. (m)"), "1.330");
  EXPECT_EQ(words(0, "PSLR az. (dB)"), "-13.26");
  EXPECT_EQ(words(0, "ISLR rg. (dB)"), "-9.50");
  EXPECT_EQ(words(0, "SNR (dB)"), "40.0");  // 1 over 0.01
  for (const TargetTable::Row& row : table.rows) {
    EXPECT_EQ(row.words.size(), table.columns.size());
    EXPECT_EQ(row.values.size(), table.columns.size());
  }
}

TEST(TargetTable, SaysWhyATargetHasNoNumbers) {
  const TargetTable table = target_table(report());
  const std::size_t state = column(table, "State");
  const std::size_t width = column(table, "Width az. (m)");
  EXPECT_EQ(table.rows[1].words[state], "not found");
  EXPECT_EQ(table.rows[2].words[state], "no echoes");
  EXPECT_EQ(table.rows[3].words[state], "outside the image");
  for (std::size_t row = 1; row < 4; ++row) {
    EXPECT_TRUE(table.rows[row].words[width].empty());
    EXPECT_TRUE(std::isnan(table.rows[row].values[width]));
  }
  EXPECT_TRUE(table.rows[0].inside && table.rows[1].inside);
  EXPECT_FALSE(table.rows[2].inside || table.rows[3].inside);
  EXPECT_EQ(table.summary, "1 of 2 found, at most 0.2503 m position error; 1 outside the image");
}

TEST(TargetTable, IsTextForSpreadsheets) {
  const std::string text = text_of(target_table(report()));
  EXPECT_EQ(std::ranges::count(text, '\n'), 5);
  EXPECT_TRUE(text.starts_with("Target\tState\tAzimuth (m)"));
  EXPECT_NE(text.find("\n2\tnot found\t10.000\t5000.000\t\t"), std::string::npos) << text;
}

}  // namespace target_table_test
}  // namespace sarsim::picture
