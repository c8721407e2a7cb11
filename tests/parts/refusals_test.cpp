#include <sys/stat.h>

#include <array>
#include <csignal>
#include <cstdio>

#include "core/hash/checksum.hpp"
#include "parts_support.hpp"

namespace sarsim::test {
namespace refusals_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// What does not belong together is refused with a sentence, exit status 2, and nothing changes.
class PartRefusals : public PartsTest {
 protected:
  void SetUp() override {
    PartsTest::SetUp();
    write_shaking_scene(40, "3e-5");
  }

  static void expect_refusal(const Finished& finished, const std::string& sentence, int status = 2) {
    EXPECT_EQ(finished.status, status) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr(sentence));
  }

  [[nodiscard]] fs::path journal(const std::string& part) const {
    return folder_ / "sim.bin.parts" / (part + ".journal");
  }

  void change(const fs::path& file, const std::string& what, const std::string& into) const {
    std::string text = text_of(file);
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << text;
    write_text(file, text.replace(at, what.size(), into));
  }
};

TEST_F(PartRefusals, BadWordsForParts) {
  for (const char* part : {"0/3", "4/3", "3", "a/b", "1/0", "1/2000000"})
    expect_refusal(run({"--part", part}), "such as 3/8");
  for (const char* pulses : {"5", "0:3", "7:6", "a:b"}) expect_refusal(run({"--pulses", pulses}), "such as 101:200");
  EXPECT_EQ(run({"--part", "1/2", "--pulses", "1:2"}).status, 2);
  expect_refusal(run({"--part-file"}), "give --part");
  expect_refusal(run({"--resume", "--discard"}), "--discard writes nothing");
}

TEST_F(PartRefusals, APartThatWasBegun) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  expect_refusal(run({"--part", "1/2"}), "part 1/2 was begun already: 20 of its pulses are there");
  EXPECT_EQ(run({"--part", "1/2", "--force"}).status, 0);
  EXPECT_EQ(run({"--part", "1/2", "--resume"}).status, 0);
}

TEST_F(PartRefusals, PartsThatOverlap) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  expect_refusal(run({"--part", "2/3"}), "part 2/3 overlaps part 1/2");
  expect_refusal(run({"--pulses", "20:21"}), "part 20:21 overlaps part 1/2");
  ASSERT_EQ(run({"--out", "other", "--pulses", "11:40"}).status, 0);
  expect_refusal(sarsim({"merge", "sim.bin.parts", "other/sim.bin.parts"}), "parts overlap: pulses 11 to 20");
  EXPECT_FALSE(fs::exists(folder_ / "sim.bin"));
}

TEST_F(PartRefusals, AMergeIntoWhatIsNoFile) {
  ASSERT_EQ(run({"--part", "1/1", "--part-file"}).status, 0);
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  expect_refusal(sarsim({"merge", "sim.bin.parts", "-o", "pipe", "--force"}), "parts can only become a file");
  EXPECT_EQ(entries("."), (std::vector<std::string>{"pipe", "scene.scr", "sim.bin.parts"}));
  EXPECT_EQ(sarsim({"merge", "sim.bin.parts"}).status, 0);
}

TEST_F(PartRefusals, PartsThatAreMissing) {
  ASSERT_EQ(run({"--part", "1/4"}).status, 0);
  ASSERT_EQ(run({"--part", "3/4"}).status, 0);
  const Finished merged = sarsim({"merge", "sim.bin.parts"});
  expect_refusal(merged, "no part holds pulses 11 to 20 of 40");
  expect_refusal(merged, "no part holds pulses 31 to 40 of 40");
}

TEST_F(PartRefusals, PartsOfAnotherSeed) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  expect_refusal(run({"--part", "2/2", "--seed", "7"}), "seed is 7 now, 1 there");
  ASSERT_EQ(run({"--out", "other", "--part", "2/2", "--seed", "7"}).status, 0);
  expect_refusal(sarsim({"merge", "sim.bin.parts", "other/sim.bin.parts"}),
                 "parts of different runs cannot be joined: seed is 1 in part 1/2, 7 in part 2/2");
}

TEST_F(PartRefusals, PartsOfAnotherVersionOfTheProgram) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  // A line with its own checksum, as another version would have written it.
  const std::string text = text_of(journal("part-1-of-2"));
  const std::size_t begin = text.find("is program ");
  ASSERT_NE(begin, std::string::npos);
  const std::string other = "is program 0.0.9";
  std::array<char, 32> seal{};
  std::snprintf(seal.data(), seal.size(), " #%016lx\n", static_cast<unsigned long>(core::checksum_of(other)));
  change(journal("part-1-of-2"), text.substr(begin, text.find('\n', begin) + 1 - begin), other + seal.data());
  expect_refusal(run({"--part", "2/2"}), "program is 0.1.0 now, 0.0.9 there");
}

