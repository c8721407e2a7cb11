#include "workflow/verify/record.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "workflow/verify/groups.hpp"
#include "workflow/verify/page.hpp"

namespace sarsim::workflow::verify {
namespace record_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(VerifyRecord, JudgesByTheBoundOfAStatement) {
  Record record({});
  record.group("G", [](Record& r) {
    r.near("", "", 1.0, 1.09, 0.1, "");
    r.near("", "", 1.0, 1.11, 0.1, "");
    r.near("", "", 0.0, 0.0, 0.0, "");
    r.near("", "", 0.0, 1e-300, 0.0, "");
    r.at_most("", "", 1.0, 1.0, "");
    r.at_most("", "", 1.0, 1.1, "");
    r.at_least("", "", 3.0, 3.0, "");
    r.at_least("", "", 3.0, 2.9, "");
  });
  const std::vector<bool> expected{true, false, true, false, true, false, true, false};
  ASSERT_EQ(record.findings().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(record.findings()[i].holds, expected[i]) << i;
  EXPECT_EQ(record.findings()[0].group, "G");
  EXPECT_EQ(holding(record), 4U);
}

TEST(VerifyRecord, TakesNoNumberForAFailure) {
  Record record({});
  record.near("", "", 1.0, nan, 0.1, "");
  record.at_most("", "", 1.0, nan, "");
  record.at_least("", "", 1.0, nan, "");
  EXPECT_EQ(holding(record), 0U);
}

TEST(VerifyRecord, GoesOnBehindAGroupThatEndsEarly) {
  Record record({});
  record.group("first", [](Record&) { throw std::runtime_error("no memory"); });
  record.group("second", [](Record& r) { r.near("", "", 1.0, 1.0, 0.0, ""); });
  ASSERT_EQ(record.findings().size(), 2U);
  EXPECT_FALSE(record.findings()[0].holds);
  EXPECT_EQ(record.findings()[0].failure, "no memory");
  EXPECT_EQ(record.findings()[0].group, "first");
  EXPECT_TRUE(record.findings()[1].holds);
}

TEST(VerifyRecord, EndsWhereItIsToldTo) {
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)verify_all({true, &stop}), core::Interrupted);
}

TEST(VerifyAll, QuicklyMeasuresEveryGroupButSpeed) {
  const Record record = verify_all({true, nullptr});
  EXPECT_EQ(holding(record), record.findings().size());
  std::string group;
  std::vector<std::string> groups;
  for (const Finding& finding : record.findings()) {
    EXPECT_TRUE(finding.failure.empty()) << finding.failure;
    EXPECT_FALSE(finding.name.empty());
    EXPECT_FALSE(finding.source.empty()) << finding.name;
    if (finding.group != group) groups.push_back(group = finding.group);
  }
  EXPECT_EQ(groups, (std::vector<std::string>{"Closed forms", "Geometry", "Light time", "Beams and targets",
                                              "Band-limited pulses", "Numbers of the thesis", "Engines", "Statistics",
                                              "Focusing", "Detection and profiles"}));
}

}  // namespace record_test
}  // namespace sarsim::workflow::verify
