#include "core/os/journal_file.hpp"

#include <gtest/gtest.h>

#include <system_error>

#include "core/report/retryable.hpp"
#include "support/test_folder.hpp"

namespace sarsim::core {
namespace journal_file_test {

using test::contents;
using test::put;
using test::TestFolder;

TEST(JournalSeal, IsPartOfTheFormat) {
  EXPECT_EQ(sealed_line(""), " #ef46db3751d8e999\n");
  EXPECT_EQ(sealed_line("abc"), "abc #44bc2cf5ad770999\n");
}

TEST(JournalSeal, ComesOffAgain) {
  for (const std::string content : {"", "rows 1 2", "a # b #44bc2cf5ad770999", "tab\t\xFF"}) {
    std::string line = sealed_line(content);
    line.pop_back();
    EXPECT_EQ(unsealed_line(line), content);
  }
}

TEST(JournalSeal, HoldsNoOtherText) {
  const std::string line = "rows 250 16 #" + sealed_line("rows 250 16").substr(13, 16);
  ASSERT_TRUE(unsealed_line(line));
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string other = line;
    other[i] = static_cast<char>(other[i] ^ 1);
    EXPECT_FALSE(unsealed_line(other)) << other;
    EXPECT_FALSE(unsealed_line(line.substr(0, i))) << i;
  }
}

TEST(JournalLines, LeaveOutALineWithoutItsEnd) {
  EXPECT_TRUE(lines_of_journal("").whole.empty());
  const JournalLines lines = lines_of_journal("a\n\nbc\nd");
  EXPECT_EQ(lines.whole, (std::vector<std::string_view>{"a", "", "bc"}));
  EXPECT_EQ(lines.cut_off, "d");
  EXPECT_EQ(lines_of_journal("a\n").cut_off, "");
}

TEST(JournalFile, ContinuesBehindTheWholeLines) {
  const TestFolder folder;
  put(folder / "j", "one\ntw");
  JournalFile journal(RawFile(folder / "j", RawFile::Mode::write));
  journal.cut(4);
  journal.add("two\n");
  journal.add("three\n");
  EXPECT_EQ(read_journal_file(folder / "j"), "one\ntwo\nthree\n");
}

TEST(JournalFile, BeginsWithItsHeading) {
  const TestFolder folder;
  for (const bool keep : {false, true}) {
    std::filesystem::remove(folder / "j");
    JournalFile::open(folder / "j", keep, "heading\n").add("one\n");
    EXPECT_EQ(contents(folder / "j"), "heading\none\n");
  }
  JournalFile::open(folder / "j", false, "heading\n").add("two\n");
  EXPECT_EQ(contents(folder / "j"), "heading\ntwo\n");
}

TEST(JournalFile, EndsALineThatWasCutOff) {
  const TestFolder folder;
  put(folder / "j", "heading\non");
  JournalFile::open(folder / "j", true, "heading\n").add("two\n");
  EXPECT_EQ(contents(folder / "j"), "heading\non\ntwo\n");
}

TEST(JournalFile, BelongsToWhoOpensItFirst) {
  const TestFolder folder;
  {
    JournalFile first = JournalFile::open(folder / "j", true, "heading\n");
    first.add("a\n");
    for (const bool keep : {true, false})
      EXPECT_THROW(static_cast<void>(JournalFile::open(folder / "j", keep, "heading\n")), RetryableError);
    first.add("b\n");
    EXPECT_EQ(contents(folder / "j"), "heading\na\nb\n");
  }
  JournalFile::open(folder / "j", true, "heading\n").add("c\n");
  EXPECT_EQ(contents(folder / "j"), "heading\na\nb\n\nc\n");
}

TEST(JournalFile, IsRefusedByItsSizeBeforeAnyMemoryIsTaken) {
  const TestFolder folder;
  put(folder / "j", "heading\n");
  std::filesystem::resize_file(folder / "j", std::uintmax_t{1} << 40U);
  try {
    static_cast<void>(read_journal_file(folder / "j"));
    FAIL() << "read";
  } catch (const InvalidRequest& refused) {
    const Problem& problem = refused.problems.at(0);
    EXPECT_EQ(problem.message, "the file is too large for a journal");
    EXPECT_EQ(problem.found, "1099511627776 bytes");
    EXPECT_EQ(problem.place.file, (folder / "j").string());
  }
}

TEST(JournalFile, NamesTheFileThatFails) {
  const TestFolder folder;
  const auto message_of = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const std::system_error& error) {
      return error.what();
    }
    return {};
  };
  const std::string path = folder / "none/j";
  EXPECT_EQ(message_of([&] { static_cast<void>(JournalFile::open(path, true, "")); }),
            "cannot write " + path + ": No such file or directory");
  EXPECT_EQ(message_of([&] { static_cast<void>(read_journal_file(path)); }),
            "cannot read " + path + ": No such file or directory");
}

}  // namespace journal_file_test
}  // namespace sarsim::core