TEST_F(PartRefusals, PartsOfAChangedScript) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  change(folder_ / "scene.scr", "1000 1 0, 0", "1001 1 0, 0");
  expect_refusal(run({"--part", "2/2"}), "the script, or a data file of it, has changed");
}

TEST_F(PartRefusals, PartsOfAChangedTableOfPoints) {
  change(folder_ / "scene.scr", "$TARGET", "$CLOUD Earth FILE points.csv 0 0 0 1 0 ISOTROPIC\n$TARGET");
  write_text(folder_ / "points.csv", "0,1100,0\n5,1120,0\n");
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  write_text(folder_ / "points.csv", "0,1100,0\n5,1121,0\n");
  expect_refusal(run({"--part", "2/2"}), "the script, or a data file of it, has changed");
  expect_refusal(run({"--part", "1/2", "--resume"}), "the script, or a data file of it, has changed");
  write_text(folder_ / "points.csv", "x,y,z\n0,1100,0\n5,1120,0\n");
  EXPECT_EQ(run({"--part", "2/2"}).status, 0) << "the same points";
}

TEST_F(PartRefusals, PartsWithOtherOptions) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  expect_refusal(run({"--part", "2/2", "--engine", "reference"}), "engine is reference now");
  expect_refusal(run({"--part", "2/2", "--tolerance", "1e-3"}), "tolerance is");
  expect_refusal(run({"--part", "2/2", "--simd", "sse4"}), "--simd is sse4 now");
}

TEST_F(PartRefusals, AJournalThatIsDamaged) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  change(journal("part-1-of-2"), "rows 0", "rows 1");
  expect_refusal(run({"--part", "1/2", "--resume"}), "the journal is damaged");
  expect_refusal(run({"--part", "2/2"}), "the journal is damaged");
  expect_refusal(sarsim({"merge", "sim.bin.parts"}), "the journal is damaged");
}

TEST_F(PartRefusals, RowsThatAreDamagedInAMerge) {
  ASSERT_EQ(run({"--part", "1/1", "--part-file"}).status, 0);
  std::string rows = text_of(folder_ / "sim.bin.parts/part-1-of-1.rows");
  rows[5000] = static_cast<char>(rows[5000] ^ 4);
  write_text(folder_ / "sim.bin.parts/part-1-of-1.rows", rows);
  expect_refusal(sarsim({"merge", "sim.bin.parts"}), "are not what part 1/1 wrote");
  EXPECT_FALSE(fs::exists(folder_ / "sim.bin"));
  expect_refusal(sarsim({"merge", "sim.bin.parts", "-o", "other.bin"}), "are not what part 1/1 wrote");
  EXPECT_EQ(entries("."), (std::vector<std::string>{"scene.scr", "sim.bin.parts"}));
}

TEST_F(PartRefusals, AnOutputAmongTheParts) {
  ASSERT_EQ(run({"--part", "1/1", "--part-file"}).status, 0);
  const auto before = entries("sim.bin.parts");
  const std::string rows = text_of(folder_ / "sim.bin.parts/part-1-of-1.rows");
  fs::create_directory_symlink("sim.bin.parts", folder_ / "other-name");
  for (const char* output : {"sim.bin.parts/all.bin", "sim.bin.parts/part-1-of-1.rows", "other-name/all.bin",
                             "sim.bin.parts/new/all.bin", "./new/../sim.bin.parts/all.bin"})
    expect_refusal(sarsim({"merge", "sim.bin.parts", "-o", output, "--force", "--remove"}),
                   "is in the folder of parts");
  EXPECT_EQ(entries("sim.bin.parts"), before);
  EXPECT_EQ(text_of(folder_ / "sim.bin.parts/part-1-of-1.rows"), rows);
  EXPECT_EQ(sarsim({"merge", "sim.bin.parts", "-o", "sim.bin.parts.bin"}).status, 0);
}

TEST_F(PartRefusals, FilesToBeWrittenThatHaveOtherNames) {
  fs::create_directory(folder_ / "sim.bin.parts");
  write_text(folder_ / "sim.bin.parts/lock", "");
  write_text(folder_ / "victim", "mine");
  for (const char* name : {"samples", "part-1-of-2.rows"})
    fs::create_hard_link(folder_ / "victim", folder_ / "sim.bin.parts" / name);
  const std::string sentence = "the file to be written has other names, which would change with it";
  expect_refusal(run({"--part", "1/1"}), sentence);
  expect_refusal(run({"--part", "1/2", "--part-file"}), sentence);
  EXPECT_EQ(text_of(folder_ / "victim"), "mine");
}

TEST_F(PartRefusals, AReceiptWhoseFirstLineIsDamaged) {
  const std::string text = "sarsim journal 1 #x\nprecious\n";
  write_text(folder_ / "sim.bin.journal", text);
  for (const char* option : {"--resume", "--part=1/1"}) expect_refusal(run({option}), "is taken by something else");
  EXPECT_EQ(text_of(folder_ / "sim.bin.journal"), text);
  EXPECT_FALSE(fs::exists(folder_ / "sim.bin"));
}

