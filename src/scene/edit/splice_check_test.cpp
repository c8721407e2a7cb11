#include "scene/edit/splice_check.hpp"

#include <gtest/gtest.h>

#include "scene/language/scene_reader.hpp"

namespace sarsim::scene {
namespace splice_check_test {

// Of a list only the rows that are changed are read again.
TEST(SpliceCheck, ReadsTheChangedRowsOfAListAlone) {
  const std::string text =
      "format = \"sarsim 2\"\n[let]\ntop = \"2 m\"\n[[target]]\nrcs = \"3 "
      "m2\"\npositions=[[1,2,3],[4,5,\"top\"],[7,8,9],]\n";
  const format_2::ObjectTables tables = format_2::find_tables(text);
  const format_2::ObjectTable& table = tables[ObjectKind::target].at(0);
  const std::size_t row = text.find("[4,5");
  const format_2::ChangedTable changed{ObjectKind::target, &table, 0, 3,
                                       std::vector<format_2::ChangedRow>{{1, {row, text.find(",[7")}}}};
  Scene after = read_format_2(text, "", {}).scene;
  const auto says = [&](const std::string& was, const std::string& becomes) {
    const TextChanges changes{{text.find(was), was, becomes}};
    return format_2::tables_say(text, tables, changes, {changed}, after, "", {});
  };
  after.targets[1].position_m = {6.0, 5.0, 2.0};
  EXPECT_TRUE(says("4,5", "6,5"));
  EXPECT_FALSE(says("4,5", "66,5"));
  EXPECT_FALSE(says("4,5", "6,"));
  EXPECT_FALSE(says("4,5", "6,5],[6,5"));
  EXPECT_FALSE(says("[7,8", "[6,8"));  // another row
  after.targets[1].rcs_m2 = 4.0;
  EXPECT_FALSE(says("4,5", "6,5"));
}

}  // namespace splice_check_test
}  // namespace sarsim::scene
