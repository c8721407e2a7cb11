#include "core/hash/sha512.hpp"

#include <gmock/gmock.h>

#include <string_view>

namespace sarsim::core::sha512_test {

std::string digest_of(std::string_view text, std::size_t piece) {
  Sha512 sum;
  for (std::size_t i = 0; i < text.size(); i += piece) sum.add(std::as_bytes(std::span(text.substr(i, piece))));
  return sum.digest();
}

// The examples of FIPS 180-4: one block, two blocks, a million letters.
TEST(Sha512, GivesTheDigestsOfItsStandard) {
  EXPECT_EQ(
      digest_of("abc", 64),
      "ddaf35a193617abacc417349ae20413112e6fa4e89a97ea20a9eeee64b55d39a2192992a274fc1a836ba3c23a3feebbd454d4423643"
      "ce80e2a9ac94fa54ca49f");
  EXPECT_EQ(
      digest_of("", 1),
      "cf83e1357eefb8bdf1542850d66d8007d620e4050b5715dc83f4a921d36ce9ce47d0d13c5d85f2b0ff8318d2877eec2f63b931bd474"
      "17a81a538327af927da3e");
  constexpr std::string_view two_blocks =
      "abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrst"
      "u";
  EXPECT_EQ(
      digest_of(two_blocks, 1),
      "8e959b75dae313da8cf4f72814fc143f8f7779c6eb9f7fa17299aeadb6889018501d289e4900f7e4331b99dec4b5433ac7d329eeb6dd"
      "26545e96e55b874be909");
  EXPECT_EQ(
      digest_of(std::string(1000000, 'a'), 1000),
      "e718483d0ce769644e2e42c7bc15b4638e1f98b13b2044285632a803afa973ebde0ff244877ea60a4cb0432ce577c31beb009c5c2c49"
      "aa2e4eadb217ad8cc09b");
}

}  // namespace sarsim::core::sha512_test
