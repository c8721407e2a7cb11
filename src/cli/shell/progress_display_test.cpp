#include "cli/shell/progress_display.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace sarsim::cli {
namespace progress_display_test {

using Style = ProgressDisplay::Style;

struct Clock {
  double now_s = 100.0;
  std::function<double()> reader() {
    return [this] { return now_s; };
  }
};

TEST(ProgressDisplay, LinesComeOncePerTenth) {
  std::ostringstream out;
  Clock clock;
  {
    ProgressDisplay display(out, Style::lines, "a.asc", clock.reader());
    for (std::size_t done = 1; done <= 1000; ++done) {
      clock.now_s += 0.01;
      display.update({done, 1000, 50});
    }
  }
  const std::string text = out.str();
  EXPECT_EQ(std::ranges::count(text, '\n'), 10);
  EXPECT_EQ(text.substr(0, text.find('\n')), "a.asc: 10 %, 5 ksamples/s, 9 s left");
  EXPECT_NE(text.find("a.asc: 100 %, 5 ksamples/s\n"), std::string::npos);
}

TEST(ProgressDisplay, BigStepsGiveOneLine) {
  std::ostringstream out;
  Clock clock;
  ProgressDisplay display(out, Style::lines, "a", clock.reader());
  clock.now_s += 2.0;
  display.update({8, 10, 0});
  EXPECT_EQ(out.str(), "a: 80 %, 4 lines/s, 0.5 s left\n");
}

TEST(ProgressDisplay, ShortWorkGivesNoLines) {
  std::ostringstream out;
  Clock clock;
  ProgressDisplay display(out, Style::lines, "a", clock.reader());
  for (std::size_t done = 1; done <= 10; ++done) {
    clock.now_s += 0.049;
    display.update({done, 10, 0});
  }
  EXPECT_EQ(out.str(), "");
}

TEST(ProgressDisplay, BarIsRedrawnAtMostTenTimesASecond) {
  std::ostringstream out;
  Clock clock;
  {
    ProgressDisplay display(out, Style::bar, "a", clock.reader());
    for (std::size_t done = 1; done <= 1000; ++done) {
      clock.now_s += 0.001;
      display.update({done, 1000, 50});
    }
    const std::string drawn = out.str();
    EXPECT_LE(std::ranges::count(drawn, '\r'), 10);
    EXPECT_GE(std::ranges::count(drawn, '\r'), 9);
    EXPECT_EQ(drawn.find('\n'), std::string::npos);
  }
  EXPECT_EQ(out.str().substr(out.str().size() - 2), " \r");  // Wiped out.
}

TEST(ProgressDisplay, NoneWritesNothing) {
  std::ostringstream out;
  {
    ProgressDisplay display(out, Style::none, "a");
    display.update({5, 10, 1});
  }
  EXPECT_TRUE(out.str().empty());
}

TEST(ProgressDisplay, WorkWithoutUnitsIsSilent) {
  std::ostringstream out;
  ProgressDisplay display(out, Style::lines, "a");
  display.update({0, 0, 0});
  EXPECT_TRUE(out.str().empty());
}

}  // namespace progress_display_test
}  // namespace sarsim::cli
