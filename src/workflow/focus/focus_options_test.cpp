#include "workflow/focus/focus_options.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow::focus_options_test {

namespace {

std::string refusal(const GivenWords& given) {
  try {
    static_cast<void>(focus_request("scenes/sar.scr", given));
  } catch (const core::InvalidRequest& refused) {
    return refused.problems.size() == 1 ? refused.problems.front().message : "several";
  }
  return {};
}

}  // namespace

TEST(FocusRequest, IsMadeOfWords) {
  const FocusRequest request = focus_request("scenes/sar.scr", {{"--window", "hann"},
                                                                {"--azimuth-window", "taylor:35:5"},
                                                                {"--memory", "2G"},
                                                                {"--doppler-centroid", "-120.5"},
                                                                {"--motion-compensation", "first"},
                                                                {"--simulation", "2"},
                                                                {"--threads", "3"},
                                                                {"--force", ""}});
  EXPECT_EQ(request.input.path, "scenes/sar.scr");
  EXPECT_EQ(request.output, "sar.img");
  EXPECT_EQ(signal::to_string(request.range_window), "hann");
  EXPECT_EQ(signal::to_string(request.azimuth_window), "taylor:35:5");
  EXPECT_EQ(request.memory_bytes, std::size_t{2} << 30);
  EXPECT_EQ(request.centroid, CentroidSource::given);
  EXPECT_EQ(request.given_centroid_hz, -120.5);
  EXPECT_EQ(request.motion, MotionOrder::first);
  EXPECT_EQ(request.input.simulation, 2);
  EXPECT_EQ(request.threads, 3U);
  EXPECT_TRUE(request.force);
  EXPECT_FALSE(request.magnitude);
}

TEST(FocusRequest, RefusesWordsThatMeanNothing) {
  EXPECT_EQ(refusal({{"--memory", "lots"}, {"--window", "blue"}}), "--memory: 'lots' is not a valid size");
  EXPECT_EQ(refusal({{"--azimuth-window", "green"}, {"--doppler-centroid", "pi"}}),
            "--azimuth-window: 'green' is not a valid window");
  EXPECT_EQ(refusal({{"--doppler-centroid", "pi"}}), "--doppler-centroid: invalid 'pi'");
  EXPECT_EQ(refusal({{"--memory", "B"}}), "--memory: 'B' is not a valid size");
  EXPECT_EQ(refusal({{"--threads", "many"}}), "--threads: 'many' is not a whole number from 0 to 4096");
}

}  // namespace sarsim::workflow::focus_options_test
