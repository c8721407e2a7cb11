#include <csignal>
#include <cstdlib>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace words_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// What the command line understands, and what comes of asking for nothing.
class Words : public CommandTest {
 protected:
  void expect_refusal(const std::vector<std::string>& words, const std::string& sentence) const {
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << sentence << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(sentence));
  }

  // Radar1 is sound; Radar2 rides on the target, whose echo would be infinite.
  void write_scene_with_an_impossible_second() const {
    SceneText scene;
    scene.geometry = "table.txt";
    std::string text = scene.text();
    text +=
        "$RADAR Radar2 Car CHIRP 0.05 1000 RECT CONSTANT 1000 SINGLE 1 100 0 0\n"
        "  ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n"
        "$SIMULATION Radar2 900 1400 0 0.019 8 0.1 0 BINARY RAW second.bin BEGIN 1 1\n";
    write_text(folder_ / "scene.scr", text);
  }
};

TEST_F(Words, SeedsGoAsFarAsThoseOfScripts) {
  write_scene({});
  const std::string largest = "18446744073709551615";
  EXPECT_EQ(sarsim({"run", "scene.scr", "--seed", largest, "--out", "a", "--quiet"}).status, 0);
  EXPECT_EQ(sarsim({"run", "scene.scr", "--set", "seed=" + largest, "--out", "b", "--quiet"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "a/sim.bin"), text_of(folder_ / "b/sim.bin"));
  for (const char* bad : {"18446744073709551616", "-1", "1.5", "", "+1", "1e3"})
    expect_refusal({"run", "scene.scr", "--seed", bad}, "is not a whole number from 0 to 18446744073709551615");
}

TEST_F(Words, HelpIsACommandToo) {
  EXPECT_EQ(sarsim({"help"}).out, sarsim({"--help"}).out);
  EXPECT_EQ(sarsim({"help", "run"}).out, sarsim({"run", "--help"}).out);
  expect_refusal({"help", "rum"}, "did you mean 'run'?");
}

TEST_F(Words, OutputsHaveOneNameInEveryCommand) {
  write_scene({});
  for (const char* command :
       {"run", "sweep", "geometry", "plot", "merge", "format", "focus", "doppler", "search", "profiles", "isar"})
    EXPECT_THAT(sarsim({command, "--help"}).out, HasSubstr("-o,--out")) << command;
  EXPECT_EQ(sarsim({"run", "scene.scr", "-o", "there", "--quiet"}).status, 0);
  EXPECT_THAT(entries("there"), ElementsAre("sim.bin"));
  EXPECT_EQ(sarsim({"format", "scene.scr", "--out", "same.scr"}).status, 0);
  expect_refusal({"sweep", "scene.scr", "--set", "seed=2", "--out", "sim.h5"},
                 "--out takes a folder, and 'sim.h5' is the name of a file");
}

TEST_F(Words, ScenesToBeginWithAreComplete) {
  std::istringstream purposes(sarsim({"new"}).out);
  int count = 0;
  for (std::string line; std::getline(purposes, line); ++count) {
    const std::string purpose = line.substr(0, line.find(' '));
    for (const std::string file : {"mine.toml", "mine.scr"}) {
      const Finished made = sarsim({"new", purpose, "-o", file, "--force"});
      if (purpose == "satellite" && file == "mine.scr") {  // The language of 1998 has no Earth.
        EXPECT_EQ(made.status, 2);
        EXPECT_THAT(made.err, HasSubstr(".toml"));
        continue;
      }
      ASSERT_EQ(made.status, 0) << purpose;
      const Finished check = sarsim({"check", file});
      EXPECT_EQ(check.status, 0) << purpose << check.out;
    }
  }
  EXPECT_EQ(count, 8);
  expect_refusal({"new", "sar-stripe"}, "did you mean 'sar-strip'?");
}

TEST_F(Words, ScenesToBeginWithAreTheExamplesInEitherLanguage) {
  ASSERT_EQ(sarsim({"new", "sar-strip"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "sar_r.toml"), text_of(SARSIM_SOURCE_DIR "/examples/sar_r.toml"));
  ASSERT_EQ(sarsim({"new", "sar-strip", "--language", "scr"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "sar_r.scr"), text_of(SARSIM_SOURCE_DIR "/examples/sar_r.scr"));
  expect_refusal({"new", "sar-strip"}, "the output exists already");
  ASSERT_EQ(sarsim({"new", "sar-strip", "-o", "odd.scene", "--language", "scr"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "odd.scene"), HasSubstr("$RADAR"));
  ASSERT_EQ(sarsim({"new", "sar-strip", "-o", "even.scene"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "even.scene"), HasSubstr("[[radar]]"));
  expect_refusal({"new", "sar-strip", "-o", "mine.toml", "--language", "scr"}, "end it with .scr");
  expect_refusal({"new", "sar-strip", "-o", "mine.scr", "--language", "toml"}, "end it with .toml");
  expect_refusal({"new", "sar-strip", "--language", "2"}, "--language");
}

TEST_F(Words, ScenesToBeginWithGiveTheirNameToTheirFiles) {
  for (const std::string ending : {".toml", ".scr"}) {
    ASSERT_EQ(sarsim({"new", "sar-strip", "-o", "mine" + ending}).status, 0);
    const std::string strip = text_of(folder_ / ("mine" + ending));
    EXPECT_THAT(strip, AllOf(HasSubstr("mine.h5"), HasSubstr("sarsim focus mine" + ending)));
    EXPECT_THAT(strip, HasSubstr("sar_r_1998.scr"));  // Another example.
    ASSERT_EQ(sarsim({"new", "spotlight", "-o", "mine" + ending, "--force"}).status, 0);
    const std::string spotlight = text_of(folder_ / ("mine" + ending));
    EXPECT_THAT(spotlight, AllOf(HasSubstr("mine.h5"), HasSubstr("mine_strip.h5")));
    EXPECT_THAT(spotlight, HasSubstr("An X-band radar in spotlight: "));  // No file.
  }
  ASSERT_EQ(sarsim({"new", "tutorial", "-o", R"(a"b\c.toml)"}).status, 0);
  EXPECT_THAT(text_of(folder_ / R"(a"b\c.toml)"), HasSubstr(R"(file = "a\"b\\c_raw.npy")"));
  EXPECT_EQ(sarsim({"check", R"(a"b\c.toml)"}).status, 0);
}

TEST_F(Words, IntervalsAreTwoWordsOrOneInEveryCommand) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/sar_r.scr";
  ASSERT_EQ(sarsim({"focus", scene, "--azimuth", "-20:20", "--range", "10150:10250", "--out", "a.img"}).status, 0);
  ASSERT_EQ(sarsim({"focus", scene, "--azimuth", "-20", "20", "--range", "10150", "10250", "--out", "b.img"}).status,
            0);
  EXPECT_EQ(text_of(folder_ / "a.img"), text_of(folder_ / "b.img"));
  ASSERT_EQ(sarsim({"plot", "a.img", "--range", "10180", "10220", "--kind", "pulse", "--csv", "a.csv"}).status, 0);
  ASSERT_EQ(sarsim({"plot", "a.img", "--range", "10180:10220", "--kind", "pulse", "--csv", "b.csv"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "a.csv"), text_of(folder_ / "b.csv"));
  expect_refusal({"focus", scene, "--azimuth", "20", "--out", "c.img"}, "--azimuth: '20' is not an interval");
}

TEST_F(Words, FieldsAreSetWhereverAScriptIsRead) {
  SceneText scene;
  scene.geometry = "table.txt";
  write_scene(scene);
  const auto set = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--set", "Target1.x=700"});
    const Finished done = sarsim(words);
    EXPECT_EQ(done.status, 0) << words[0] << ": " << done.err;
    return done;
  };
  const Finished elsewhere = set({"geometry", "scene.scr"});
  EXPECT_NE(elsewhere.out, sarsim({"geometry", "scene.scr"}).out);
  set({"check", "scene.scr"});
  set({"plot", "scene.scr", "-o", "p.png"});
  expect_refusal({"check", "scene.scr", "--set", "Target9.x=1"}, "Target9");
  expect_refusal({"profiles", "scene.scr", "--set", "scans"}, "--group scans");
}

TEST_F(Words, GeometryOfARecordingIsThatOfItsPulses) {
  SceneText scene;
  scene.pulses = 20;
  write_scene(scene);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  const std::string whole = sarsim({"geometry", "sim.h5", "--csv"}).out;
  EXPECT_EQ(lines(whole), 21);
  EXPECT_THAT(whole, HasSubstr("target 1 distance_m"));
  const std::string track = sarsim({"geometry", "sim.h5", "--csv", "--no-targets"}).out;
  EXPECT_EQ(lines(track), 21);
  EXPECT_THAT(track, testing::Not(HasSubstr("target")));
  EXPECT_THAT(track, HasSubstr("vx_mps"));
  expect_refusal({"geometry", "sim.h5", "--set", "seed=3"}, "--set means nothing for 'sim.h5', which was recorded");
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  EXPECT_EQ(sarsim({"geometry", "sim.bin", "--script", "scene.scr", "--csv"}).out, whole);
}

TEST_F(Words, ProductsThatAreNotChosenAreNotLookedAt) {
  write_scene_with_an_impossible_second();
  expect_refusal({"run", "scene.scr"}, "is at the position of radar 'Radar2'");
  expect_refusal({"run", "scene.scr", "2"}, "is at the position of radar 'Radar2'");
  const Finished first = sarsim({"run", "scene.scr", "1"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(sarsim({"run", "scene.scr", "table.txt"}).status, 0);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr", "sim.bin", "table.txt"));
}

TEST_F(Words, WarningsOfAChosenProductNameItsOwnPlace) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin"};
  scene.target_m = 5000.0;  // Outside both windows.
  write_scene(scene);
  const Finished second = sarsim({"run", "scene.scr", "2"});
  EXPECT_EQ(second.status, 0);
  EXPECT_THAT(second.err, AllOf(HasSubstr("scene.scr:9:"), Not(HasSubstr("scene.scr:8:"))));
}

TEST_F(Words, PulsesThatNoRecordingHasAreRefused) {
  write_scene({});
  expect_refusal({"run", "scene.scr", "--pulses", "21:"},
                 "no recording has as many pulses as --pulses asks for; found '21:', expected pulses 1 to 20");
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
  const Finished cut = sarsim({"run", "scene.scr", "--pulses", "15:30"});
  EXPECT_EQ(cut.status, 0) << cut.err;
  EXPECT_THAT(cut.err, HasSubstr("warning: 'sim.bin' has fewer pulses than --pulses asks for; found '15:30', expected "
                                 "pulses 1 to 20"));
  const Finished whole = sarsim({"run", "scene.scr", "--pulses", "1:14"});
  EXPECT_THAT(whole.err, Not(HasSubstr("warning")));
}

TEST_F(Words, TablesWithoutAPulseAreRefused) {
  write_scene({});
  expect_refusal({"geometry", "scene.scr", "--radar", "Radar1", "--start", "0.0001", "--end", "0.0002"},
                 "no pulse is sent within the azimuth window");
  EXPECT_EQ(sarsim({"geometry", "scene.scr", "--radar", "Radar1", "--start", "0.0001", "--end", "0.001"}).status, 0);
}

TEST_F(Words, ProfilesOfRangesThatWereNotRecordedAreRefused) {
  const std::string scene = SARSIM_SOURCE_DIR "/examples/stepped_aircraft.scr";
  expect_refusal({"profiles", scene, "--from", "1e6", "--to", "1001000"}, "nothing was recorded from 1000000 m");
  EXPECT_TRUE(entries(".").empty());
  const Finished beyond = sarsim({"profiles", scene, "--from", "12000", "--to", "13000"});
  EXPECT_EQ(beyond.status, 0);
  EXPECT_THAT(beyond.err, HasSubstr("the ranges go beyond those that were recorded"));
}

TEST_F(Words, FieldsThatAreNotThereLeadToTheCommandThatListsThem) {
  write_scene({});
  for (const char* command : {"run", "info"})
    for (const char* setting : {"Radar1.qqqqqqqqqq=1", "Qqqqqqqqqq.prf=1"})
      expect_refusal({command, "scene.scr", "--set", setting}, "'sarsim sweep SCENE --fields' lists what there is");
}

// A million points of a surface, looked at for each of many recordings after the warnings are told.
TEST_F(Words, InfoIsInterruptedWhileItLooksAtEchoes) {
  std::string text =
      "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
      "$PLATFORM Mast STATIONARY 0 0 1000 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
      "$SURFACE Earth -1000 5000 0 1000 5000 0 -1000 6000 0\n"
      "$RADAR Radar1 Mast CHIRP 0.05 1000 RECT CONSTANT 1000 SINGLE 1 100 0 0\n"
      "  ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n";
  for (int i = 0; i < 300; ++i)
    text += "$SIMULATION Radar1 5000 5500 0 0.019 8 0.02 0 BINARY RAW sim" + std::to_string(i) + ".bin BEGIN 1 1\n";
  write_text(folder_ / "scene.scr", text);
  Start start;
  start.folder = folder_;
  Program program({"info", "scene.scr"}, start);
  ASSERT_TRUE(program.wait_for("below the bandwidth", 60.0)) << program.err();
  program.send(SIGINT);
  const Finished end = program.finish();
  EXPECT_EQ(end.status, 130) << end.err;
  EXPECT_EQ(end.out, "");
}

TEST_F(Words, BashCompletesFilesAndChoicesOfEveryKindOfValue) {
  write_text(folder_ / "my scene.scr", "");
  write_text(folder_ / "out.svg", "");
  write_text(
      folder_ / "complete.sh",
      "eval \"$('" SARSIM_PROGRAM
      "' completion bash)\"\n"
      "try() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _sarsim; echo \"${#COMPREPLY[@]}: ${COMPREPLY[*]}\"; }\n"
      "try sarsim plot my\ntry sarsim my\ntry sarsim plot 'my\\ s'\ntry sarsim plot '\"my s'\n"
      "try sarsim plot -o o\ntry sarsim doppler --detections o\ntry sarsim focus --autofocus-phase o\n"
      "try sarsim profiles --velocity e\ntry sarsim focus --doppler-centroid m\ntry sarsim plot --rate o\n");
  const std::string command = "cd '" + folder_.string() + "' && bash complete.sh > answers 2> errors";
  ASSERT_EQ(std::system(command.c_str()), 0) << text_of(folder_ / "errors");
  EXPECT_EQ(text_of(folder_ / "errors"), "");
  EXPECT_EQ(text_of(folder_ / "answers"),
            "1: my scene.scr\n1: my scene.scr\n1: my scene.scr\n1: my scene.scr\n1: out.svg\n1: out.svg\n1: out.svg\n"
            "1: estimated\n1: measured\n0: \n");
}

TEST_F(Words, InfoRefusesOptionsThatItWouldIgnoreAllAtOnce) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  const Finished script = sarsim(
      {"info", "scene.scr", "--script", "nope.scr", "--columns", "3", "--bits", "8", "--lsb", "4", "--from", "csv"});
  EXPECT_EQ(script.status, 2);
  for (const char* option : {"--script", "--columns", "--bits", "--lsb", "--from"})
    EXPECT_THAT(script.err, HasSubstr(option + std::string(" means nothing for 'scene.scr', which is a script")));
  const Finished file = sarsim({"info", "sim.h5", "--set", "Radar1.prf=3", "--seed", "3", "--profile", "classic",
                                "--pulse", "ideal", "--tolerance", "1e-3", "--all"});
  EXPECT_EQ(file.status, 2);
  for (const char* option : {"--set", "--seed", "--profile", "--pulse", "--tolerance", "--all"})
    EXPECT_THAT(file.err, HasSubstr(option + std::string(" means nothing for 'sim.h5', which is not a script")));
  expect_refusal({"info", "scene.scr", "--plan", "--columns", "3"}, "--columns means nothing");
  expect_refusal({"info", "scene.scr", "--plan", "--all"}, "--all means nothing with --plan");
  EXPECT_EQ(sarsim({"info", "scene.scr", "--seed", "3", "--all"}).status, 0);
  EXPECT_EQ(sarsim({"info", "sim.h5", "--from", "hdf5"}).status, 0);
}

TEST_F(Words, EveryRefusalIsJsonWhereJsonIsAskedFor) {
  write_scene({});
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"info", "no.h5", "--json"},
                                             {"info", "no.scr", "--json"},
                                             {"focus", "no.h5", "--json"},
                                             {"doppler", "scene.scr", "--json", "--window", "no such"},
                                             {"measure", "no.img", "--json"},
                                             {"merge", "no.parts", "--json"},
                                             {"run", "scene.scr", "--json", "--bogus"},
                                             {"check", "--json"},
                                             {"sweep", "scene.scr", "--json", "--set", "nothing=1"}}) {
    const Finished end = sarsim(words);
    EXPECT_EQ(end.status, 2) << words[0];
    EXPECT_TRUE(is_json(end.out, folder_)) << words[0] << end.out;
    EXPECT_THAT(end.out, AllOf(HasSubstr("\"status\": \"bad input\""), HasSubstr("\"message\": "))) << words[0];
    EXPECT_NE(end.err, "") << words[0];
  }
  EXPECT_EQ(sarsim({"info", "no.h5"}).out, "");
}

TEST_F(Words, FailuresAreJsonWhereJsonIsAskedFor) {
  write_scene({});
  write_text(folder_ / "file", "");
  const Finished end = sarsim({"doppler", "scene.scr", "--json", "--out", "file/below/x.img", "--quiet"});
  EXPECT_EQ(end.status, 1) << end.err;
  EXPECT_TRUE(is_json(end.out, folder_)) << end.out;
  EXPECT_THAT(end.out, AllOf(HasSubstr("\"status\": \"failed\""), HasSubstr("file/below")));
}

TEST_F(Words, NothingIsAnOptionBehindTwoDashes) {
  write_text(folder_ / "-x.scr", SceneText{}.text());
  EXPECT_EQ(sarsim({"check", "--", "-x.scr"}).status, 0);
  EXPECT_EQ(sarsim({"run", "--quiet", "--", "-x.scr"}).status, 0);
  EXPECT_THAT(entries("."), ElementsAre("-x.scr", "sim.bin"));
  expect_refusal({"run", "--", "-x.scr", "--quiet"}, "the scene has no product '--quiet'");
}

TEST_F(Words, OnlyNearWordsAreSuggested) {
  const auto suggestion = [&](const std::string& option) {
    const Finished end = sarsim({"doppler", "x.scr", option});
    EXPECT_EQ(end.status, 2);
    return end.err;
  };
  EXPECT_THAT(suggestion("--bogus"), Not(HasSubstr("did you mean")));
  EXPECT_THAT(suggestion("--seed"), Not(HasSubstr("did you mean")));
  EXPECT_THAT(suggestion("--quite"), HasSubstr("did you mean '--quiet'?"));
  EXPECT_THAT(suggestion("--jsno"), HasSubstr("did you mean '--json'?"));
}

TEST_F(Words, ValuesOfAScriptGiveWayInEveryCommandThatSimulates) {
  write_scene({});
  for (const char* command : {"doppler", "search"}) {
    ASSERT_EQ(
        sarsim({command, "scene.scr", "--seed", "3", "--set", "Target1.x=900", "--quiet", "--out", "b.img", "--no-map"})
            .status,
        0)
        << command;
    expect_refusal({command, "scene.scr", "--set", "Target9.x=1", "--no-map", "--out", "c.img"}, "Target9");
    std::filesystem::remove(folder_ / "b-detections.csv");
  }
  ASSERT_EQ(sarsim({"doppler", "scene.scr", "--seed", "3", "--pulse=ideal", "--quiet", "--out", "a.img"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "a.hdr"), HasSubstr("settings = {--pulse ideal --seed 3}"));
  expect_refusal({"merge", "x.parts", "--seed", "3"}, "see sarsim merge --help");
}

TEST_F(Words, NumbersWithoutUnitsAreWarnedOfWhereTheUnitOfTheScriptWasMeant) {
  write_scene({});
  const auto warned = [&](const std::string& setting) {
    const Finished check = sarsim({"check", "scene.scr", "--set", setting});
    return check.err + check.out;
  };
  EXPECT_THAT(warned("Radar1.power=200"), HasSubstr("a number without a unit counts in W; found '200 W', expected"));
  for (const char* setting : {"Radar1.power=20000", "Radar1.power=200W", "Radar1.prf=2", "Target1.x=40"})
    EXPECT_THAT(warned(setting), Not(HasSubstr("without a unit"))) << setting;
}

TEST_F(Words, PicturesAreRefusedWhereSamplesAreWritten) {
  write_scene({});
  for (const char* command : {"focus", "doppler", "search", "profiles", "isar"})
    expect_refusal({command, "scene.scr", "--out", "a.png"}, "is the name of a picture");
}

TEST_F(Words, TargetsComeFromTablesInEveryCommand) {
  write_scene({});
  write_text(folder_ / "points.csv", "x,y,z,rcs\n1100,0,0,2\n1200,0,5,3\n");
  const Finished check = sarsim({"check", "scene.scr", "--targets", "points.csv", "--targets", "Earth=points.csv"});
  EXPECT_THAT(check.out + check.err, HasSubstr("of 5 targets in the window"));
  ASSERT_EQ(sarsim({"format", "scene.scr", "--targets", "Earth=points.csv", "--set", "Target2.rcs=7", "-o", "more.scr"})
                .status,
            0);
  EXPECT_THAT(text_of(folder_ / "more.scr"), testing::ContainsRegex("TARGET +Earth"));
  ASSERT_EQ(sarsim({"run", "more.scr", "--out", "a", "--quiet"}).status, 0);
  ASSERT_EQ(
      sarsim({"run", "scene.scr", "--targets", "Earth=points.csv", "--set", "Target2.rcs=7", "--out", "b", "--quiet"})
          .status,
      0);
  EXPECT_EQ(text_of(folder_ / "a/sim.bin"), text_of(folder_ / "b/sim.bin"));
  ASSERT_EQ(sarsim({"run", "scene.scr", "--out", "c", "--quiet"}).status, 0);
  EXPECT_NE(text_of(folder_ / "c/sim.bin"), text_of(folder_ / "b/sim.bin"));
  expect_refusal({"run", "scene.scr", "--targets", "none.csv"}, "none.csv");
  write_text(folder_ / "bad.csv", "x,y,z\n1,2,3\n4,five,6\n");
  expect_refusal({"check", "scene.scr", "--targets", "bad.csv"}, "bad.csv:3");
  write_text(folder_ / "empty.csv", "x,y,z\n");
  expect_refusal({"check", "scene.scr", "--targets", "empty.csv"}, "the table holds no targets");
  expect_refusal({"run", "scene.scr", "--targets", "points.csv", "--set", "Simulation1.file=points.csv", "--force"},
                 "points.csv");
  EXPECT_THAT(text_of(folder_ / "points.csv"), testing::StartsWith("x,y,z,rcs"));
  const Finished sweep =
      sarsim({"sweep", "scene.scr", "--targets", "points.csv", "--set", "Target3.rcs=1,2", "--out", "s"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
}

TEST_F(Words, TablesOfTargetsNameAPlatformThatThereIs) {
  write_scene({});
  write_text(folder_ / "points.csv", "0,0,0,1\n");
  const Finished done = sarsim({"check", "scene.scr", "--targets", "Crane=points.csv"});
  EXPECT_EQ(done.status, 2);
  EXPECT_THAT(done.err, HasSubstr("the name before '=' is that of a platform: Earth"));
}

TEST_F(Words, OneOfAKindIsSingular) {
  write_scene({});
  const Finished map = sarsim({"doppler", "scene.scr"});
  ASSERT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.err, AllOf(HasSubstr(": 1 interval of 20 pulses"), Not(HasSubstr(" 1 intervals"))));
  EXPECT_THAT(map.err, Not(HasSubstr(" -0.0 ")));
}

TEST_F(Words, EmptyNamesAreCalledSo) {
  write_scene({});
  expect_refusal({"run", "scene.scr", "--out", ""}, "--out: the name is empty");
}

TEST_F(Words, AScriptWithoutASimulationIsNamed) {
  SceneText scene;
  scene.files = {};
  write_scene(scene);
  for (const char* command : {"doppler", "search", "focus"})
    expect_refusal({command, "scene.scr"}, "scene.scr: error: the scene defines no recording");
}

TEST_F(Words, ADiscardedRecordingHasNoSize) {
  write_scene({});
  const Finished run = sarsim({"run", "scene.scr", "--discard", "--json", "--format", "ascii"});
  EXPECT_THAT(run.out, HasSubstr("\"bytes\": null"));
  EXPECT_THAT(run.err, HasSubstr("nothing written: 20 x 334 samples, "));
  EXPECT_THAT(run.err.substr(run.err.find("nothing written")), Not(HasSubstr("kB")));
  EXPECT_THAT(sarsim({"run", "scene.scr", "--json"}).out, HasSubstr("\"bytes\": 13360"));
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1,2", "--discard", "--json", "--out", "s"});
  EXPECT_THAT(sweep.out, AllOf(HasSubstr("\"bytes\": null"), Not(HasSubstr("\"bytes\": 0"))));
  EXPECT_THAT(text_of(folder_ / "s/sweep.csv"), HasSubstr(",done,20,334,,"));
}

}  // namespace words_test
}  // namespace sarsim::test
