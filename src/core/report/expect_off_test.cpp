#undef SARSIM_EXPECTATIONS
#include "core/report/expect.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {
namespace expect_off_test {

TEST(ExpectOff, EvaluatesNothing) {
  int count = 0;
  CORE_EXPECT(++count > 5);
  CORE_ENSURE(++count > 5);
  CORE_ASSERT(++count > 5);
  EXPECT_EQ(count, 0);
}

}  // namespace expect_off_test
}  // namespace sarsim::core
