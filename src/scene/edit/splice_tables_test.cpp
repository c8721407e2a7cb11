#include "scene/edit/splice_tables.hpp"

#include <gtest/gtest.h>

#include "scene/edit/document.hpp"
#include "scene/edit/splice_format_2.hpp"

namespace sarsim::scene {
namespace splice_tables_test {

// Where everything stands is not looked for again when rows of a list change.
TEST(SpliceTables, AreMovedWithTheRowsThatChange) {
  const std::string text = R"(# A list, and what stands about it.
format = "sarsim 2"

[[target]]
position = [0, 0, 0]

# four points
[[target]]
positions = [
  [1, 0, 0],  # first
  [2, 0, 0],
  [3, 0, 0],
  [4, 0, 0]   # last
]
rcs = "3 m2"

[[radar]]
name = "R"
pulse.type = "chirp"

[[target]]
positions = [[7, 8, 9], [10, 11, 12]]

[options]
seed = 7
)";
  Document document = Document::from_text(text);
  for (int i = 0; i < 10; ++i) {
    const format_2::ObjectTables before = format_2::find_tables(document.text());
    const std::string text_before = document.text();
    Edit edit;
    for (const std::size_t index : {1U, 3U, 6U}) {
      Target target = document.scene().targets[index];
      target.position_m.y = i % 2 == 0 ? -1234.5 * i : i;
      edit.changes.push_back(replace_object(document.scene(), {ObjectKind::target, index}, target, "").changes[0]);
    }
    edit.label = "Move";
    const Format2Splice splice = splice_format_2(text_before, before, {}, document.scene(), edit, "", {});
    EXPECT_TRUE(splice.rows_alone);
    const format_2::ObjectTables moved = format_2::after_changes(before, splice.changes);
    const format_2::ObjectTables found = format_2::find_tables(splice.text);
    ASSERT_EQ(moved.document.tables.size(), found.document.tables.size());
    ASSERT_EQ(moved.document.entries.size(), found.document.entries.size());
    for (std::size_t t = 0; t < found.document.tables.size(); ++t) {
      EXPECT_EQ(moved.document.tables[t].header, found.document.tables[t].header);
      EXPECT_EQ(moved.document.tables[t].name, found.document.tables[t].name);
    }
    for (std::size_t e = 0; e < found.document.entries.size(); ++e) {
      EXPECT_EQ(moved.document.entries[e].key, found.document.entries[e].key);
      EXPECT_EQ(moved.document.entries[e].value.span, found.document.entries[e].value.span);
    }
    for (std::size_t t = 0; t < found[ObjectKind::target].size(); ++t) {
      const auto& [own, other] = std::pair(moved[ObjectKind::target][t], found[ObjectKind::target][t]);
      ASSERT_EQ(own.positions.has_value(), other.positions.has_value());
      if (own.positions) {
        EXPECT_EQ(own.positions->span, other.positions->span);
      }
      EXPECT_EQ(own.positions_key, other.positions_key);
    }
    static_cast<void>(document.commands());
    document.perform(edit);
    ASSERT_EQ(document.text(), splice.text);
    EXPECT_EQ(document.commands(), find_objects(document.text(), found));
  }
}

// A field of a leg is changed: all else of the leg stands as it was typed.
TEST(SpliceTables, ChangesOneFieldOfAnEntryOfAList) {
  Document document = Document::from_text(R"toml(format = "sarsim 2"
[let]
side = "10 km"

[[platform]]
name = "Tour"
path = { type = "legs", speed = "180 km/h", legs = [
  { leg = "straight", length = "side" },  # out
  { leg = "turn", angle = "180 deg", bank = "atan(1)" },
  { leg = "straight", length = "side / 2", acceleration = 0.1 },  # and back
] }
)toml");
  Platform platform = document.scene().platforms.at(0);
  platform.legs[1].angle = core::Angle::from_deg(90.0);
  platform.legs[2].acceleration_mps2 = 0.0;
  document.perform(replace_object(document.scene(), {ObjectKind::platform, 0}, platform, "Change legs"));
  const std::string& text = document.text();
  EXPECT_NE(text.find("{ leg = \"turn\", angle = \"90 deg\", bank = \"atan(1)\" },\n"), std::string::npos) << text;
  EXPECT_NE(text.find("{ leg = \"straight\", length = \"side / 2\" },  # and back\n"), std::string::npos) << text;
  EXPECT_NE(text.find("{ leg = \"straight\", length = \"side\" },  # out\n"), std::string::npos) << text;
  EXPECT_EQ(Document::from_text(text).scene(), document.scene());
}

}  // namespace splice_tables_test
}  // namespace sarsim::scene
