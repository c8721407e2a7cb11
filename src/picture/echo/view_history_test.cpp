#include "picture/echo/view_history.hpp"

#include <gtest/gtest.h>

#include "picture/echo/echo_window.hpp"

namespace sarsim::picture {
namespace view_history_test {

TEST(ViewHistory, GoesBackAndForwardAndForgetsWhatLayAhead) {
  ViewHistory<EchoView> history;
  const EchoView a{1.0, 2.0, 0.0, 1.0};
  const EchoView b{2.0, 3.0, 0.0, 1.0};
  const EchoView c{3.0, 4.0, 0.0, 1.0};
  EXPECT_FALSE(history.can_go_back());
  EXPECT_EQ(history.back(a), a);
  EXPECT_EQ(history.forward(a), a);
  history.leave(a);  // to b
  history.leave(b);  // to c
  EXPECT_EQ(history.back(c), b);
  EXPECT_EQ(history.back(b), a);
  EXPECT_FALSE(history.can_go_back());
  EXPECT_EQ(history.forward(a), b);
  EXPECT_TRUE(history.can_go_forward());
  history.leave(b);
  EXPECT_FALSE(history.can_go_forward());
  for (int i = 0; i < 200; ++i) history.leave({0.0, 1.0 + i, 0.0, 1.0});
  int steps = 0;
  for (EchoView at = c; history.can_go_back(); ++steps) at = history.back(at);
  EXPECT_EQ(steps, 100);
}

TEST(ViewHistory, KeepsAViewThatIsLeftTwiceOnce) {
  ViewHistory<int> history;
  history.leave(1);
  history.leave(1);
  EXPECT_EQ(history.back(2), 1);
  EXPECT_FALSE(history.can_go_back());
  history.clear();
  EXPECT_FALSE(history.can_go_forward());
}

}  // namespace view_history_test
}  // namespace sarsim::picture
