// `sarsim measure`: one target alone, pictures of its response.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace measure_test {

using testing::HasSubstr;
using testing::Not;

class Measure : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    ASSERT_EQ(sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--quiet"}).status, 0);
  }
};

TEST_F(Measure, TakesOneTargetAlone) {
  const Finished measure = sarsim({"measure", "sar_r.img", "--target", "5"});
  ASSERT_EQ(measure.status, 0) << measure.err;
  EXPECT_THAT(measure.out, HasSubstr("sar_r.img: 1 target by omega-k"));
  EXPECT_THAT(measure.out, HasSubstr("target 5 "));
  EXPECT_THAT(measure.out, Not(HasSubstr("target 4 ")));
  const Finished none = sarsim({"measure", "sar_r.img", "--target", "25"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("there is no target 25"));
  EXPECT_THAT(none.err, HasSubstr("the scene has 24"));
}

// With noise so strong that every peak near a target's place is noise.
TEST_F(Measure, SaysThatNoiseIsNoTargetAndEndsWithAStatus) {
  const Finished clear = sarsim({"measure", "sar_r.img"});
  EXPECT_THAT(clear.out, HasSubstr("24 of 24 targets found; position errors up to "));
  EXPECT_THAT(clear.out, HasSubstr("expected values in parentheses; signed values are measured minus expected"));
  EXPECT_THAT(clear.out, HasSubstr(": found; position error "));
  EXPECT_THAT(clear.out, HasSubstr(" m in azimuth, "));
  std::string script = text_of(SARSIM_SOURCE_DIR "/examples/sar_r.scr");
  const std::size_t noise = script.find("! (K) noise temperature");
  ASSERT_NE(noise, std::string::npos);
  script.replace(script.rfind("\n", noise) + 1, 1, "1E16");
  write_text(folder_ / "loud.scr", script);
  const Finished focus = sarsim({"focus", "loud.scr", "--quiet"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  const Finished measure = sarsim({"measure", "loud.img"});
  EXPECT_EQ(measure.status, 1) << measure.out;
  EXPECT_THAT(measure.out, HasSubstr("target 5    azimuth "));
  EXPECT_THAT(measure.out, HasSubstr(": not found within "));
  EXPECT_THAT(measure.out, HasSubstr("0 of 24 targets found"));
}

// A peak at the edge of the image is not that of a target beyond it.
TEST_F(Measure, LooksForNoTargetBesideTheImage) {
  const auto focused = [&](const std::string& from, const std::string& to) {
    const Finished focus = sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--azimuth", from, to, "--out",
                                   "part.img", "--force", "--quiet"});
    EXPECT_EQ(focus.status, 0) << focus.err;
    return sarsim({"measure", "part.img"});
  };
  const Finished some = focused("-10", "70");
  EXPECT_EQ(some.status, 0);
  EXPECT_THAT(some.out, HasSubstr(": outside the image\n"));
  EXPECT_THAT(some.out, HasSubstr(" outside the image)"));
  EXPECT_THAT(some.out, Not(HasSubstr("not found within")));
  const Finished none = focused("600", "640");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.out, HasSubstr("0 of 0 targets found (24 outside the image)"));
}

