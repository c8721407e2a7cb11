#include "workflow/focus/autofocus.hpp"

#include <gmock/gmock.h>

namespace sarsim::workflow {
namespace autofocus_test {

using testing::HasSubstr;

AutofocusFinding finding(double rms_rad, double before, double after) {
  AutofocusFinding found;
  found.piece_m = 20.0;
  found.rms_rad = rms_rad;
  found.entropy_before = before;
  found.entropy_after = after;
  return found;
}

TEST(AutofocusFailure, IsAGainThatIsNone) {
  EXPECT_THAT(failure_of(finding(0.02, 9.0, 9.1)), HasSubstr("sharper before"));
  // 15.8 rad of a wind that it cannot follow: the image stays 22 dB too weak.
  EXPECT_THAT(failure_of(finding(15.8, 16.196, 16.194)), HasSubstr("hardly changes, from 16.196 to 16.194"));
}

TEST(AutofocusFailure, IsNoneWhereTheErrorIsTakenOut) {
  EXPECT_EQ(failure_of(finding(4.5, 12.0, 11.0)), "");
  EXPECT_EQ(failure_of(finding(0.2, 12.0, 11.999)), "");
}

TEST(AutofocusFailure, IsAWarningOfWhatIsNotTakenOut) {
  const core::Problems failed = remarks_on_autofocus(finding(15.8, 16.196, 16.194));
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].severity, core::Severity::warning);
  EXPECT_THAT(failed[0].message, HasSubstr("autofocus failed: it found 15.8 rad rms"));
  EXPECT_EQ(remarks_on_autofocus(finding(0.02, 9.0, 9.1)).at(0).severity, core::Severity::note);
  EXPECT_TRUE(remarks_on_autofocus(finding(4.5, 12.0, 11.0)).empty());
}

}  // namespace autofocus_test
}  // namespace sarsim::workflow
