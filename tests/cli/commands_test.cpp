#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace commands_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Commands : public CommandTest {};

TEST_F(Commands, PlainCallShowsHelp) {
  const Finished help = sarsim({});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out, sarsim({"--help"}).out);
  EXPECT_THAT(help.out, HasSubstr("Examples:"));
}

TEST_F(Commands, EveryCommandHasHelpWithExamples) {
  for (const char* command : {"run", "check", "info", "geometry", "convert", "format", "completion"}) {
    const Finished help = sarsim({command, "--help"});
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_THAT(help.out, HasSubstr(std::string("Usage: sarsim ") + command));
    EXPECT_THAT(help.out, HasSubstr(std::string("\n  sarsim ") + command)) << "no example";
    EXPECT_EQ(help.err, "") << command;
  }
}

TEST_F(Commands, VersionSaysLicence) {
  const Finished version = sarsim({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, testing::MatchesRegex("sarsim [0-9]+\\.[0-9]+\\.[0-9]+\n(.|\n)*"));
  EXPECT_THAT(version.out, HasSubstr("GPL-3.0-or-later"));
}

TEST_F(Commands, MistypedWordsGetASuggestion) {
  const struct {
    std::vector<std::string> words;
    const char* suggestion;
  } cases[] = {{{"chekc", "x"}, "did you mean 'check'?"},
               {{"run", "x.scr", "--thread", "2"}, "did you mean '--threads'?"},
               {{"run", "x.scr", "--formt=csv"}, "did you mean '--format'?"},
               {{"run", "x.scr", "--format", "hdf"}, "did you mean 'hdf5'?"},
               {{"completion", "bsh"}, "did you mean 'bash'?"}};
  for (const auto& c : cases) {
    const Finished run = sarsim(c.words);
    EXPECT_EQ(run.status, 2) << c.words[0];
    EXPECT_THAT(run.err, HasSubstr(c.suggestion));
    EXPECT_EQ(run.out, "");
  }
}

TEST_F(Commands, BadArgumentsAreRefusedWithOneMessage) {
  write_scene({});
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"run"},
           {"run", "scene.scr", "--threads", "-1"},
           {"run", "scene.scr", "--threads", "2x"},
           {"run", "scene.scr", "--tolerance", "nan"},
           {"run", "scene.scr", "--seed", "1.5"},
           {"run", "scene.scr", "--out", "--force"},
           {"run", "scene.scr", "--profile", "modern"},
           {"run", "scene.scr", "9"},
           {"convert", "only-one"},
           {"geometry", "scene.scr"},
           {"geometry", "scene.scr", "--radar", "Radar1"},
           {"geometry", "scene.scr", "--radar", "Radar1", "--start", "2", "--end", "1"},
           {"geometry", "scene.scr", "--radar", "Rader1", "--start", "0", "--end", "1"},
           {"format", "scene.scr", "-o", "x", "--in-place"},
           {"completion"},
           {"info", "scene.scr", "extra"}}) {
    const Finished run = sarsim(words);
    EXPECT_EQ(run.status, 2) << words[0] << " " << words.back();
    EXPECT_EQ(run.out, "") << words[0];
    EXPECT_NE(run.err, "") << words[0];
  }
}

TEST_F(Commands, CheckPraisesASoundScript) {
  write_scene({});
  const Finished check = sarsim({"check", "scene.scr"});
  EXPECT_EQ(check.status, 0);
  EXPECT_THAT(check.out,
              testing::HasSubstr("simulation 1 (sim.bin): 1 of 1 targets in the window\n    strongest echo"));
  EXPECT_THAT(check.out, testing::HasSubstr("SNR "));
  EXPECT_THAT(check.out, testing::EndsWith("scene.scr: no problems\n"));
  EXPECT_EQ(check.err, "");
  EXPECT_THAT(sarsim({"info", "scene.scr"}).out, testing::HasSubstr("dB with all pulses)"));
}

TEST_F(Commands, ABeamThatMissesItsTargetsIsAWarningAndStrictRefusesIt) {
  std::string away = SceneText{}.text();
  ASSERT_NE(away.find("ISOTROPIC SAME"), std::string::npos) << away;
  away.replace(away.find("ISOTROPIC SAME"), 14, "SINX 5 5 SAME");
  ASSERT_NE(away.find("FIXED 0 0"), std::string::npos) << away;
  away.replace(away.find("FIXED 0 0"), 9, "FIXED 0 180");
  write_text(folder_ / "scene.scr", away);
  const Finished lenient = sarsim({"check", "scene.scr"});
  EXPECT_EQ(lenient.status, 0);
  EXPECT_THAT(lenient.out, testing::AnyOf(testing::HasSubstr("no echo is received"),
                                          testing::HasSubstr("the beam misses all targets")));
  EXPECT_EQ(sarsim({"check", "scene.scr", "--strict"}).status, 2);
  EXPECT_EQ(sarsim({"run", "scene.scr", "--strict"}).status, 2);
}

