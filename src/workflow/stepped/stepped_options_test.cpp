#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "workflow/stepped/isar_options.hpp"
#include "workflow/stepped/profiles_options.hpp"

namespace sarsim::workflow::stepped_options_test {

TEST(ProfilesRequest, IsMadeOfWords) {
  const ProfilesRequest request = profiles_request("a.scr", {{"--group", "scans"},
                                                             {"--velocity", "-12.5"},
                                                             {"--window", "hamming"},
                                                             {"--burst", "3"},
                                                             {"--seed", "18446744073709551615"},
                                                             {"--pulse", "ideal"}});
  EXPECT_EQ(request.set, ProfileGrouping::scans);
  EXPECT_EQ(request.velocity.speed_mps, -12.5);
  EXPECT_EQ(request.velocity.words, "-12.5");
  ASSERT_TRUE(request.window.has_value());
  EXPECT_EQ(request.window->kind, signal::SarWindow::Kind::hamming);
  EXPECT_EQ(request.burst, 2U);
  EXPECT_EQ(request.input.overrides.seed, UINT64_MAX);
  EXPECT_EQ(request.input.overrides.pulse, scene::PulseDefinition::ideal);
  EXPECT_EQ(profiles_request("a.scr", {}).velocity.words, "none");
  EXPECT_THROW(static_cast<void>(profiles_request("a.scr", {{"--velocity", "fast"}})), core::InvalidRequest);
}

TEST(IsarRequest, IsMadeOfWords) {
  const IsarRequest request = isar_request("a.scr", {{"--algorithm", "back-projection"},
                                                     {"--turn-rate", "90"},
                                                     {"--bursts", "64"},
                                                     {"--window", "hann"},
                                                     {"--range-window", "kaiser:4"},
                                                     {"--profile", "classic"}});
  EXPECT_EQ(request.options.algorithm, IsarOptions::Algorithm::back_projection);
  EXPECT_EQ(request.options.turn_rate_radps, core::pi / 2.0);
  EXPECT_EQ(request.bursts, 64U);
  EXPECT_EQ(signal::to_string(request.options.range_window), "kaiser:4");
  EXPECT_EQ(signal::to_string(request.options.azimuth_window), "hann");
  EXPECT_EQ(request.input.overrides.profile, scene::Profile::classic);
  EXPECT_THROW(static_cast<void>(isar_request("a.scr", {{"--bursts", "1"}})), core::InvalidRequest);
}

}  // namespace sarsim::workflow::stepped_options_test
