// This source checks whatever the build does; expect_off_test.cpp never does.
#undef SARSIM_EXPECTATIONS
#define SARSIM_EXPECTATIONS 1
#include "core/report/expect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace sarsim::core {
namespace expect_test {

std::string message_of(void (*broken)()) {
  try {
    broken();
  } catch (const BrokenExpectation& error) {
    return error.what();
  }
  return {};
}

TEST(Expect, NamesFileLineAndConditionOfWhatIsBroken) {
  const auto kept = testing::MatchesRegex(".*core/report/expect_test\\.cpp:[0-9]+: expected: 1 > 2");
  EXPECT_THAT(message_of([] { CORE_EXPECT(1 > 2); }), kept);
  EXPECT_THAT(message_of([] { CORE_ENSURE(1 > 2); }), testing::HasSubstr(": ensured: 1 > 2"));
  EXPECT_THAT(message_of([] { CORE_ASSERT(1 > 2); }), testing::HasSubstr(": asserted: 1 > 2"));
}

TEST(Expect, LetsPassWhatHoldsAndEvaluatesItOnce) {
  int count = 0;
  CORE_EXPECT(++count == 1);
  CORE_ENSURE(++count == 2);
  CORE_ASSERT(std::array<int, 2>{1, 2}.size() == 2);
  EXPECT_EQ(count, 2);
}

TEST(Expect, BrokenIsAnInvalidArgument) {
  EXPECT_THROW(CORE_EXPECT(false), std::invalid_argument);
  EXPECT_THROW(expect(false, "what"), std::invalid_argument);
  EXPECT_NO_THROW(expect(true, "what"));
}

}  // namespace expect_test
}  // namespace sarsim::core
