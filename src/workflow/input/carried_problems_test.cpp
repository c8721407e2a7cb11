#include "workflow/input/carried_problems.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow {
namespace carried_problems_test {

std::string found_of(const std::string& found) {
  return without_quotes({core::warning("m").found(found)}).front().found;
}

TEST(CarriedProblems, KeepNumbersAndTheirUnits) {
  EXPECT_EQ(found_of("about 0.034 m off between states near 12 s, 1.1 wavelengths of radar Secret; a state every 10 s"),
            "about 0.034 m off between states near 12 s, 1.1 wavelengths of radar ... a state every 10 s");
  EXPECT_EQ(found_of("2.5e-3 rad"), "2.5e-3 rad");
}

TEST(CarriedProblems, LeaveNoWordsOfAFile) {
  EXPECT_EQ(found_of("hunter2"), "");
  EXPECT_EQ(found_of("alpha bravo"), "");
  EXPECT_EQ(found_of("1 alpha bravo 2"), "1 ... 2");
  EXPECT_EQ(without_quotes({core::error("x: 'alpha' is no 'bravo'")}).front().message, "x: '...' is no '...'");
}

}  // namespace carried_problems_test
}  // namespace sarsim::workflow
