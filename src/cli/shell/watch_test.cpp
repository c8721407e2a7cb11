#include "cli/shell/watch.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace sarsim::cli {
namespace watch_test {

TEST(Watch, ShowsStagesProblemsAndAnnouncementsInTheirOrder) {
  std::ostringstream out;
  std::ostringstream err;
  Streams streams{out, err, true};  // On a terminal a bar is drawn at once.
  Watch watch(streams, false);
  const core::Observer observer = watch.observer();
  observer.announces("a.h5: 10 x 20 samples");
  observer.stage("a.h5")({5, 10, 0});
  observer.remarks({core::warning("the beam is narrow")});
  observer.stage("b.h5")({10, 10, 0});
  watch.close();
  const std::string text = err.str();
  const std::size_t first = text.find("a.h5: 10 x 20 samples");
  const std::size_t second = text.find("a.h5", first + 1);
  const std::size_t third = text.find("warning: the beam is narrow");
  const std::size_t fourth = text.find("b.h5");
  EXPECT_LT(first, second);
  EXPECT_LT(second, third);
  EXPECT_LT(third, fourth);
  EXPECT_NE(fourth, std::string::npos) << text;
  EXPECT_EQ(out.str(), "");
}

TEST(Watch, ShowsNothingWhereQuietButHandsTheStopOn) {
  std::ostringstream out;
  std::ostringstream err;
  const core::StopFlag stop;
  Streams streams{out, err, true, &stop};
  Watch watch(streams, true);
  const core::Observer observer = watch.observer();
  observer.announces("a line");
  observer.remarks({core::error("wrong")});
  EXPECT_FALSE(observer.stage("a.h5"));
  EXPECT_EQ(err.str(), "");
  EXPECT_EQ(observer.control(3).stop, &stop);
  EXPECT_EQ(observer.control(3).threads, 3U);
}

}  // namespace watch_test
}  // namespace sarsim::cli
