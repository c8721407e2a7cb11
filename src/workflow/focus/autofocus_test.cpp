#include "workflow/focus/autofocus.hpp"

#include <cmath>

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
  found.contrast_before = 10.0;
  found.contrast_after = 11.0;
  found.points = 5;
  found.point_gain_db = 6.0;
  found.point_snr_after_db = 6.0;
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

// Noise, too, gains entropy: what counts are points that grow as the error found makes them grow.
TEST(AutofocusFailure, IsAGainThatNoiseHasAsWell) {
  AutofocusFinding found = finding(2.44, 12.326, 12.262);
  found.contrast_after = 9.9;
  EXPECT_THAT(failure_of(found), HasSubstr("contrast"));
  found = finding(2.44, 12.326, 12.262);
  found.points = 0;
  EXPECT_THAT(failure_of(found), HasSubstr("no point stands out"));
  found = finding(2.44, 12.326, 12.262);
  found.point_gain_db = 1.1;
  found.point_snr_after_db = 1.1;
  EXPECT_THAT(failure_of(found), HasSubstr("+1.10 dB and their SNR by +1.10 dB, which should gain 3.00 dB"));
  found.point_snr_after_db = 5.8;  // The smear around them is gone.
  EXPECT_EQ(failure_of(found), "");
  found = finding(2.44, 12.326, 12.262);
  found.point_level_db = -31.0;
  EXPECT_THAT(failure_of(found), HasSubstr("31.0 dB below the peaks expected from their echoes"));
  // Half of 0.4 rad squared nepers of power.
  found = finding(0.4, 12.0, 11.99);
  found.point_snr_after_db = 0.5 * 10.0 * std::log10(std::exp(1.0)) * 0.16 + 0.001;
  EXPECT_EQ(failure_of(found), "");
  found.point_snr_after_db -= 0.002;
  EXPECT_NE(failure_of(found), "");
}

// 17.7 rad of a straight line smeared points: contrast 42 to 66, SNR 40.2 to 47.7 dB, peaks 1.59 dB lower.
TEST(AutofocusFailure, IsAPeakThatFallsWhateverElseGrows) {
  AutofocusFinding found = finding(17.7, 6.298, 5.575);
  found.contrast_before = 42.0;
  found.contrast_after = 66.0;
  found.point_snr_before_db = 40.2;
  found.point_snr_after_db = 47.7;
  found.point_gain_db = -1.59;
  EXPECT_THAT(failure_of(found), HasSubstr("the peaks of the points fall by 1.59 dB"));
  found.point_gain_db = 0.01;
  EXPECT_EQ(failure_of(found), "");
}

TEST(AutofocusFailure, IsAWarningOfWhatIsNotTakenOut) {
  const core::Problems failed = diagnose_autofocus(finding(15.8, 16.196, 16.194));
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].severity, core::Severity::warning);
  EXPECT_THAT(failed[0].message, HasSubstr("autofocus failed: it estimated 15.8 rad rms"));
  EXPECT_EQ(diagnose_autofocus(finding(0.02, 9.0, 9.1)).at(0).severity, core::Severity::note);
  EXPECT_TRUE(diagnose_autofocus(finding(4.5, 12.0, 11.0)).empty());
}

}  // namespace autofocus_test
}  // namespace sarsim::workflow