TEST_F(Commands, CheckCountsProblemsOfEveryScript) {
  SceneText outside;
  outside.target_m = 5000.0;
  write_scene(outside);
  std::string broken = SceneText{}.text();
  broken.replace(broken.find("CONSTANT 1000"), 13, "CONSTANT nonsense");
  write_text(folder_ / "broken.scr", broken);
  const Finished check = sarsim({"check", "scene.scr", "broken.scr"});
  EXPECT_EQ(check.status, 2);
  EXPECT_THAT(check.out, HasSubstr("scene.scr: 0 errors, 1 warning"));
  EXPECT_THAT(check.out, HasSubstr("broken.scr:6:"));
  EXPECT_THAT(check.out, HasSubstr("broken.scr: 1 error, 0 warnings"));
  EXPECT_EQ(sarsim({"check", "scene.scr"}).status, 0);
  EXPECT_EQ(sarsim({"check", "scene.scr", "--strict"}).status, 2);
}

TEST_F(Commands, CheckSaysWhatLaterCommandsWillSay) {
  const Finished check = sarsim({"check", SARSIM_SOURCE_DIR "/examples/search_radar.scr"});
  EXPECT_EQ(check.status, 0);
  EXPECT_THAT(check.out, HasSubstr("note: sarsim search: 1 of 2 targets exceed the unambiguous speed"));
  EXPECT_THAT(sarsim({"check", SARSIM_SOURCE_DIR "/examples/search_radar.scr", "--json"}).out,
              HasSubstr("sarsim search: 1 of 2 targets"));
}

TEST_F(Commands, CheckSpeaksJson) {
  SceneText scene;
  scene.target_m = 5000.0;
  write_scene(scene);
  const Finished check = sarsim({"check", "scene.scr", "--json"});
  EXPECT_EQ(check.status, 0);
  EXPECT_TRUE(is_json(check.out, folder_)) << check.out;
  EXPECT_THAT(check.out, HasSubstr("\"severity\": \"warning\""));
  EXPECT_THAT(check.out, HasSubstr("\"line\": 8"));
}

