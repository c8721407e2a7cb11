#include <gmock/gmock.h>

#include <fstream>

#include "program.hpp"

namespace sarsim::test {
namespace run_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class RunCommand : public CommandTest {};

TEST_F(RunCommand, MakesEverythingThatTheScriptAsksFor) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin"};
  scene.geometry = "table.txt";
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(entries("."), ElementsAre("one.bin", "scene.scr", "table.txt", "two.bin"));
  // 20 pulses of floor(2 * 0.1 GHz * 500 m/c + 1/2) = 334 samples, two bytes each.
  EXPECT_EQ(fs::file_size(folder_ / "one.bin"), 20U * 334U * 2U);
  EXPECT_THAT(run.err, HasSubstr("% of the converter's range"));
}

TEST_F(RunCommand, NeedsNoNameInFrontOfAScript) {
  write_scene({});
  EXPECT_EQ(sarsim({"scene.scr"}).status, 0);
  EXPECT_EQ(sarsim({"scene.scr", "--force", "--quiet"}).status, 0);
  EXPECT_EQ(sarsim({"--force", "scene.scr"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "sim.bin"));
}

TEST_F(RunCommand, ChoosesProductsByNumberAndName) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin", "three.bin"};
  scene.geometry = "table.txt";
  write_scene(scene);
  EXPECT_EQ(sarsim({"run", "scene.scr", "2", "table.txt"}).status, 0);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr", "table.txt", "two.bin"));
  const Finished wrong = sarsim({"run", "scene.scr", "tow.bin"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'two.bin'?"));
}

TEST_F(RunCommand, RefusesExistingFilesAndLeavesThemAlone) {
  SceneText scene;
  scene.files = {"first.bin", "there.bin"};
  write_scene(scene);
  write_text(folder_ / "there.bin", "precious");
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("--force"));
  EXPECT_EQ(text_of(folder_ / "there.bin"), "precious");
  EXPECT_FALSE(fs::exists(folder_ / "first.bin"));  // Nothing was begun.
  EXPECT_EQ(sarsim({"run", "scene.scr", "--force"}).status, 0);
  EXPECT_EQ(fs::file_size(folder_ / "there.bin"), fs::file_size(folder_ / "first.bin"));
}

TEST_F(RunCommand, MakesTheOutputFolder) {
  write_scene({});
  EXPECT_EQ(sarsim({"run", "scene.scr", "--out", "a/b"}).status, 0);
  EXPECT_THAT(entries("a/b"), ElementsAre("sim.bin"));
}

TEST_F(RunCommand, KeepsFoldersOfNamesOnlyWhenAsked) {
  SceneText scene;
  scene.files = {"sub\\sim.bin"};
  write_scene(scene);
  EXPECT_EQ(sarsim({"run", "scene.scr", "--out", "o"}).status, 0);
  EXPECT_THAT(entries("o"), ElementsAre("sim.bin"));
  EXPECT_EQ(sarsim({"run", "scene.scr", "--out", "p", "--keep-paths"}).status, 0);
  EXPECT_THAT(entries("p/sub"), ElementsAre("sim.bin"));
}

TEST_F(RunCommand, NumbersRepeatedNamesWithAWarning) {
  SceneText scene;
  scene.files = {"sim.bin", "sim.bin"};
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr", "--out", "o"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(entries("o"), ElementsAre("sim-2.bin", "sim.bin"));
  EXPECT_THAT(run.err, HasSubstr("sim-2.bin"));
  EXPECT_THAT(run.err, HasSubstr("warning"));
}

TEST_F(RunCommand, FormatChangesTheExtension) {
  write_scene({});
  for (const char* format : {"ascii", "binary", "bracket", "hdf5", "csv", "npy", "zarr", "sigmf"})
    EXPECT_EQ(sarsim({"run", "scene.scr", "--out", "o", "--format", format}).status, 0) << format;
  EXPECT_THAT(entries("o"), ElementsAre("sim.asc", "sim.bin", "sim.brk", "sim.csv", "sim.h5", "sim.npy",
                                        "sim.sigmf-data", "sim.sigmf-meta", "sim.zarr"));
}

TEST_F(RunCommand, PartsMakeNoFormatOfSeveralFiles) {
  write_scene({});
  const Finished run = sarsim({"run", "scene.scr", "--format", "sigmf", "--part", "1/2"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("sigmf, which is several files"));
  std::ofstream(folder_ / "sim.sigmf-data") << "theirs";
  const Finished taken = sarsim({"run", "scene.scr", "--format", "sigmf"});
  EXPECT_EQ(taken.status, 2);
  EXPECT_THAT(taken.err, HasSubstr("exists already"));
  EXPECT_EQ(text_of(folder_ / "sim.sigmf-data"), "theirs");
}

TEST_F(RunCommand, BytesDoNotDependOnThreads) {
  SceneText scene;
  scene.pulses = 700;
  scene.format = "ASCII";
  scene.files = {"sim.asc"};
  write_scene(scene);
  for (const char* threads : {"1", "2", "3", "8"}) {
    for (const char* format : {"ascii", "hdf5", "zarr"})
      ASSERT_EQ(sarsim({"run", "scene.scr", "--threads", threads, "--out", threads, "--format", format}).status, 0);
    EXPECT_EQ(text_of(folder_ / threads / "sim.asc"), text_of(folder_ / "1" / "sim.asc")) << threads;
    EXPECT_EQ(text_of(folder_ / threads / "sim.h5"), text_of(folder_ / "1" / "sim.h5")) << threads;
    EXPECT_EQ(text_of(folder_ / threads / "sim.zarr"), text_of(folder_ / "1" / "sim.zarr")) << threads;
  }
}

TEST_F(RunCommand, SeedChangesTheNoiseAndTheDefaultIsOne) {
  write_scene({});
  const auto bytes = [&](const std::vector<std::string>& options, const std::string& out) {
    std::vector<std::string> words{"run", "scene.scr", "--out", out};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(sarsim(words).status, 0);
    return text_of(folder_ / out / "sim.bin");
  };
  const std::string plain = bytes({}, "a");
  EXPECT_EQ(plain, bytes({"--seed", "1"}, "b"));
  EXPECT_NE(plain, bytes({"--seed", "2"}, "c"));
}

TEST_F(RunCommand, JsonIsAloneOnStandardOutput) {
  SceneText scene;
  scene.geometry = "table.txt";
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr", "--json", "--profile", "classic"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(is_json(run.out, folder_)) << run.out;
  for (const char* member :
       {"\"file\": \"sim.bin\"", "\"rows\": 20", "\"columns\": 334", "\"maximum_v\":", "\"lsb_v\":", "\"best_lsb_v\":",
        "\"range_used\":", "\"saturated\":", "\"zero\":", "\"seed\": 1", "\"profile\": \"classic\"",
        "\"engine\":", "\"tolerance\":", "\"warnings\": []", "\"status\": \"done\"", "\"kind\": \"geometry\""})
    EXPECT_THAT(run.out, HasSubstr(member));
}

TEST_F(RunCommand, JsonTellsBadInputToo) {
  write_text(folder_ / "scene.scr", "$SIMULATION Nobody 1 2 3\n");
  const Finished run = sarsim({"run", "scene.scr", "--json"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(is_json(run.out, folder_)) << run.out;
  EXPECT_THAT(run.out, HasSubstr("\"status\": \"bad input\""));
}

TEST_F(RunCommand, QuietSaysNothing) {
  SceneText scene;
  scene.target_m = 5000.0;  // Outside the window: a warning otherwise.
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr", "--quiet"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out, "");
}

TEST_F(RunCommand, StrictTurnsWarningsIntoRefusal) {
  SceneText scene;
  scene.target_m = 5000.0;
  write_scene(scene);
  const Finished strict = sarsim({"run", "scene.scr", "--strict"});
  EXPECT_EQ(strict.status, 2);
  EXPECT_THAT(strict.err, HasSubstr("warning"));
  EXPECT_FALSE(fs::exists(folder_ / "sim.bin"));
  const Finished lenient = sarsim({"run", "scene.scr"});
  EXPECT_EQ(lenient.status, 0);
  EXPECT_THAT(lenient.err, HasSubstr("warning"));
}

TEST_F(RunCommand, SoundScenesGiveNoWarning) {
  write_scene({});
  const Finished run = sarsim({"run", "scene.scr", "--strict"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("warning")));
}

TEST_F(RunCommand, TellsWhenSamplesWereClipped) {
  SceneText scene;
  scene.lsb_mv = "1e-12";
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("(as given)"));
  EXPECT_THAT(run.err, HasSubstr("would avoid clipping"));
}

TEST_F(RunCommand, DiscardComputesButWritesNothing) {
  SceneText scene;
  scene.geometry = "table.txt";
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr", "--discard", "--json"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
  EXPECT_THAT(run.out, HasSubstr("\"file\": null"));
  EXPECT_THAT(run.out, HasSubstr("\"rows\": 20"));
}

TEST_F(RunCommand, ProgressIsOneLinePerTenth) {
  SceneText scene;
  scene.pulses = 600000;  // Work of less than half a second is not told, on fast machines either.
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr", "--discard", "--threads", "1"});
  EXPECT_EQ(run.status, 0);
  for (int percent = 10; percent <= 100; percent += 10)
    EXPECT_THAT(run.err, HasSubstr("sim.bin: " + std::to_string(percent) + " %"));
  EXPECT_THAT(run.err, HasSubstr("samples/s"));
  EXPECT_THAT(run.err, Not(HasSubstr("\r")));
}

TEST_F(RunCommand, ScriptIsNeverReplacedByItsProduct) {
  SceneText scene;
  scene.files = {"scene.scr"};
  write_scene(scene);
  EXPECT_EQ(sarsim({"run", "scene.scr", "--force"}).status, 2);
  EXPECT_EQ(text_of(folder_ / "scene.scr"), scene.text());
}

TEST_F(RunCommand, ScenesWithoutProductsAreNothingToDo) {
  SceneText scene;
  scene.files = {};
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("$SIMULATION"));
}

TEST_F(RunCommand, ScriptsThatDescribeNothingAreRefused) {
  write_text(folder_ / "scene.scr", "$OPTIONS SEED 2\n");
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("defines nothing to compute"));
}

TEST_F(RunCommand, AllMistakesAreShownAtOnceWithTheirPlaces) {
  SceneText scene;
  std::string text = scene.text();
  text.replace(text.find("CONSTANT 1000"), 13, "CONSTANT -1");
  text.replace(text.find(" 8 0.1 "), 7, " 8 -0.1 ");
  write_text(folder_ / "scene.scr", text);
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("scene.scr:6:"));
  EXPECT_THAT(run.err, HasSubstr("scene.scr:8:"));
  EXPECT_EQ(run.out, "");
}

TEST_F(RunCommand, NamesTheLevelsOfSimdThatThereAre) {
  write_scene({});
  const Finished run = sarsim({"run", "scene.scr", "--simd", "sse9"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("--simd: this processor has no 'sse9'"));
  EXPECT_THAT(run.err, HasSubstr("choose among "));
}

}  // namespace run_test
}  // namespace sarsim::test
