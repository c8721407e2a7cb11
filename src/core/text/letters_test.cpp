#include "core/text/letters.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {

TEST(Letters, AreThoseOfAscii) {
  for (const char c : std::string_view("azAZmM")) EXPECT_TRUE(is_letter(c)) << c;
  for (const char c : std::string_view("09@[`{_-\xC3\xA4")) EXPECT_FALSE(is_letter(c)) << c;
  for (const char c : std::string_view("09")) EXPECT_TRUE(is_digit(c)) << c;
  for (const char c : std::string_view("/:aA")) EXPECT_FALSE(is_digit(c)) << c;
}

TEST(Letters, BlanksAreTrimmedAtTheEndsAlone) {
  EXPECT_EQ(trimmed(" \t\r\na b\r\n"), "a b");
  EXPECT_EQ(trimmed("\v"), "\v");
  EXPECT_EQ(trimmed(" \n"), "");
  EXPECT_EQ(trimmed(""), "");
}

}  // namespace sarsim::core