TEST_F(Commands, FormatIsStableAndKeepsTheMeaning) {
  write_scene({});
  const Finished once = sarsim({"format", "scene.scr"});
  EXPECT_EQ(once.status, 0);
  write_text(folder_ / "again.scr", once.out);
  EXPECT_EQ(sarsim({"format", "again.scr"}).out, once.out);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--out", "a"}).status, 0);
  ASSERT_EQ(sarsim({"run", "again.scr", "--out", "b"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "a" / "sim.bin"), text_of(folder_ / "b" / "sim.bin"));
}

TEST_F(Commands, FormatWritesFilesWithCare) {
  write_scene({});
  const std::string formatted = sarsim({"format", "scene.scr"}).out;
  EXPECT_EQ(sarsim({"format", "scene.scr", "-o", "new.scr"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "new.scr"), formatted);
  EXPECT_EQ(sarsim({"format", "scene.scr", "-o", "new.scr"}).status, 2);
  EXPECT_EQ(sarsim({"format", "scene.scr", "--in-place"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "scene.scr"), formatted);
}

TEST_F(Commands, FormatLeavesBrokenScriptsAlone) {
  const std::string broken = "$PLATFORM Earth SITTING\n";
  write_text(folder_ / "scene.scr", broken);
  EXPECT_EQ(sarsim({"format", "scene.scr", "--in-place"}).status, 2);
  EXPECT_EQ(text_of(folder_ / "scene.scr"), broken);
  EXPECT_EQ(sarsim({"format", "scene.scr"}).out, "");
}

TEST_F(Commands, InfoTellsTheFiguresOfAScript) {
  write_scene({});
  const Finished info = sarsim({"info", "scene.scr"});
  EXPECT_EQ(info.status, 0);
  // c/2B with 50 MHz; c/1 GHz; 1000 ns of 50 MHz.
  for (const char* text :
       {"2.99792 m", "299.792 mm", "time-bandwidth product   50", "Doppler band", "SNR", "20 (0 to 19)"})
    EXPECT_THAT(info.out, HasSubstr(text)) << info.out;
  const Finished json = sarsim({"info", "scene.scr", "--json"});
  EXPECT_TRUE(is_json(json.out, folder_)) << json.out;
  EXPECT_THAT(json.out, HasSubstr("\"columns\": 334"));
  EXPECT_THAT(json.out, HasSubstr("\"range_resolution_m\": 2.99792458"));
}

TEST_F(Commands, InfoTellsWhereAndWhenASceneIs) {
  const std::string world = "format = \"sarsim 2\"\n[world]\nepoch = \"2020-07-28T22:59:42Z\"\n";
  const std::string rest =
      "[[platform]]\nname = \"Aircraft\"\nposition = [0, 0, \"2 km\"]\n"
      "[[target]]\nposition = [0, 0, 0]\n"
      "[[radar]]\nname = \"Radar1\"\nplatform = \"Aircraft\"\n"
      "[[recording]]\nradar = \"Radar1\"\nrange = [\"1 km\", \"3 km\"]\ntime = [\"-1 s\", \"-0.9 s\"]\nsample_rate = "
      "\"20 MHz\"\n";
  const std::string place = "anchor = { latitude = \"-16.2 deg\", longitude = \"-76.2 deg\", height = \"100 m\" }\n";
  write_text(folder_ / "earth.toml", world + "frame = \"earth\"\n" + place + rest);
  const Finished info = sarsim({"info", "earth.toml"});
  EXPECT_EQ(info.status, 0) << info.err;
  for (const char* text :
       {"anchor                   -16.2000000 deg, -76.2000000 deg, 100.000 m, heading 0 deg",
        "epoch                    2020-07-28T22:59:42Z", "places at                -1 s (2020-07-28T22:59:41Z)",
        "  platform Aircraft      -16.2000000 deg, -76.2000000 deg, 2100.000 m",
        "  target 1               -16.2000000 deg, -76.2000000 deg, 100.000 m",
        "time                     -1 s (2020-07-28T22:59:41Z) to -0.9 s (2020-07-28T22:59:41.1Z)"})
    EXPECT_THAT(info.out, HasSubstr(text)) << info.out;
  const Finished json = sarsim({"info", "earth.toml", "--json"});
  EXPECT_TRUE(is_json(json.out, folder_)) << json.out;
  EXPECT_THAT(json.out, HasSubstr("\"first_utc\": \"2020-07-28T22:59:41Z\""));

  write_text(folder_ / "flat.toml", world + rest);
  const Finished flat = sarsim({"info", "flat.toml"});
  EXPECT_THAT(flat.out, HasSubstr("2020-07-28T22:59:42Z"));
  EXPECT_THAT(flat.out, Not(HasSubstr("anchor")));
  EXPECT_TRUE(is_json(sarsim({"info", "flat.toml", "--json"}).out, folder_));
}

TEST_F(Commands, InfoTellsTheShapeOfAFile) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5"}).status, 0);
  ASSERT_EQ(sarsim({"run", "scene.scr"}).status, 0);
  const Finished hdf5 = sarsim({"info", "sim.h5", "--json"});
  EXPECT_EQ(hdf5.status, 0);
  EXPECT_TRUE(is_json(hdf5.out, folder_)) << hdf5.out;
  EXPECT_THAT(hdf5.out, HasSubstr("\"rows\": 20"));
  EXPECT_THAT(hdf5.out, HasSubstr("\"profile\": \"physical\""));
  EXPECT_EQ(sarsim({"info", "sim.bin"}).status, 2);  // Does not describe itself.
  const Finished told = sarsim({"info", "sim.bin", "--columns", "334", "--bits", "8"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("rows                     20"));
  EXPECT_EQ(sarsim({"info", "sim.bin", "--script", "scene.scr"}).out, told.out);
  const Finished stranger = sarsim({"info", "scene.scr", "--script", "scene.scr"});
  EXPECT_EQ(stranger.status, 2);
  EXPECT_THAT(stranger.err, HasSubstr("--script means nothing"));
}

TEST_F(Commands, GeometryPrintsTablesOfTheScriptAndOthers) {
  SceneText scene;
  scene.geometry = "table.txt";
  write_scene(scene);
  const Finished table = sarsim({"geometry", "scene.scr"});
  EXPECT_EQ(table.status, 0);
  ASSERT_EQ(sarsim({"run", "scene.scr", "table.txt"}).status, 0);
  EXPECT_EQ(table.out, text_of(folder_ / "table.txt"));
  EXPECT_EQ(sarsim({"geometry", "scene.scr", "1"}).out, table.out);
  EXPECT_EQ(sarsim({"geometry", "scene.scr", "2"}).status, 2);
  const Finished other =
      sarsim({"geometry", "scene.scr", "--radar", "radar1", "--start", "-0.5", "--end", "-0.499", "--csv"});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_THAT(other.out, testing::StartsWith("pulse,time_s,carrier_hz,"));
  EXPECT_THAT(other.out, HasSubstr("\n-500,-0.5,1000000000,"));
  EXPECT_EQ(sarsim({"geometry", "scene.scr", "-o", "other.txt"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "other.txt"), table.out);
}

}  // namespace commands_test
}  // namespace sarsim::test
