#include "picture/scene/place_labels.hpp"

#include <gtest/gtest.h>

namespace sarsim::picture {
namespace {

using Hold = Drawing::Hold;

Drawing::Text text(float x, float y, const char* words, Hold hold) {
  return {x, y, words, Role::text, false, false, hold};
}

const Camera picture = Camera::start(400.0, 300.0);

TEST(PlaceLabels, LeavesOutDistancesThatTheEdgeWouldCut) {
  std::vector<Drawing::Text> texts{text(380, 20, "500 m", Hold::spare), text(380, 40, "Radar", Hold::movable),
                                   text(20, 5, "500 m", Hold::spare), text(20, 299, "500 m", Hold::spare),
                                   text(20, 100, "500 m", Hold::spare)};
  place_labels(texts, picture, 1.0);
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0].text, "Radar");
  EXPECT_EQ(texts[1].y, 100.0F);
}

// Wide letters are longer than estimated.
TEST(PlaceLabels, KeepsDistancesAwayFromTheSides) {
  std::vector<Drawing::Text> texts{text(362, 20, "500 m", Hold::spare), text(359, 60, "500 m", Hold::spare),
                                   text(3, 100, "500 m", Hold::spare)};
  place_labels(texts, picture, 1.0);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0].y, 60.0F);
}

TEST(PlaceLabels, LeavesWordsThatHaveRoomWhereTheyAre) {
  std::vector<Drawing::Text> texts{text(0, 20, "Plane", Hold::movable), text(6, 40, "500 m", Hold::spare),
                                   text(60, 20, "Radar", Hold::movable)};
  place_labels(texts, picture, 1.0);
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_EQ(texts[0].y, 20.0F);
  EXPECT_EQ(texts[1].y, 40.0F);
  EXPECT_EQ(texts[2].y, 20.0F);
}

TEST(PlaceLabels, MovesNamesByLinesAndLeavesOutDistances) {
  std::vector<Drawing::Text> texts{text(0, 20, "500 m", Hold::spare), text(4, 20, "Long", Hold::movable),
                                   text(2, 20, "Short", Hold::movable), text(1, 21, "X", Hold::fixed)};
  place_labels(texts, picture, 1.0);
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_EQ(texts[0].text, "Long");
  EXPECT_EQ(texts[0].y, 33.0F);
  EXPECT_EQ(texts[1].text, "Short");
  EXPECT_EQ(texts[1].y, 7.0F);
  EXPECT_EQ(texts[2].y, 21.0F);
}

TEST(PlaceLabels, KeepsNamesWithoutRoom) {
  std::vector<Drawing::Text> texts(20, text(0, 20, "Drone", Hold::movable));
  place_labels(texts, picture, 1.0);
  EXPECT_EQ(texts.size(), 20U);
  EXPECT_EQ(texts.back().y, 20.0F);
}

TEST(PlaceLabels, LeavesThousandsAsTheyAre) {
  std::vector<Drawing::Text> texts(5000, text(0, 20, "500 m", Hold::spare));
  place_labels(texts, picture, 1.0);
  EXPECT_EQ(texts.size(), 5000U);
}

TEST(PlaceLabels, TakesRoomByTheScaleAndCountsLettersNotBytes) {
  std::vector<Drawing::Text> texts{text(0, 20, "65° W", Hold::fixed), text(36, 20, "abc", Hold::spare)};
  place_labels(texts, picture, 1.0);
  EXPECT_EQ(texts.size(), 2U);
  place_labels(texts, picture, 2.0);
  EXPECT_EQ(texts.size(), 1U);
}

}  // namespace
}  // namespace sarsim::picture
