#include "parts_support.hpp"

namespace sarsim::test {
namespace parts_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Parts : public PartsTest, public testing::WithParamInterface<std::pair<FormatCase, std::string>> {
 protected:
  [[nodiscard]] const FormatCase& format() const { return GetParam().first; }
  void write_scene() const { write_shaking_scene(61, GetParam().second); }

  [[nodiscard]] std::vector<std::string> into(const std::string& folder,
                                              const std::vector<std::string>& more = {}) const {
    return words(words({"--out", folder}, format().options), more);
  }
};

TEST_P(Parts, OfAnyNumberMakeTheFileOfASingleRun) {
  write_scene();
  const Finished whole = run(into("whole"));
  ASSERT_EQ(whole.status, 0) << whole.err;
  for (const int count : {2, 3, 7}) {
    const std::string folder = "parts-" + std::to_string(count);
    Finished last;
    for (int part = count; part >= 1; --part) {
      EXPECT_FALSE(fs::exists(folder_ / folder / format().file));
      last = run(into(folder, {"--part", std::to_string(part) + "/" + std::to_string(count)}));
      ASSERT_EQ(last.status, 0) << last.err;
    }
    expect_same_bytes("whole/" + format().file, folder + "/" + format().file);
    EXPECT_EQ(figures(last.err), figures(whole.err));
    EXPECT_THAT(entries(folder), ElementsAre(format().file, format().file + ".journal"));
  }
}

TEST_P(Parts, InFilesOfTheirOwnAreJoinedByMerge) {
  write_scene();
  const Finished whole = run(into("whole"));
  ASSERT_EQ(whole.status, 0) << whole.err;
  for (const char* part : {"2/3", "1/3", "3/3"}) {
    const Finished made = run(into(std::string("host") + part[0], {"--part", part, "--part-file"}));
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.err, HasSubstr("for sarsim merge"));
  }
  const std::string parts = "/" + format().file + ".parts";
  const Finished merged = sarsim({"merge", "host1" + parts, "host2" + parts, "host3" + parts, "-o", "joined"});
  ASSERT_EQ(merged.status, 0) << merged.err;
  expect_same_bytes("whole/" + format().file, "joined");
  EXPECT_EQ(figures(merged.err), figures(whole.err));
}

TEST_P(Parts, OneRunThatKeepsAJournalMakesTheSameFile) {
  write_scene();
  ASSERT_EQ(run(into("whole")).status, 0);
  const Finished kept = run(into("kept", {"--resume", "--save-every", "0", "--threads", "3"}));
  ASSERT_EQ(kept.status, 0) << kept.err;
  expect_same_bytes("whole/" + format().file, "kept/" + format().file);
}

std::vector<std::pair<FormatCase, std::string>> all_cases() {
  std::vector<std::pair<FormatCase, std::string>> cases;
  for (const FormatCase& format : format_cases())
    for (const char* lsb_mv : {"3e-5", "0"}) cases.emplace_back(format, lsb_mv);
  return cases;
}

std::string case_name(const testing::TestParamInfo<std::pair<FormatCase, std::string>>& one) {
  return one.param.first.name + (one.param.second == "0" ? "_lsb_estimated" : "_lsb_given");
}

INSTANTIATE_TEST_SUITE_P(Formats, Parts, testing::ValuesIn(all_cases()), case_name);

class PartsOfScenes : public PartsTest {};

TEST_F(PartsOfScenes, MayBeGivenAsPulses) {
  write_shaking_scene(40, "0");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  for (const char* pulses : {"11:30", ":10", "31:"})
    ASSERT_EQ(run({"--out", "parts", "--pulses", pulses}).status, 0) << pulses;
  expect_same_bytes("whole/sim.bin", "parts/sim.bin");
}

// Compressed pulses, and bursts of a stepped carrier: a row of these is made of several pulses.
TEST_F(PartsOfScenes, MayBeOfAnyProcessing) {
  for (const char* example : {"thesis_a3.scr", "stepped_srp.scr"}) {
    write_text(folder_ / "scene.scr", text_of(fs::path(SARSIM_SOURCE_DIR "/examples") / example));
    const std::string out = example;
    ASSERT_EQ(run({"--out", out + "-whole", "--quiet"}).status, 0) << example;
    for (const char* part : {"3/3", "1/3", "2/3"})
      ASSERT_EQ(run({"--out", out, "--part", part, "--quiet"}).status, 0) << example;
    std::size_t files = 0;
    for (const std::string& file : entries(out + "-whole")) {
      expect_same_bytes(out + "-whole/" + file, out + "/" + file);
      ++files;
    }
    EXPECT_GT(files, 0U);
  }
}

TEST_F(PartsOfScenes, MayBeMoreThanThereArePulses) {
  write_shaking_scene(3, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  for (int part = 1; part <= 5; ++part)
    ASSERT_EQ(run({"--out", "parts", "--part", std::to_string(part) + "/5"}).status, 0);
  expect_same_bytes("whole/sim.bin", "parts/sim.bin");
}

// A limit of 1024 open files is usual, and parts may be ten thousand; here it is 24 and 40.
TEST_F(PartsOfScenes, MayBeMoreThanAProcessMayHaveFiles) {
  write_shaking_scene(41, "0");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  for (int part = 1; part <= 40; ++part)
    ASSERT_EQ(run({"--out", "o", "--part", std::to_string(part) + "/40", "--part-file"}).status, 0);
  Start start;
  start.folder = folder_;
  start.max_open_files = 24;
  const Finished merged = Program({"merge", "o/sim.bin.parts", "--threads", "4"}, start).finish();
  ASSERT_EQ(merged.status, 0) << merged.err;
  expect_same_bytes("whole/sim.bin", "o/sim.bin");
}

TEST_F(PartsOfScenes, MakeEverySimulationAndTheFirstMakesTheTables) {
  SceneText scene;
  scene.files = {"one.bin", "two.asc"};
  scene.geometry = "table.txt";
  write_scene(scene);
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  ASSERT_EQ(run({"--out", "parts", "--part", "2/2"}).status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "parts/table.txt"));
  ASSERT_EQ(run({"--out", "parts", "--part", "1/2"}).status, 0);
  for (const char* file : {"one.bin", "two.asc", "table.txt"})
    expect_same_bytes(std::string("whole/") + file, std::string("parts/") + file);
}

