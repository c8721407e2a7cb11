#include "workflow/convert/references.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow {
namespace references_test {

constexpr std::uint64_t kibi = 1024;
constexpr std::uint64_t mebi = kibi * kibi;

TEST(References, CutArraysIntoFullPiecesOfAboutAMegabyte) {
  // 1240 rows of 4000 bytes: 310 of them, 1.2 MB, are the most below 2 MiB that divide them.
  const ArrayCut cut = cut_of_array(1240, 4000);
  EXPECT_EQ(cut.rows, 310U);
  EXPECT_EQ(cut.whole, 4U);
  EXPECT_EQ(cut.rest, 0U);
  // What is small stays whole, whatever its number of rows.
  EXPECT_EQ(cut_of_array(1009, 8).rows, 1009U);
  // What is long is cut into rows.
  EXPECT_EQ(cut_of_array(7, 5 * mebi).rows, 1U);
  EXPECT_EQ(cut_of_array(7, 5 * mebi).whole, 7U);
}

TEST(References, CutNumbersThatNothingDividesIntoSmallPieces) {
  const ArrayCut cut = cut_of_array(10007, 800);
  EXPECT_EQ(cut.rows, 64 * kibi / 800);
  EXPECT_EQ(cut.rows * cut.whole + cut.rest, 10007U);
  EXPECT_GT(cut.rest, 0U);
  EXPECT_LT(cut.rest, cut.rows);
}

TEST(References, AreNeverTooMany) {
  for (const std::uint64_t rows : {1'000'003ULL, 1'000'000ULL, 16'777'216ULL, 179'424'673ULL})
    for (const std::uint64_t row_bytes : {8ULL, 800ULL, 4096ULL, 100'000ULL}) {
      const ArrayCut cut = cut_of_array(rows, row_bytes);
      ASSERT_EQ(cut.rows * cut.whole + cut.rest, rows);
      if (rows * row_bytes <= 4096 * 64 * mebi) {
        EXPECT_LE(cut.whole, 70'000U) << rows << " " << row_bytes;
      }
      EXPECT_LE(cut.rows * row_bytes, 128 * mebi);
    }
}

}  // namespace references_test
}  // namespace sarsim::workflow
