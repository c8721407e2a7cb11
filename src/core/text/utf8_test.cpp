#include "core/text/utf8.hpp"

#include <gtest/gtest.h>

#include "core/text/json.hpp"

namespace sarsim::core {

TEST(Utf8, HasTheBytesOfTheStandard) {
  const auto bytes = [](char32_t code) {
    std::string text = ">";
    append_utf8(text, code);
    return text;
  };
  EXPECT_EQ(bytes(0x41), ">A");
  EXPECT_EQ(bytes(0xB5), ">\xC2\xB5");
  EXPECT_EQ(bytes(0x20AC), ">\xE2\x82\xAC");
  EXPECT_EQ(bytes(0x1F600), ">\xF0\x9F\x98\x80");
  for (const char32_t code : {0x7FU, 0x80U, 0x7FFU, 0x800U, 0xD7FFU, 0xE000U, 0xFFFFU, 0x10000U, 0x10FFFFU})
    EXPECT_EQ(valid_utf8(bytes(code)), bytes(code)) << std::hex << static_cast<unsigned>(code);
}

TEST(Utf8, KnowsWhatIsNoCharacter) {
  for (const char32_t code : {1U, 0xD7FFU, 0xE000U, 0x10FFFFU}) EXPECT_TRUE(is_character(code));
  for (const char32_t code : {0U, 0xD800U, 0xDFFFU, 0x110000U}) EXPECT_FALSE(is_character(code));
}

}  // namespace sarsim::core