// Before and behind the window: there is nothing to be found, and nothing is missing.
TEST_F(Measure, SaysWhichTargetsTheRecordingNeverHolds) {
  std::string scene = text_of(SARSIM_SOURCE_DIR "/examples/sar_r.toml");
  scene += "\n[[target]]\nposition = [0, -1500, 0]\n[[target]]\nposition = [0, 1500, 0]\n";
  write_text(folder_ / "wide.toml", scene);
  const Finished focus = sarsim({"focus", "wide.toml", "--out", "wide.img"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  EXPECT_THAT(focus.err, HasSubstr("2 of 26 targets (25, 26) are never within the recorded ranges"));
  const Finished measure = sarsim({"measure", "wide.img"});
  EXPECT_EQ(measure.status, 0);
  for (const char* const target : {"\ntarget 25 ", "\ntarget 26 "}) {
    const std::size_t line = measure.out.find(target);
    ASSERT_NE(line, std::string::npos) << measure.out;
    const std::string said = measure.out.substr(line + 1, measure.out.find('\n', line + 1) - line - 1);
    EXPECT_THAT(said, testing::EndsWith(" m: outside the recorded ranges"));
    EXPECT_THAT(said, Not(HasSubstr("range 0.000 m")));
  }
  EXPECT_THAT(measure.out, HasSubstr("24 of 24 targets found (2 outside the image)"));
}

// Samples near the edge are right; between them only one side of a peak is known.
TEST_F(Measure, WarnsOfTargetsAtTheEdgeOfTheImage) {
  const std::string scene = text_of(SARSIM_SOURCE_DIR "/examples/sar_r.toml");
  const auto measured = [&](const std::string& nearest) {
    std::string text = scene;
    const std::size_t at = text.find("10010 m");
    EXPECT_NE(at, std::string::npos);
    text.replace(at, 7, nearest);
    write_text(folder_ / "edge.toml", text);
    EXPECT_EQ(sarsim({"focus", "edge.toml", "--out", "edge.img", "--force", "--quiet"}).status, 0);
    return sarsim({"measure", "edge.img"}).err;
  };
  // The nearest targets are at 10 km - 100 m over the ground: 10100 m.
  EXPECT_THAT(measured("10098.5 m"), HasSubstr("lie within 1.5 widths of the edge of the image"));
  EXPECT_THAT(measured("10080 m"), Not(HasSubstr("of the edge of the image")));
}

TEST_F(Measure, WritesATableAndFieldsForPrograms) {
  const Finished table = sarsim({"measure", "sar_r.img", "--csv"});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_THAT(table.out, testing::StartsWith("target,found,theory_azimuth_m,"));
  EXPECT_EQ(std::count(table.out.begin(), table.out.end(), '\n'), 25);
  const Finished json = sarsim({"measure", "sar_r.img", "--target", "5", "--json"});
  for (const char* key : {"\"snr_db\"", "\"noise_v\"", "\"threshold_db\"", "\"false_alarm\"", "\"found_targets\"",
                          "\"amplitude_error_db\"", "\"state\": \"found\"", "\"false_alarm_probability\"", "\"truth\""})
    EXPECT_THAT(json.out, HasSubstr(key));
  EXPECT_EQ(sarsim({"measure", "sar_r.img", "--csv", "--json"}).status, 2);
}

TEST_F(Measure, DrawsTheCutsThroughATarget) {
  const std::vector<std::string> words{"measure", "sar_r.img", "--target", "5", "--cuts", "pictures"};
  ASSERT_EQ(sarsim(words).status, 0);
  EXPECT_EQ(entries("pictures"), std::vector<std::string>{"target-5.png"});
  EXPECT_EQ(text_of(folder_ / "pictures/target-5.png").substr(1, 3), "PNG");
  const Finished again = sarsim(words);
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err, HasSubstr("exists"));
  EXPECT_EQ(again.out, "");  // Said before anything is measured.
}

TEST_F(Measure, FindsAWeakTargetBesideAStrongOne) {
  // 3.9 m farther than the first point, half as strong: nearer than three cells of 1.5 m.
  write_text(folder_ / "near.scr", text_of(SARSIM_SOURCE_DIR "/examples/sar_r.scr") +
                                       "\n$TARGET Earth\n-190, -96, 0\n0, 0, 0\n0.3, 0\nISOTROPIC\n");
  const Finished focus = sarsim({"focus", "near.scr", "--quiet"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  const Finished measure = sarsim({"measure", "near.img", "--target", "25"});
  ASSERT_EQ(measure.status, 0) << measure.err;
  const std::size_t found = measure.out.find(" m in range;");
  ASSERT_NE(found, std::string::npos) << measure.out;
  const std::size_t number = measure.out.rfind(' ', found - 1);
  EXPECT_LT(std::abs(std::stod(measure.out.substr(number))), 1.0) << measure.out;
}

TEST_F(Measure, KnowsTheWindowOfEachAxis) {
  const Finished focus = sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--quiet", "--json", "--force",
                                 "--range-window", "hann", "--azimuth-window", "taylor:35:5"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  EXPECT_THAT(focus.out, HasSubstr("\"range_window\": \"hann\""));
  EXPECT_THAT(focus.out, HasSubstr("\"azimuth_window\": \"taylor:35:5\""));
  const std::string header = text_of(folder_ / "sar_r.hdr");
  EXPECT_THAT(header, HasSubstr("range window = {hann}"));
  EXPECT_THAT(header, HasSubstr("azimuth window = {taylor:35:5}"));
}

}  // namespace measure_test
}  // namespace sarsim::test
