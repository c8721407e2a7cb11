#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace verify_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class VerifyCommand : public CommandTest {};

TEST_F(VerifyCommand, FindsThatEverythingHoldsHere) {
  const Finished verify = sarsim({"verify", "--quick"});
  EXPECT_EQ(verify.status, 0) << verify.out;
  EXPECT_EQ(verify.err, "");
  for (const char* group : {"Closed forms", "Geometry", "Light time", "Beams and targets", "Band-limited pulses",
                            "Numbers of the thesis", "Engines", "Statistics", "Focusing", "Detection and profiles"})
    EXPECT_THAT(verify.out, HasSubstr(group));
  EXPECT_THAT(verify.out, Not(HasSubstr("FAILED")));
  EXPECT_THAT(verify.out, HasSubstr("A.2: phase, classic"));
}

TEST_F(VerifyCommand, SaysOnlyTheCountWhereNothingIsWrongAndNothingElseIsWanted) {
  const Finished verify = sarsim({"verify", "--quick", "--quiet"});
  EXPECT_EQ(verify.status, 0);
  EXPECT_THAT(verify.out, testing::MatchesRegex("[0-9]+ of [0-9]+ comparisons agree\n"));
}

TEST_F(VerifyCommand, SaysTheSameAsJson) {
  const Finished verify = sarsim({"verify", "--quick", "--json"});
  EXPECT_EQ(verify.status, 0);
  EXPECT_TRUE(is_json(verify.out, folder_));
  EXPECT_THAT(verify.out, HasSubstr("\"holds\": true"));
  EXPECT_THAT(verify.out, Not(HasSubstr("\"holds\": false")));
}

TEST_F(VerifyCommand, OpensItsPageBeforeItMeasures) {
  const Finished nowhere = sarsim({"verify", "--html", "none/v.html"});
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_EQ(nowhere.out, "");
  Start start;
  start.folder = folder_;
  Program measuring({"verify", "--html", "v.html"}, start);
  std::vector<std::string> there;
  for (int i = 0; i < 1000 && there.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    there = entries(".");
  }
  measuring.send(SIGINT);
  EXPECT_EQ(measuring.finish().status, 130);
  ASSERT_EQ(there.size(), 1U);
  EXPECT_THAT(there.front(), HasSubstr(".partial-"));  // Not the page: that is made of what was measured.
  EXPECT_TRUE(entries(".").empty());
}

TEST_F(VerifyCommand, MakesAPageThatNeedsNothingElse) {
  ASSERT_EQ(sarsim({"verify", "--quick", "--html", "v.html"}).status, 0);
  const std::string page = text_of(folder_ / "v.html");
  EXPECT_THAT(page, HasSubstr("comparisons agree"));
  for (const char* outside : {"src=", "href=", "@import", "url("}) EXPECT_THAT(page, Not(HasSubstr(outside)));
  // Each chart is well-formed XML.
  write_text(folder_ / "charts.py",
             "import re, xml.etree.ElementTree as tree\n"
             "charts = re.findall('<svg.*?</svg>', open('v.html').read(), re.S)\n"
             "for chart in charts:\n"
             "    root = tree.fromstring(chart)\n"
             "    assert len(root.findall('polyline')) + len(root.findall('circle')) > 1\n"
             "    assert 'nan' not in chart and 'inf' not in chart\n"
             "assert len(charts) >= 3, len(charts)\n");
  const std::string command = "cd '" + folder_.string() + "' && '" + SARSIM_PYTHON + "' charts.py > said 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(folder_ / "said");
}

TEST_F(VerifyCommand, ReplacesAPageOnlyWhenAsked) {
  write_text(folder_ / "v.html", "precious");
  const Finished verify = sarsim({"verify", "--quick", "--html", "v.html"});
  EXPECT_EQ(verify.status, 2);
  EXPECT_THAT(verify.err, HasSubstr("--force"));
  EXPECT_EQ(text_of(folder_ / "v.html"), "precious");
  EXPECT_EQ(sarsim({"verify", "--quick", "--quiet", "--html", "v.html", "--force"}).status, 0);
  EXPECT_NE(text_of(folder_ / "v.html"), "precious");
}

}  // namespace verify_test
}  // namespace sarsim::test