TEST_F(PartRefusals, FilesTooLargeToBeRead) {
  ASSERT_EQ(run({"--part", "1/1", "--part-file"}).status, 0);
  const fs::path product = folder_ / "sim.bin.parts/product";
  fs::resize_file(product, std::uintmax_t{1} << 40U);
  expect_refusal(sarsim({"merge", "sim.bin.parts"}), "found '1099511627776 bytes', expected 16 to 17179869184 bytes");
  fs::resize_file(journal("part-1-of-1"), std::uintmax_t{1} << 40U);
  expect_refusal(sarsim({"merge", "sim.bin.parts"}),
                 "the file is too large for a journal; found '1099511627776 bytes'");
  expect_refusal(run({"--part", "1/1", "--part-file", "--resume"}), "the file is too large for a journal");
}

TEST_F(PartRefusals, ADescriptionThatIsNotThere) {
  ASSERT_EQ(run({"--part", "1/1", "--part-file"}).status, 0);
  const fs::path product = folder_ / "sim.bin.parts/product";
  const std::string text = text_of(product);
  const auto expect_refused = [&](const std::string& sentence) {
    const Finished merged = sarsim({"merge", "sim.bin.parts"});
    expect_refusal(merged, sentence);
    expect_refusal(merged, "sim.bin.parts/product: error: ");
    EXPECT_THAT(merged.err, testing::Not(HasSubstr("Invalid argument")));
  };
  write_text(product, text.substr(0, text.size() - 1));
  expect_refused("the description of the recording is damaged; found ");
  write_text(product, "");
  expect_refused("the size is not that of the description of a recording; found '0 bytes'");
  fs::remove(product);
  ASSERT_EQ(::mkfifo(product.c_str(), 0600), 0);
  expect_refused("found 'a pipe', expected a regular file");
  fs::remove(product);
  fs::create_directory(product);
  expect_refused("found 'a folder', expected a regular file");
  fs::remove(product);
  expect_refused("the description of the recording is missing; expected ");
  // What the hint says.
  ASSERT_EQ(run({"--part", "1/1", "--part-file", "--resume"}).status, 0);
  EXPECT_EQ(sarsim({"merge", "sim.bin.parts"}).status, 0);
}

TEST_F(PartRefusals, TwoRunsOnOneFileAtOnce) {
  SceneText scene;
  scene.pulses = 400000;
  scene.lsb_mv = "3e-5";
  write_scene(scene);
  Start start;
  start.folder = folder_;
  Program busy({"run", "scene.scr", "--part", "1/2", "--threads", "1"}, start);
  ASSERT_TRUE(busy.wait_for("10 %", 60.0)) << busy.err();
  // Nobody's mistake: whoever starts parts shall try again.
  expect_refusal(run({"--part", "1/2", "--resume"}), "part 1/2 is being made by another process", 75);
  expect_refusal(run({"--part", "1/2", "--force"}), "part 1/2 is being made by another process", 75);
  expect_refusal(run({"--resume"}), "overlaps part 1/2, which is being made", 75);
  const Finished merged = sarsim({"merge", "sim.bin.parts", "--json"});
  expect_refusal(merged, "is still being made", 75);
  for (const Finished& told : {merged, run({"--resume", "--json"})})
    EXPECT_THAT(told.out, HasSubstr("\"status\": \"try again\""));
  busy.send(SIGKILL);
  EXPECT_EQ(busy.finish().status, -SIGKILL);
}

TEST_F(PartRefusals, AFinishedFileOfAnotherRun) {
  ASSERT_EQ(run({"--resume"}).status, 0);
  expect_refusal(run({"--resume", "--seed", "7"}),
                 "the output is finished, but of another run: seed is 7 now, 1 in the file");
  write_text(folder_ / "sim.bin", "something else");
  expect_refusal(run({"--resume"}), "the output exists already");
}

TEST_F(PartRefusals, DevicesInPlaceOfTheFile) {
  fs::create_symlink("/dev/null", folder_ / "sim.bin");
  expect_refusal(run({"--part", "1/1", "--force"}), "parts can only become a file");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(PartRefusals, AFolderThatIsNamedTwice) {
  ASSERT_EQ(run({"--part", "1/2"}).status, 0);
  expect_refusal(sarsim({"merge", "sim.bin.parts", "./sim.bin.parts"}), "is named twice");
}

TEST_F(PartRefusals, FoldersThatHoldNoParts) {
  expect_refusal(sarsim({"merge", "nowhere.parts"}), "there is no folder 'nowhere.parts'");
  fs::create_directory(folder_ / "empty.parts");
  expect_refusal(sarsim({"merge", "empty.parts"}), "holds no parts");
  expect_refusal(sarsim({"merge", "."}), "is not a folder of parts");
}

}  // namespace refusals_test
}  // namespace sarsim::test
