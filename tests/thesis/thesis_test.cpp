// The numbers that the thesis prints, against the table of docs/theory/thesis-numbers.md: the table and the simulator
// cannot part.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "thesis/table.hpp"
#include "workflow/verify/thesis_numbers.hpp"

namespace sarsim::workflow::verify {

// What a failure prints for the parameter; found by name lookup.
void PrintTo(const ThesisNumber& number, std::ostream* out) { *out << number.name; }

}  // namespace sarsim::workflow::verify

namespace sarsim::test {

using workflow::verify::thesis_numbers;
using workflow::verify::ThesisNumber;

namespace thesis_test {

const std::map<std::string, TableRow>& table() {
  static const auto rows = read_table(SARSIM_DOCS "/theory/thesis-numbers.md");
  return rows;
}

class ThesisNumbers : public testing::TestWithParam<ThesisNumber> {};

TEST_P(ThesisNumbers, AreAsTheTableSays) {
  const auto found = table().find(GetParam().name);
  ASSERT_NE(found, table().end()) << "the table has no row " << GetParam().name;
  const TableRow& row = found->second;
  ASSERT_TRUE(row.classic || row.physical) << "the row promises nothing";
  for (const auto& [profile, promised] :
       {std::pair{scene::Profile::classic, row.classic}, std::pair{scene::Profile::physical, row.physical}}) {
    if (!promised) continue;
    const double value = GetParam().value(profile);
    const char* name = profile == scene::Profile::classic ? "classic" : "physical";
    std::printf("%-24s %-8s %.7g, table %.7g, tolerance %g\n", GetParam().name.c_str(), name, value, *promised,
                row.tolerance);
    EXPECT_NEAR(value, *promised, row.tolerance) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Thesis, ThesisNumbers, testing::ValuesIn(thesis_numbers()),
                         [](const auto& one) { return one.param.name; });

TEST(ThesisTable, HasARowForEveryNumberAndANumberForEveryRow) {
  std::vector<std::string> rows;
  for (const auto& [name, row] : table()) rows.push_back(name);
  std::vector<std::string> numbers;
  for (const ThesisNumber& number : thesis_numbers()) numbers.push_back(number.name);
  std::ranges::sort(numbers);
  EXPECT_EQ(rows, numbers);
}

// What `sarsim verify` expects is what the page says.
TEST_P(ThesisNumbers, AreExpectedAsTheTableSays) {
  const TableRow& row = table().at(GetParam().name);
  ASSERT_TRUE(row.classic && row.physical);
  EXPECT_EQ(GetParam().classic, *row.classic);
  EXPECT_EQ(GetParam().physical, *row.physical);
  EXPECT_EQ(GetParam().tolerance, row.tolerance);
}

}  // namespace thesis_test
}  // namespace sarsim::test
