#include "workflow/sweep/sweep_journal.hpp"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <system_error>

#include <gtest/gtest.h>

#include "core/report/retryable.hpp"

namespace sarsim::workflow {
namespace sweep_journal_test {

namespace fs = std::filesystem;

SweepRow example(const std::string& file, std::uint64_t stamp = 0x123456789abcdef0U) {
  SweepRow row;
  row.file = file;
  row.stamp = stamp;
  row.done = true;
  row.bytes = 13360.0;
  row.seconds = 0.1;
  row.engine = "direct";
  row.lsb_estimated = true;
  row.run.rows = 20;
  row.run.columns = 334;
  row.run.maximum_v = 1.0 / 3.0;
  row.run.lsb_v = 1e-300;
  row.run.best_lsb_v = 4.9e-324;
  row.run.range_used = 0.97;
  row.run.saturated = 3;
  row.run.zero = 18446744073709551615U;
  row.followed = "focus-1a2b";
  row.figures = {{"target1_snr_db", 1.0 / 3.0}, {"target2_snr_db", std::nan("")}, {"found", 1.0}};
  return row;
}

class SweepJournals : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("sarsim-journals-" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST(SweepJournalLine, IsExact) {
  const SweepRow row = example("sim1_seed=1.bin");
  SweepRow back;
  ASSERT_TRUE(read_journal_line(journal_line(row), back));
  EXPECT_EQ(journal_line(back), journal_line(row));
  EXPECT_EQ(back.stamp, row.stamp);
  EXPECT_EQ(back.run.maximum_v, row.run.maximum_v);
  EXPECT_EQ(back.run.best_lsb_v, row.run.best_lsb_v);
  EXPECT_EQ(back.run.zero, row.run.zero);
  EXPECT_TRUE(back.done);
  EXPECT_FALSE(back.table);
  EXPECT_EQ(back.followed, "focus-1a2b");
  ASSERT_EQ(back.figures.size(), 3U);
  EXPECT_EQ(back.figures[0], row.figures[0]);
  EXPECT_EQ(back.figures[1].name, "target2_snr_db");
  EXPECT_TRUE(std::isnan(back.figures[1].value));
}

TEST(SweepJournalLine, HadNoFiguresOnce) {
  SweepRow row = example("sim1.bin");
  row.figures.clear();
  row.followed.clear();
  std::string line = journal_line(row);
  line.erase(line.rfind('\t'), 1);  // "...zero<tab><no figures><tab>." had a tab less.
  SweepRow back;
  ASSERT_TRUE(read_journal_line(line, back));
  EXPECT_EQ(back.run.zero, row.run.zero);
  EXPECT_TRUE(back.figures.empty());
}

TEST(SweepJournalLine, IsNoneWhereAnyOfItIsMissing) {
  const std::string line = journal_line(example("sim1.bin"));
  for (std::size_t length = 0; length < line.size(); ++length) {
    SweepRow row;
    EXPECT_FALSE(read_journal_line(line.substr(0, length), row)) << length;
  }
}

TEST_F(SweepJournals, OfAllPartsAreReadTogether) {
  SweepJournal(folder_ / "sweep-1-of-2.journal", false).add(example("a.bin"));
  SweepJournal(folder_ / "sweep-2-of-2.journal", false).add(example("b.bin"));
  SweepJournal(folder_ / "other.journal", false).add(example("c.bin"));
  const auto rows = read_journals(folder_, "sweep");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_TRUE(rows.contains("a.bin"));
  EXPECT_TRUE(rows.contains("b.bin"));
}

TEST_F(SweepJournals, GoOnBehindALineThatWasCutOff) {
  const fs::path path = folder_ / "sweep.journal";
  { SweepJournal(path, true).add(example("a.bin")); }
  std::ofstream(path, std::ios::app) << journal_line(example("cut.bin")).substr(0, 40);
  { SweepJournal(path, true).add(example("b.bin", 7)); }
  { SweepJournal(path, true).add(example("a.bin", 8)); }
  const auto rows = read_journals(folder_, "sweep");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows.at("b.bin").stamp, 7U);
  EXPECT_EQ(rows.at("a.bin").stamp, 8U);  // The later line counts.
}

TEST_F(SweepJournals, TakeALineWithAFileForMoreThanOneWithout) {
  SweepRow file = example("a.bin", 1);
  file.written = -4711;
  SweepRow back;
  ASSERT_TRUE(read_journal_line(journal_line(file), back));
  EXPECT_EQ(back.written, file.written);
  {
    SweepJournal journal(folder_ / "sweep.journal", false);
    journal.add(file);
    journal.add(example("a.bin", 1));
    journal.add(example("b.bin", 1));
  }
  auto rows = read_journals(folder_, "sweep");
  EXPECT_EQ(rows.at("a.bin").written, file.written);
  EXPECT_FALSE(rows.at("b.bin").written);
  { SweepJournal(folder_ / "sweep.journal", true).add(example("a.bin", 2)); }
  rows = read_journals(folder_, "sweep");
  EXPECT_FALSE(rows.at("a.bin").written);  // Of another scene: only the latest can fit.
}

TEST_F(SweepJournals, TellWhoMakesVariationsOfAPart) {
  const auto refusal_of = [this](SweepPart part) -> std::string {
    try {
      expect_nobody_at_work(folder_, "sweep", part);
    } catch (const core::RetryableError& refused) {
      return refused.problems.at(0).message;
    }
    return {};
  };
  EXPECT_EQ(refusal_of({}), "");
  {
    const SweepJournal other(folder_ / "other.journal", false);
    const SweepJournal second(folder_ / "sweep-2-of-4.journal", false);
    const std::string sentence = "part 2/4 of this sweep is being made by another process";
    EXPECT_EQ(refusal_of({}), sentence);
    EXPECT_EQ(refusal_of({1, 4}), sentence);
    EXPECT_EQ(refusal_of({1, 2}), sentence) << "2, 4, 6, ... has 6 as well";
    EXPECT_EQ(refusal_of({0, 3}), sentence) << "1, 4, 7, 10 has 10 as well";
    EXPECT_EQ(refusal_of({0, 4}), "");
    EXPECT_EQ(refusal_of({0, 2}), "");
    EXPECT_THROW(SweepJournal(folder_ / "sweep-2-of-4.journal", true), core::RetryableError);
  }
  EXPECT_EQ(refusal_of({1, 4}), "") << "the process has ended";
  const SweepJournal whole(folder_ / "sweep.journal", false);
  EXPECT_EQ(refusal_of({1, 4}), "this sweep is being made by another process");
}

TEST_F(SweepJournals, BeginAnewWhereNothingIsKept) {
  const fs::path path = folder_ / "sweep.journal";
  { SweepJournal(path, false).add(example("a.bin")); }
  { SweepJournal(path, false).add(example("b.bin")); }
  EXPECT_EQ(read_journals(folder_, "sweep").size(), 1U);
  EXPECT_THROW(SweepJournal(folder_ / "none" / "sweep.journal", false), std::system_error);
  EXPECT_TRUE(read_journals(folder_ / "none", "sweep").empty());
}

TEST_F(SweepJournals, AreKnownByTheirFirstLine) {
  const fs::path path = folder_ / "a.journal";
  EXPECT_TRUE(takes_journal_lines(path));
  { SweepJournal(path, false).add(example("one.bin")); }
  EXPECT_TRUE(takes_journal_lines(path));
  for (const char* foreign : {"KEEP\n", "sarsim sweep 2: stamp, fi", "\nsarsim sweep 2: stamp, file, end\n"}) {
    std::ofstream(path) << foreign;
    EXPECT_FALSE(takes_journal_lines(path)) << foreign;
  }
  std::ofstream(path).close();
  EXPECT_TRUE(takes_journal_lines(path));
  EXPECT_FALSE(takes_journal_lines(folder_));
}

TEST_F(SweepJournals, RememberWhatWasBegun) {
  SweepRow row;
  row.file = "a.bin";
  row.stamp = 7;
  {
    SweepJournal journal(folder_ / "sweep.journal", false);
    journal.add_begun(row);
  }
  auto rows = read_journals(folder_, "sweep");
  ASSERT_TRUE(rows.contains("a.bin"));
  EXPECT_TRUE(rows.at("a.bin").begun);
  EXPECT_FALSE(rows.at("a.bin").done);
  EXPECT_EQ(rows.at("a.bin").stamp, 7U);
  // What is done has its own line; begun anew, it may be there again.
  { SweepJournal(folder_ / "sweep.journal", true).add(example("a.bin", 7)); }
  rows = read_journals(folder_, "sweep");
  EXPECT_TRUE(rows.at("a.bin").done);
  EXPECT_FALSE(rows.at("a.bin").begun);
  { SweepJournal(folder_ / "sweep.journal", true).add_begun(row); }
  rows = read_journals(folder_, "sweep");
  EXPECT_TRUE(rows.at("a.bin").done);
  EXPECT_TRUE(rows.at("a.bin").begun);
}

}  // namespace sweep_journal_test
}  // namespace sarsim::workflow
