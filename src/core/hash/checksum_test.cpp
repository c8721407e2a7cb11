#include "core/hash/checksum.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sarsim::core {
namespace checksum_test {

std::uint64_t in_pieces(const std::string& text, std::size_t piece) {
  Checksum sum;
  for (std::size_t i = 0; i < text.size(); i += piece) sum.add(std::string_view(text).substr(i, piece));
  return sum.value();
}

// Known answers of XXH64 with seed 0.
TEST(Checksum, GivesTheKnownAnswers) {
  EXPECT_EQ(checksum_of(""), 0xef46db3751d8e999U);
  EXPECT_EQ(checksum_of("a"), 0xd24ec4f1a98c6e5bU);
  EXPECT_EQ(checksum_of("abc"), 0x44bc2cf5ad770999U);
  EXPECT_EQ(checksum_of("Nobody inspects the spammish repetition"), 0xfbcea83c8a378bf1U);
}

TEST(Checksum, DoesNotDependOnHowTheBytesArePieced) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += static_cast<char>(i * 37);
  for (const std::size_t piece : {1U, 3U, 31U, 32U, 33U, 64U, 999U})
    EXPECT_EQ(in_pieces(text, piece), checksum_of(text));
}

TEST(Checksum, GoesOnFromACopyWithoutTouchingTheOther) {
  Checksum sum;
  sum.add("a");
  Checksum copy = sum;
  copy.add("bc");
  EXPECT_EQ(sum.value(), checksum_of("a"));
  EXPECT_EQ(copy.value(), checksum_of("abc"));
  sum = copy;
  EXPECT_EQ(sum.value(), copy.value());
}

TEST(Checksum, SeesEveryByteAndTheLength) {
  const std::string text(100, 'x');
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = 'y';
    EXPECT_NE(checksum_of(other), checksum_of(text)) << i;
  }
  EXPECT_NE(checksum_of(text + 'x'), checksum_of(text));
}

}  // namespace checksum_test
}  // namespace sarsim::core
