#include "cli/program/command_line.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sarsim::cli {
namespace command_line_test {

using testing::HasSubstr;

struct Answer {
  int status = -1;
  std::string out;
  std::string err;
};

Answer answer(std::vector<const char*> words, const core::StopFlag* stop = nullptr) {
  words.insert(words.begin(), "sarsim");
  std::ostringstream out;
  std::ostringstream err;
  Answer result;
  result.status = run_command_line(static_cast<int>(words.size()), words.data(), {out, err, false, stop});
  result.out = out.str();
  result.err = err.str();
  return result;
}

TEST(CommandLine, WithoutWordsShowsHelp) {
  const Answer a = answer({});
  EXPECT_EQ(a.status, 0);
  EXPECT_THAT(a.out, HasSubstr("Subcommands:"));
  EXPECT_EQ(a.err, "");
}

TEST(CommandLine, ShortHelpWorksEverywhere) {
  EXPECT_EQ(answer({"-h"}).out, answer({"--help"}).out);
  EXPECT_EQ(answer({"run", "-h"}).out, answer({"run", "--help"}).out);
}

TEST(CommandLine, ScriptInFrontMeansRun) {
  const Answer a = answer({"no/such.scr"});
  EXPECT_EQ(a.status, 2);
  EXPECT_THAT(a.err, HasSubstr("no/such.scr"));
  EXPECT_THAT(a.err, testing::Not(HasSubstr("unknown command")));
}

TEST(CommandLine, UnknownWordsAreBadInput) {
  EXPECT_THAT(answer({"fromat"}).err, HasSubstr("did you mean 'format'?"));
  EXPECT_THAT(answer({"--vresion"}).err, HasSubstr("did you mean '--version'?"));
  EXPECT_THAT(answer({"check", "a.scr", "--jsno"}).err, HasSubstr("did you mean '--json'?"));
  EXPECT_EQ(answer({"zzzzzzzz"}).status, 2);
}

TEST(CommandLine, StopEndsWithTheStatusOfAnInterrupt) {
  const std::string path = testing::TempDir() + "command_line_stop.scr";
  std::ofstream(path) << "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
                         "$TARGET Earth 0 1000 0 0 0 0 1 0 ISOTROPIC\n"
                         "$RADAR R Earth MONO 100 RECT CONSTANT 1000 SINGLE 1 1 0 0 ISOTROPIC SAME FIXED 0 0 RECT "
                         "NO_STC\n"
                         "$SIMULATION R 900 1100 0 0.1 8 0.1 0 BINARY RAW x.bin BEGIN 1 1\n";
  core::StopFlag stop;
  stop.request();
  const Answer a = answer({"run", path.c_str(), "--discard"}, &stop);
  EXPECT_EQ(a.status, 130);
  EXPECT_THAT(a.err, HasSubstr("interrupted"));
  const Answer done = answer({"run", path.c_str(), "--discard", "--json"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("\"rows\": 101"));
  std::filesystem::remove(path);
}

TEST(CommandLine, StreamThatFailsIsAFailure) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  const char* words[] = {"sarsim", "--version"};
  EXPECT_EQ(run_command_line(2, words, {out, err}), 1);
  EXPECT_THAT(err.str(), HasSubstr("standard output"));
}

}  // namespace command_line_test
}  // namespace sarsim::cli
