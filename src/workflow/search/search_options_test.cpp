#include "workflow/search/search_options.hpp"

#include <gmock/gmock.h>

namespace sarsim::workflow::search_options_test {

namespace {

std::vector<std::string> refusals(const GivenWords& given) {
  std::vector<std::string> told;
  try {
    static_cast<void>(doppler_request("a.scr", given));
  } catch (const core::InvalidRequest& refused) {
    for (const core::Problem& problem : refused.problems) told.push_back(problem.message);
  }
  return told;
}

}  // namespace

TEST(SearchRequest, IsMadeOfWords) {
  const SearchRequest request = search_request("a.scr", {{"--interval", "32"},
                                                         {"--canceller", "three"},
                                                         {"--cfar", "os"},
                                                         {"--rank", "0.5"},
                                                         {"--train", "12:2"},
                                                         {"--no-map", ""},
                                                         {"--height", "20"},
                                                         {"--scan", "2"}});
  EXPECT_EQ(request.input.path, "a.scr");
  EXPECT_EQ(request.pulses, 32U);
  EXPECT_EQ(request.canceller, 2U);
  EXPECT_EQ(request.detector, signal::CfarOptions::Kind::ordered_statistic);
  EXPECT_EQ(request.rank, 0.5);
  ASSERT_TRUE(request.train.has_value());
  EXPECT_EQ(request.train->columns, 12U);
  EXPECT_EQ(request.train->rows, 2U);
  EXPECT_FALSE(request.image);
  EXPECT_EQ(request.picture.height_m, 20.0);
  EXPECT_EQ(request.picture.scan, 1U);
  EXPECT_FALSE(search_request("a.scr", {{"--cfar", "none"}}).detect);
}

TEST(DopplerRequest, TellsAllThatIsWrongOnceAWordMeansNothing) {
  EXPECT_THAT(refusals({{"--window", "blue"}, {"--guard", "x"}, {"--pfa", "3"}}),
              testing::ElementsAre("--window: invalid", "--pfa: no probability of false alarm for a cell",
                                   "--guard: invalid cell counts"));
  EXPECT_THAT(refusals({{"--cfar", "none"}, {"--train", "y"}}),
              testing::ElementsAre("--train means nothing with --cfar none", "--train: invalid cell counts"));
  EXPECT_THAT(refusals({{"--pfa", "3"}}), testing::IsEmpty()) << "the workflow says so";
}

}  // namespace sarsim::workflow::search_options_test
