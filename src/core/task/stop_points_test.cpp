#include "core/task/stop_points.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {
namespace stop_points_test {

TEST(StopPoints, EndAtTheFirstThingWhereAStopIsRequestedAlready) {
  StopFlag stop;
  stop.request();
  StopPoints points(&stop, 1000);
  EXPECT_THROW(points.pass(), Interrupted);
  EXPECT_THROW(end_if_asked(&stop), Interrupted);
}

TEST(StopPoints, AskAgainAfterSoMuch) {
  StopFlag stop;
  StopPoints points(&stop, 3);
  points.pass();
  stop.request();
  for (int i = 0; i < 3; ++i) EXPECT_NO_THROW(points.pass());
  EXPECT_THROW(points.pass(), Interrupted);
}

TEST(StopPoints, CountWhatIsDoneAtOnce) {
  StopFlag stop;
  StopPoints points(&stop, 3);
  points.pass();
  stop.request();
  EXPECT_NO_THROW(points.pass(1'000'000));
  EXPECT_THROW(points.pass(), Interrupted);
}

TEST(StopPoints, NeverEndWithoutAFlag) {
  StopPoints points(nullptr, 1);
  for (int i = 0; i < 10; ++i) EXPECT_NO_THROW(points.pass());
  EXPECT_NO_THROW(end_if_asked(nullptr));
}

}  // namespace stop_points_test
}  // namespace sarsim::core
