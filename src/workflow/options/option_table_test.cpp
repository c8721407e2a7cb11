#include "workflow/options/option_table.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <optional>

namespace sarsim::workflow::option_table_test {

namespace {

struct Part {
  std::optional<double> height_m;
};

struct Asked {
  Part part;
  std::filesystem::path output;
  unsigned threads = 7;
  std::optional<int> grid;
  bool image = true;
};

OptionTable<Asked> table_of_asked() {
  OptionTable<Part> part;
  part.number("--height", "M", "of the ground", &Part::height_m);
  OptionTable<Asked> table;
  table.text("--out", "OUT", "what to write", &Asked::output);
  table.text("--never", "X", "", [](Asked&, const std::string& word) { throw core::InvalidRequest("no " + word); })
      .told_late = true;
  table.include(part, &Asked::part);
  table.whole("--threads", 0, 64, "", &Asked::threads);
  table.choice<int>("--grid", {{"slant", 1}, {"ground", 2}}, "", &Asked::grid);
  table.flag("--no-map", "", &Asked::image, false);
  return table;
}

}  // namespace

TEST(OptionTable, TakesWordsIntoTheRequest) {
  Asked asked;
  const TakenProblems problems = table_of_asked().take_words(
      {{"--out", "a.npy"}, {"--height", "12.5"}, {"--grid", "Ground"}, {"--no-map", ""}}, asked);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(asked.output, "a.npy");
  EXPECT_EQ(asked.part.height_m, 12.5);
  EXPECT_EQ(asked.grid, 2);
  EXPECT_EQ(asked.threads, 7U);
  EXPECT_FALSE(asked.image);
}

TEST(OptionTable, TakesWhatItCanAndTellsTheRest) {
  Asked asked;
  const TakenProblems problems =
      table_of_asked().take_words({{"--never", "way"}, {"--threads", "65"}, {"--height", "3"}, {"--gird", "x"}}, asked);
  ASSERT_EQ(problems.early.size(), 2U);
  EXPECT_EQ(problems.early[0].hint, "did you mean '--grid'?");
  EXPECT_EQ(problems.early[1].message, "--threads: '65' is not a whole number from 0 to 64");
  ASSERT_EQ(problems.late.size(), 1U);
  EXPECT_EQ(problems.late[0].message, "no way");
  EXPECT_EQ(asked.threads, 7U);
  EXPECT_EQ(asked.part.height_m, 3.0);
}

TEST(OptionTable, ShowsItsOptionsInTheirOrder) {
  const std::vector<Option> options = table_of_asked().options();
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(option.name);
  EXPECT_THAT(names, testing::ElementsAre("--out", "--never", "--height", "--threads", "--grid", "--no-map"));
  EXPECT_EQ(options[4].placeholder, "slant|ground");
  EXPECT_EQ(options[2].placeholder, "M");
  EXPECT_EQ(options[2].help, "of the ground");
}

}  // namespace sarsim::workflow::option_table_test