TEST_F(PartsOfScenes, ReplaceAnExistingFileOnlyWhenAsked) {
  write_shaking_scene(20, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  write_text(folder_ / "sim.bin", "earlier");
  const Finished refused = run({"--part", "1/2"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(run({"--part", "1/2", "--force"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "sim.bin"), "earlier");
  EXPECT_EQ(run({"--part", "2/2", "--force"}).status, 0);
  expect_same_bytes("whole/sim.bin", "sim.bin");
}

TEST_F(PartsOfScenes, SayInJsonWhatTheyMade) {
  write_shaking_scene(20, "3e-5");
  const Finished first = run({"--part", "1/2", "--json"});
  EXPECT_TRUE(is_json(first.out, folder_)) << first.out;
  EXPECT_THAT(first.out, HasSubstr("\"rows_there\": 10"));
  EXPECT_THAT(first.out, HasSubstr("\"complete\": false"));
  EXPECT_THAT(first.out, Not(HasSubstr("\"recording\"")));
  const Finished last = run({"--part", "2/2", "--json"});
  EXPECT_TRUE(is_json(last.out, folder_)) << last.out;
  EXPECT_THAT(last.out, HasSubstr("\"complete\": true"));
  EXPECT_THAT(last.out, HasSubstr("\"recording\""));
}

TEST_F(PartsOfScenes, WithRowsAtTheirPlacesAreMergedWhereNobodyCompletedThem) {
  write_shaking_scene(20, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  ASSERT_EQ(run({"--out", "a", "--part", "1/2"}).status, 0);
  ASSERT_EQ(run({"--out", "b", "--part", "2/2"}).status, 0);
  const Finished merged = sarsim({"merge", "a/sim.bin.parts", "b/sim.bin.parts", "--remove"});
  ASSERT_EQ(merged.status, 0) << merged.err;
  expect_same_bytes("whole/sim.bin", "a/sim.bin");
  EXPECT_THAT(entries("a"), ElementsAre("sim.bin", "sim.bin.journal"));
  // A merge that is repeated has nothing to do; of a file that was changed since nothing is known.
  const std::vector<std::string> again{"merge", "a/sim.bin.parts", "b/sim.bin.parts", "--remove"};
  const Finished repeated = sarsim(again);
  EXPECT_EQ(repeated.status, 0) << repeated.err;
  EXPECT_THAT(repeated.err, HasSubstr("complete already, and its parts are gone"));
  EXPECT_EQ(sarsim({"merge", "a/sim.bin.parts", "-o", "other.bin", "--remove"}).status, 2);
  write_text(folder_ / "a/sim.bin", "other");
  EXPECT_EQ(sarsim(again).status, 2);
}

// As a process leaves them that is killed while it removes them.
TEST_F(PartsOfScenes, ThatAreMergedAndHalfRemovedGoWithoutAWord) {
  write_shaking_scene(20, "3e-5");
  for (const char* share : {"1/3", "2/3", "3/3"}) ASSERT_EQ(run({"--part", share, "--part-file"}).status, 0);
  ASSERT_EQ(sarsim({"merge", "sim.bin.parts"}).status, 0);
  const std::string whole = text_of(folder_ / "sim.bin");
  // Parts that another output has, too, are no leftovers.
  const fs::path copy = folder_ / "copy.parts";
  fs::copy(folder_ / "sim.bin.parts", copy, fs::copy_options::recursive);
  const std::vector<std::string> removed{"part-2-of-3.rows",
                                         "part-2-of-3.journal",
                                         "part-1-of-3.rows",
                                         "part-1-of-3.journal",
                                         "part-3-of-3.journal",
                                         "part-3-of-3.rows",
                                         "lock"};
  for (std::size_t count = 0; count <= removed.size(); ++count) {
    fs::remove_all(folder_ / "sim.bin.parts");
    fs::copy(copy, folder_ / "sim.bin.parts", fs::copy_options::recursive);
    for (std::size_t i = 0; i < count; ++i) fs::remove(folder_ / "sim.bin.parts" / removed[i]);
    const Finished again = sarsim({"merge", "sim.bin.parts", "--remove"});
    ASSERT_EQ(again.status, 0) << count << ": " << again.err;
    EXPECT_THAT(again.err, HasSubstr("20 x "));
    EXPECT_FALSE(fs::exists(folder_ / "sim.bin.parts")) << count;
  }
  EXPECT_EQ(text_of(folder_ / "sim.bin"), whole);
  // What the output has not is no leftover.
  write_text(folder_ / "sim.bin", "other");
  EXPECT_EQ(sarsim({"merge", "copy.parts", "-o", "sim.bin", "--remove"}).status, 2);
  EXPECT_TRUE(fs::exists(copy / "part-1-of-3.rows"));
}

}  // namespace parts_test
}  // namespace sarsim::test
