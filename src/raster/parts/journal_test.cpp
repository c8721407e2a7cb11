#include "raster/parts/journal.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/os/journal_file.hpp"
#include "raster/format/data_test_support.hpp"
#include "raster/parts/join_parts.hpp"

namespace sarsim::raster {
namespace journal_test {

using testing::ElementsAre;
using testing::HasSubstr;

Claim claim_of(std::size_t first, std::size_t count) {
  Claim claim;
  claim.rows = {first, count};
  claim.offset = 10 * first;
  claim.bytes = 10 * count;
  claim.checksum = 0x0123456789abcdefU;
  claim.seconds = 1.25;
  claim.tally = {1.0 / 3.0, 5, 7};
  return claim;
}

JournalHead test_head() {
  return {{{"seed", "1"}, {"script", "00"}}, "3/8", {20, 10}, RowStore::volts, "node 7, process 4711"};
}

Journal parsed(const std::string& text) {
  auto read = parse_journal("a.journal", text);
  if (const auto* problem = std::get_if<core::Problem>(&read)) {
    ADD_FAILURE() << core::to_string(*problem);
    return {};
  }
  return std::get<Journal>(read);
}

void expect_damage(const std::string& text, std::size_t line) {
  const auto read = parse_journal("a.journal", text);
  const auto* problem = std::get_if<core::Problem>(&read);
  ASSERT_NE(problem, nullptr);
  EXPECT_THAT(problem->message, HasSubstr("damaged"));
  EXPECT_EQ(problem->place.line, line);
}

Journal journal_of(const std::string& part, RowRange range, const std::vector<Claim>& claims,
                   const Identity& identity = {}) {
  return {part + ".journal", {identity, part, range, RowStore::placed, ""}, claims, 0};
}

TEST(Journal, ReadsWhatItsTextSays) {
  const std::string text = text_of(test_head()) + text_of(claim_of(20, 4)) + text_of(claim_of(24, 6));
  const Journal journal = parsed(text);
  EXPECT_EQ(journal.head.identity, test_head().identity);
  EXPECT_EQ(journal.head.part, "3/8");
  EXPECT_EQ(journal.head.range, (RowRange{20, 10}));
  EXPECT_EQ(journal.head.store, RowStore::volts);
  EXPECT_EQ(journal.head.maker, "node 7, process 4711");
  EXPECT_EQ(journal.bytes, text.size());
  ASSERT_EQ(journal.claims.size(), 2U);
  EXPECT_EQ(journal.claimed_rows(), 10U);
  const Claim claim = journal.claims[1];
  EXPECT_EQ(claim.rows, (RowRange{24, 6}));
  EXPECT_EQ(claim.offset, 240U);
  EXPECT_EQ(claim.bytes, 60U);
  EXPECT_EQ(claim.checksum, 0x0123456789abcdefU);
  EXPECT_EQ(claim.seconds, 1.25);
  EXPECT_EQ(claim.tally.maximum_v, 1.0 / 3.0);
  EXPECT_EQ(claim.tally.saturated, 5U);
  EXPECT_EQ(claim.tally.zero, 7U);
}

TEST(Journal, LeavesOutALastLineThatWasNotFinished) {
  const std::string whole = text_of(test_head()) + text_of(claim_of(20, 4));
  const std::string last = text_of(claim_of(24, 6));
  for (std::size_t size = 0; size < last.size(); ++size) {
    const Journal journal = parsed(whole + last.substr(0, size));
    EXPECT_EQ(journal.claims.size(), 1U);
    EXPECT_EQ(journal.bytes, whole.size());
  }
}

TEST(Journal, IsDamagedWhereAnyByteOfAWholeLineIsAnother) {
  const std::string text = text_of(test_head()) + text_of(claim_of(20, 4));
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    std::string other = text;
    other[i] = static_cast<char>(other[i] ^ 1);
    EXPECT_TRUE(std::holds_alternative<core::Problem>(parse_journal("a.journal", other))) << i;
  }
  expect_damage(text + "rows 24 6\n", 10);
}

TEST(Journal, IsDamagedWhereItsEntriesMeetOrTheBeginIsMissing) {
  const std::string head = text_of(test_head());
  expect_damage(head + text_of(claim_of(20, 4)) + text_of(claim_of(23, 1)), 10);
  expect_damage(head + text_of(claim_of(20, 4)) + text_of(claim_of(18, 3)), 10);
  expect_damage(text_of(claim_of(20, 4)), 1);
  expect_damage("", 1);
}

// Problems are collected, however a file is no journal.
TEST(Journal, IsAProblemWhereItsFileCannotHoldOne) {
  const data_test::TestFolder folder;
  data_test::put(folder / "large.journal", text_of(test_head()));
  std::filesystem::resize_file(folder / "large.journal", core::max_journal_bytes + 1);
  ASSERT_EQ(::mkfifo((folder / "pipe.journal").c_str(), 0600), 0);
  try {
    static_cast<void>(read_journals(folder.path()));
    FAIL() << "read";
  } catch (const core::InvalidRequest& unfit) {
    ASSERT_EQ(unfit.problems.size(), 2U);
    EXPECT_EQ(unfit.problems[0].message, "the file is too large for a journal");
    EXPECT_EQ(unfit.problems[1].found, "a pipe");
  }
}

TEST(Journal, NamesWhatDiffersAndTheScriptOnlyWhereNothingElseDoes) {
  const Identity one{{"seed", "1"}, {"script", "00"}};
  EXPECT_TRUE(differences(one, "now", one, "there").empty());
  EXPECT_THAT(differences({{"seed", "2"}, {"script", "11"}}, "now", one, "there"),
              ElementsAre("seed is 2 now, 1 there"));
  EXPECT_THAT(differences({{"seed", "1"}, {"script", "11"}}, "now", one, "there"),
              ElementsAre(HasSubstr("has changed")));
  EXPECT_THAT(differences({{"seed", "1"}, {"script", "00"}, {"engine", "direct"}}, "now", one, "there"),
              ElementsAre("engine is direct now, not said there"));
}

TEST(MissingRows, AreTheGapsBetweenAllEntries) {
  const std::vector<Journal> journals{journal_of("1/2", {0, 50}, {claim_of(10, 5), claim_of(30, 10)}),
                                      journal_of("2/2", {50, 50}, {claim_of(15, 5), claim_of(95, 5)})};
  EXPECT_THAT(missing_rows({0, 100}, journals), ElementsAre(RowRange{0, 10}, RowRange{20, 10}, RowRange{40, 55}));
  EXPECT_THAT(missing_rows({12, 20}, journals), ElementsAre(RowRange{20, 10}));
  EXPECT_TRUE(missing_rows({30, 10}, journals).empty());
  EXPECT_THAT(missing_rows({0, 3}, {}), ElementsAre(RowRange{0, 3}));
}

TEST(JoinProblems, NameOverlapsGapsAndOtherRuns) {
  const Journal first = journal_of("1/2", {0, 50}, {claim_of(0, 50)});
  EXPECT_TRUE(join_problems({first, journal_of("2/2", {50, 50}, {claim_of(50, 50)})}, 100).empty());
  const core::Problems overlap = join_problems({first, journal_of("41:100", {40, 60}, {claim_of(40, 60)})}, 100);
  ASSERT_EQ(overlap.size(), 1U);
  EXPECT_THAT(overlap[0].message, HasSubstr("pulses 41 to 50 are in part 1/2 and in part 41:100"));
  const core::Problems gap = join_problems({first, journal_of("2/2", {50, 50}, {claim_of(51, 49)})}, 100);
  ASSERT_EQ(gap.size(), 1U);
  EXPECT_THAT(gap[0].message, HasSubstr("pulse 51 of 100"));
  EXPECT_THAT(gap[0].hint, HasSubstr("part 2/2 has not finished"));
  const core::Problems other = join_problems({first, journal_of("2/2", {50, 50}, {}, {{"seed", "2"}})}, 100);
  ASSERT_EQ(other.size(), 1U);
  EXPECT_THAT(other[0].message, HasSubstr("seed is not said in part 1/2, 2 in part 2/2"));
}

}  // namespace journal_test
}  // namespace sarsim::raster
