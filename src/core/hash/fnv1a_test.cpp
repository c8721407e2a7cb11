#include "core/hash/fnv1a.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {
namespace fnv1a_test {

// Published with the algorithm.
TEST(Fnv1a, GivesTheKnownAnswers) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
}

TEST(Fnv1a, GoesOnFromTheTextBefore) { EXPECT_EQ(fnv1a("bar", fnv1a("foo")), fnv1a("foobar")); }

TEST(Fnv1a, TakesBytesAbove127AsNumbersWithoutSign) {
  EXPECT_EQ(fnv1a("\xff"), (fnv1a_of_nothing ^ 0xffU) * 0x100000001b3U);
}

}  // namespace fnv1a_test
}  // namespace sarsim::core
