#include "scene/language/reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "scene/language/keys.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/scene_reader.hpp"
#include "support/folders.hpp"

namespace sarsim::scene::language {
namespace reference_test {

using testing::HasSubstr;

TEST(Reference, HasEveryField) {
  const std::string page = reference();
  for (const PlainTable& table : plain_tables()) {
    EXPECT_THAT(page, HasSubstr(fmt::format("### {}\n", table.header_line())));
    for (const PathFacts& facts : paths_of(table)) {
      const bool is_list = facts.role == PathRole::interpolation && facts.spec().block->x_ignored;
      if (is_list) continue;
      EXPECT_THAT(page, HasSubstr(fmt::format("`{}`", facts.path))) << table.header;
      const std::string example = example_text(table, facts);
      if (facts.part != 0) continue;
      EXPECT_THAT(page, HasSubstr(fmt::format("`{}`", example.substr(0, example.find('\n'))))) << table.header;
    }
  }
}

TEST(Reference, HasASectionForEveryChoiceWithFields) {
  const std::string page = reference();
  for (const char* const choice : {"platform.path", "target.reflectivity", "target.reflectivity.gain", "radar.pulse",
                                   "radar.carrier", "radar.receive_antenna", "radar.beam"})
    EXPECT_THAT(page, HasSubstr(fmt::format("#### {}\n", choice)));
  for (const char* const word : {"`chirp`", "`CHIRP`", "`line`"}) EXPECT_THAT(page, HasSubstr(word));
}

TEST(Reference, RowsHaveTheColumnsOfTheirTables) {
  std::istringstream lines(reference());
  std::ptrdiff_t columns = 0;
  for (std::string line; std::getline(lines, line);) {
    std::ptrdiff_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    if (!line.starts_with('|')) {
      columns = 0;
    } else {
      EXPECT_EQ(bars, columns == 0 ? bars : columns) << line;
      columns = bars;
    }
  }
}

std::string page_text() {
  std::ifstream file(test::source_folder() / "docs/formats/scene.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Reference, FirstSceneOfThePageIsReadWithoutAComplaint) {
  const std::string page = page_text();
  const std::size_t begin = page.find("format = \"sarsim 2\"\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string scene = page.substr(begin, page.find("```", begin) - begin);
  const ScriptReading reading = read_format_2(scene, "first.toml", {});
  for (const core::Problem& problem : reading.problems) ADD_FAILURE() << core::to_string(problem);
  EXPECT_EQ(reading.scene.targets.size(), 3U);
  EXPECT_EQ(reading.scene.simulations.size(), 1U);
}

// The page is filled by `sarsim explain --reference`.
TEST(Reference, PageHasWhatTheProgramSays) {
  const std::string page = page_text();
  const std::string mark = "<!-- generated: sarsim explain --reference -->\n";
  const std::size_t begin = page.find(mark);
  const std::size_t end = page.find("<!-- end -->");
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const std::string between = page.substr(begin + mark.size(), end - begin - mark.size());
  EXPECT_TRUE(between == "\n" + reference() + "\n") << "fill it with sarsim explain --reference";
}

}  // namespace reference_test
}  // namespace sarsim::scene::language
