#include "workflow/record/part_choice.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow {
namespace part_choice_test {

PartChoice share_choice(std::int64_t number, std::int64_t count) {
  PartChoice choice;
  choice.share = PartChoice::Share{number, count};
  return choice;
}

PartChoice span_choice(std::int64_t first, std::optional<std::int64_t> last) {
  PartChoice choice;
  choice.span = PartChoice::Span{first, last};
  return choice;
}

TEST(RowsOf, SharesAreTheWholeWithoutOverlapAndDifferByOneRowAtMost) {
  for (const std::size_t rows : {0U, 1U, 7U, 100U, 1001U})
    for (const std::int64_t count : {1, 2, 3, 7, 64}) {
      std::size_t next = 0;
      for (std::int64_t number = 1; number <= count; ++number) {
        const raster::RowRange range = rows_of(share_choice(number, count), rows);
        EXPECT_EQ(range.first, next);
        EXPECT_GE(range.count, rows / static_cast<std::size_t>(count));
        EXPECT_LE(range.count, rows / static_cast<std::size_t>(count) + 1);
        next = range.end();
      }
      EXPECT_EQ(next, rows);
    }
}

TEST(RowsOf, PulsesCountFromOneWithBothEnds) {
  EXPECT_EQ(rows_of(span_choice(101, 200), 1000), (raster::RowRange{100, 100}));
  EXPECT_EQ(rows_of(span_choice(1, 1), 1000), (raster::RowRange{0, 1}));
  EXPECT_EQ(rows_of(span_choice(991, std::nullopt), 1000), (raster::RowRange{990, 10}));
  EXPECT_EQ(rows_of(span_choice(991, 2000), 1000), (raster::RowRange{990, 10}));
  EXPECT_EQ(rows_of(span_choice(1001, 2000), 1000).count, 0U);
  EXPECT_EQ(rows_of({}, 1000), (raster::RowRange{0, 1000}));
}

TEST(PartNames, TellSharesApart) {
  EXPECT_EQ(words_of(share_choice(3, 8)), "3/8");
  EXPECT_EQ(file_name_of(share_choice(3, 8)), "part-3-of-8");
  EXPECT_EQ(words_of(span_choice(5, 9)), "5:9");
  EXPECT_EQ(file_name_of(span_choice(5, std::nullopt)), "pulses-5-end");
  EXPECT_EQ(words_of({}), "1/1");
  EXPECT_EQ(file_name_of({}), "all");
}

TEST(PartChoice, ReadsSharesAndRangesOfPulses) {
  const auto part = share_from("3/8");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->number, 3);
  EXPECT_EQ(part->count, 8);
  for (const char* text : {"", "3", "0/8", "9/8", "3/", "/8", "1/1000001", "a/b"}) EXPECT_FALSE(share_from(text));
  const auto open = span_from(":200");
  ASSERT_TRUE(open);
  EXPECT_EQ(open->first, 1);
  EXPECT_EQ(open->last, 200);
  EXPECT_FALSE(span_from("101:")->last);
  for (const char* text : {"", "5", "0:3", "4:3", "a:3", "1:b"}) EXPECT_FALSE(span_from(text));
}

TEST(PartChoice, SharesOfPiecesHaveWholePieces) {
  // 23 rows in pieces of 5: the last one is not full.
  std::size_t next = 0;
  for (std::int64_t number = 1; number <= 3; ++number) {
    PartChoice choice;
    choice.share = {number, 3};
    const raster::RowRange range = rows_of(choice, 23, 5);
    EXPECT_EQ(range.first, next);
    EXPECT_EQ(range.first % 5, 0U);
    next = range.end();
  }
  EXPECT_EQ(next, 23U);
  // More shares than pieces: nobody is left without rows.
  PartChoice choice;
  choice.share = {7, 8};
  EXPECT_EQ(rows_of(choice, 23, 5).count, 3U);
}

}  // namespace part_choice_test
}  // namespace sarsim::workflow
