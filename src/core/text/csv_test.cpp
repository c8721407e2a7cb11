#include "core/text/csv.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {

TEST(Csv, SplitsLinesAndQuotes) {
  const CsvTable table = read_csv("name,range_m\r\n\"a, \"\"b\"\"\nc\",1.5\n,\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"name", "range_m"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"a, \"b\"\nc", "1.5"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"", ""}));
}

TEST(Csv, RowsAreAsLongAsTheNames) {
  const CsvTable table = read_csv("a,b,c\n1\n1,2,3,4");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"1", "", ""}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_TRUE(read_csv("").names.empty());
}

TEST(Csv, ACellIsReadBackAsItWas) {
  EXPECT_EQ(csv_cell("a b"), "a b");
  EXPECT_EQ(csv_cell("a,\"b\""), "\"a,\"\"b\"\"\"");
  for (const std::string text : {"", "a", "a,b", "\"", "\"\"", "a\r\nb", ","})
    EXPECT_EQ(csv_cells(csv_cell(text) + "," + csv_cell(text) + "\r\n"), (std::vector<std::string>{text, text}))
        << text;
}

}  // namespace sarsim::core
