#include "cli/command/part_options.hpp"

#include <gtest/gtest.h>

namespace sarsim::cli {
namespace {

PartChoice share(std::int64_t number, std::int64_t count) {
  PartChoice choice;
  choice.share = PartChoice::Share{number, count};
  return choice;
}

PartChoice pulses(std::int64_t first, std::optional<std::int64_t> last) {
  PartChoice choice;
  choice.span = PartChoice::Span{first, last};
  return choice;
}

TEST(RowsOf, SharesAreTheWholeWithoutOverlapAndDifferByOneRowAtMost) {
  for (const std::size_t rows : {0U, 1U, 7U, 100U, 1001U})
    for (const std::int64_t count : {1, 2, 3, 7, 64}) {
      std::size_t next = 0;
      for (std::int64_t number = 1; number <= count; ++number) {
        const simulate::RowRange range = rows_of(share(number, count), rows);
        EXPECT_EQ(range.first, next);
        EXPECT_GE(range.count, rows / static_cast<std::size_t>(count));
        EXPECT_LE(range.count, rows / static_cast<std::size_t>(count) + 1);
        next = range.end();
      }
      EXPECT_EQ(next, rows);
    }
}

TEST(RowsOf, PulsesCountFromOneWithBothEnds) {
  EXPECT_EQ(rows_of(pulses(101, 200), 1000), (simulate::RowRange{100, 100}));
  EXPECT_EQ(rows_of(pulses(1, 1), 1000), (simulate::RowRange{0, 1}));
  EXPECT_EQ(rows_of(pulses(991, std::nullopt), 1000), (simulate::RowRange{990, 10}));
  EXPECT_EQ(rows_of(pulses(991, 2000), 1000), (simulate::RowRange{990, 10}));
  EXPECT_EQ(rows_of(pulses(1001, 2000), 1000).count, 0U);
  EXPECT_EQ(rows_of({}, 1000), (simulate::RowRange{0, 1000}));
}

TEST(PartNames, TellSharesApart) {
  EXPECT_EQ(words_of(share(3, 8)), "3/8");
  EXPECT_EQ(file_name_of(share(3, 8)), "part-3-of-8");
  EXPECT_EQ(words_of(pulses(5, 9)), "5:9");
  EXPECT_EQ(file_name_of(pulses(5, std::nullopt)), "pulses-5-end");
  EXPECT_EQ(words_of({}), "1/1");
  EXPECT_EQ(file_name_of({}), "all");
}

}  // namespace
}  // namespace sarsim::cli
