#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>

#include "program.hpp"

namespace sarsim::test {
namespace convert_test {

namespace fs = std::filesystem;

using testing::HasSubstr;

// Files of one recording in every format, made by `run`.
class Convert : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    SceneText scene;
    scene.lsb_mv = "2e-5";
    scene.format = "ASCII";
    scene.files = {"sim.asc"};
    write_scene(scene);
    for (const char* format : {"ascii", "binary", "bracket", "csv", "hdf5", "npy", "zarr"})
      ASSERT_EQ(sarsim({"run", "scene.scr", "--format", format}).status, 0) << format;
  }
};

TEST_F(Convert, CountsKeepTheirBytesThroughEveryFormat) {
  const std::vector<std::string> counted{"sim.asc", "sim.bin", "sim.brk", "sim.csv"};
  for (const std::string& from : counted)
    for (const std::string& to : counted) {
      if (from == to) continue;
      const Finished run = sarsim({"convert", from, "made" + to, "--script", "scene.scr", "--force"});
      EXPECT_EQ(run.status, 0) << from << " to " << to << ": " << run.err;
      EXPECT_EQ(text_of(folder_ / ("made" + to)), text_of(folder_ / to)) << from << " to " << to;
    }
}

TEST_F(Convert, VoltsBecomeTheCountsThatARunGives) {
  EXPECT_EQ(sarsim({"convert", "sim.h5", "made.bin"}).status, 0);
  // float32 holds 24 bits, counts 8: only a value on the edge between two counts could differ.
  EXPECT_EQ(text_of(folder_ / "made.bin"), text_of(folder_ / "sim.bin"));
  EXPECT_EQ(sarsim({"convert", "sim.npy", "from-npy.bin", "--bits", "8", "--lsb", "2e-8"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "from-npy.bin"), text_of(folder_ / "sim.bin"));
}

TEST_F(Convert, Hdf5KeepsAxesAndAttributes) {
  ASSERT_EQ(sarsim({"convert", "sim.h5", "made.h5"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "made.h5"), text_of(folder_ / "sim.h5"));
}

TEST_F(Convert, ZarrKeepsAxesAndAttributes) {
  ASSERT_EQ(sarsim({"convert", "sim.h5", "made.zarr/"}).status, 0);
  EXPECT_TRUE(text_of(folder_ / "made.zarr" / "samples") == text_of(folder_ / "sim.zarr" / "samples"));
  ASSERT_EQ(sarsim({"convert", "made.zarr", "back.h5"}).status, 0);
  EXPECT_TRUE(text_of(folder_ / "back.h5") == text_of(folder_ / "sim.h5"));
  ASSERT_EQ(sarsim({"convert", "sim.zarr/", "made.bin"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "made.bin"), text_of(folder_ / "sim.bin"));
}

TEST_F(Convert, OnlyOwnZarrStoresAreReplaced) {
  const Finished again = sarsim({"convert", "sim.h5", "sim.zarr"});
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
  EXPECT_EQ(sarsim({"convert", "sim.h5", "sim.zarr", "--force"}).status, 0);
  EXPECT_THAT(sarsim({"convert", "sim.zarr", "sim.zarr", "--force"}).err, HasSubstr("would replace the folder"));
  std::ofstream(folder_ / "sim.zarr" / "notes.txt") << "mine";
  const std::string before = text_of(folder_ / "sim.zarr");
  const Finished theirs = sarsim({"convert", "sim.h5", "sim.zarr", "--force"});
  EXPECT_EQ(theirs.status, 2);
  EXPECT_THAT(theirs.err, HasSubstr("not a Zarr store of this program"));
  EXPECT_EQ(text_of(folder_ / "sim.zarr"), before);
  const Finished file = sarsim({"convert", "sim.h5", "sim.npy", "--to", "zarr", "--force"});
  EXPECT_NE(file.status, 0);
  EXPECT_THAT(sarsim({"convert", "sim.zarr", "--references", "r.json"}).err, HasSubstr("which readers of Zarr open"));
}

TEST_F(Convert, Hdf5SaysNothingThatNobodyKnows) {
  ASSERT_EQ(sarsim({"convert", "sim.npy", "made.h5"}).status, 0);
  const Finished known = sarsim({"info", "made.h5"});
  ASSERT_EQ(known.status, 0) << known.err;
  for (const char* word :
       {"bits", "lsb_v", "LSB", "sampling rate", "sample_rate_hz", "seed", "engine", "profile", "processing",
        "tolerance", "radar", "script", "send times", "carriers", "slant ranges", "nan"})
    EXPECT_THAT(known.out, testing::Not(HasSubstr(word))) << word;
  EXPECT_THAT(known.out, HasSubstr("format_version"));
  // Neither do later conversions believe it.
  const Finished bits = sarsim({"convert", "made.h5", "made.bin", "--lsb", "2e-8"});
  EXPECT_EQ(bits.status, 2);
  EXPECT_THAT(bits.err, HasSubstr("--bits"));
  ASSERT_EQ(sarsim({"convert", "made.h5", "made.bin", "--lsb", "2e-8", "--bits", "8"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "made.bin"), text_of(folder_ / "sim.bin"));
}

TEST_F(Convert, Hdf5SaysWhatTheCommandLineGave) {
  ASSERT_EQ(sarsim({"convert", "sim.asc", "made.h5", "--lsb", "2e-8", "--bits", "8"}).status, 0);
  EXPECT_EQ(sarsim({"convert", "made.h5", "back.bin"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "back.bin"), text_of(folder_ / "sim.bin"));
}

TEST_F(Convert, CountsBecomeVoltsWithTheLsb) {
  ASSERT_EQ(sarsim({"convert", "sim.asc", "made.npy", "--lsb", "2e-8"}).status, 0);
  ASSERT_EQ(sarsim({"convert", "made.npy", "back.asc", "--lsb", "2e-8", "--bits", "8"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "back.asc"), text_of(folder_ / "sim.asc"));
}

TEST_F(Convert, SaysWhatItNeedsToKnow) {
  const Finished volts = sarsim({"convert", "sim.asc", "made.h5"});
  EXPECT_EQ(volts.status, 2);
  EXPECT_THAT(volts.err, HasSubstr("--lsb"));
  const Finished bits = sarsim({"convert", "sim.asc", "made.bin"});
  EXPECT_EQ(bits.status, 2);
  EXPECT_THAT(bits.err, HasSubstr("--bits"));
  const Finished both = sarsim({"convert", "sim.npy", "made.asc"});
  EXPECT_EQ(both.status, 2);
  EXPECT_THAT(both.err, HasSubstr("--bits"));
  EXPECT_THAT(both.err, HasSubstr("--lsb"));
  const Finished shape = sarsim({"convert", "sim.bin", "made.asc"});
  EXPECT_EQ(shape.status, 2);
  const Finished format = sarsim({"convert", "sim.asc", "made.xyz"});
  EXPECT_EQ(format.status, 2);
  EXPECT_THAT(format.err, HasSubstr("--to"));
  EXPECT_EQ(sarsim({"convert", "sim.asc", "made.xyz", "--to", "bracket"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "made.xyz"), text_of(folder_ / "sim.brk"));
}

TEST_F(Convert, TakesTheSimulationOfARenamedFileByItsNumber) {
  fs::copy_file(folder_ / "sim.bin", folder_ / "other.bin");
  std::vector<std::string> words{"convert", "other.bin", "other.asc", "--script", "scene.scr"};
  const Finished unnamed = sarsim(words);
  EXPECT_EQ(unnamed.status, 2);
  EXPECT_THAT(unnamed.err, HasSubstr("its outputs are sim.asc: give the file its name there, "
                                     "say which with --simulation N, or say --columns, --bits and --lsb"));
  words.insert(words.end(), {"--simulation", "1"});
  const Finished named = sarsim(words);
  EXPECT_EQ(named.status, 0) << named.err;
  EXPECT_EQ(text_of(folder_ / "other.asc"), text_of(folder_ / "sim.asc"));
  words.back() = "2";
  words.emplace_back("--force");
  EXPECT_THAT(sarsim(words).err, HasSubstr("the scene has no recording 2"));
  EXPECT_THAT(sarsim({"convert", "sim.asc", "a.csv", "--simulation", "1"}).err, HasSubstr("name it with --script"));
  // A command without --simulation does not name it.
  const Finished info = sarsim({"info", "other.bin", "--script", "scene.scr"});
  EXPECT_EQ(info.status, 2);
  EXPECT_THAT(info.err, HasSubstr("give the file its name there, or say --columns"));
}

TEST_F(Convert, SaysWhereTheLsbIsThatAScriptLeavesToTheData) {
  SceneText scene;
  scene.format = "ASCII";
  scene.files = {"sim.asc"};
  write_scene(scene);
  const Finished run = sarsim({"convert", "sim.asc", "made.npy", "--script", "scene.scr"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("the script leaves the LSB to the data (0)"));
  EXPECT_THAT(run.err, HasSubstr("lsb_v"));
}

TEST_F(Convert, RefusesToReplaceWithoutForceAndNeverItsSource) {
  write_text(folder_ / "there.brk", "precious");
  EXPECT_EQ(sarsim({"convert", "sim.asc", "there.brk"}).status, 2);
  EXPECT_EQ(text_of(folder_ / "there.brk"), "precious");
  const std::string before = text_of(folder_ / "sim.asc");
  EXPECT_EQ(sarsim({"convert", "sim.asc", "./sim.asc", "--to", "bracket", "--force"}).status, 2);
  EXPECT_EQ(text_of(folder_ / "sim.asc"), before);
}

TEST_F(Convert, TellsOfClipping) {
  const Finished run = sarsim({"convert", "sim.h5", "made.asc", "--lsb", "1e-9", "--bits", "8"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("clipped to 8 bits; an LSB of"));
  const Finished other = sarsim({"convert", "sim.asc", "small.bin", "--bits", "2"});
  EXPECT_EQ(other.status, 0);
  EXPECT_THAT(other.err, HasSubstr("clipped to 2 bits"));
}

TEST_F(Convert, SaysWhereNoBitsHoldThemAll) {
  write_text(folder_ / "big.asc", "10000000000000000000 0\n1 2\n\n");
  const Finished run = sarsim({"convert", "big.asc", "big.csv", "--bits", "64"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("1 of 2 samples were clipped to 64 bits; 64 are the most"));
}

// One row of (NaN, 1) and (infinite, -3) in float32, as NumPy stores it.
std::string npy_of_odd_numbers() {
  std::string header = "{'descr': '<c8', 'fortran_order': False, 'shape': (1, 2), }";
  header += std::string(128 - 10 - 1 - header.size(), ' ') + '\n';
  const std::array<float, 4> numbers{std::numeric_limits<float>::quiet_NaN(), 1.0F,
                                     std::numeric_limits<float>::infinity(), -3.0F};
  const std::string size{static_cast<char>(header.size()), '\0'};
  return std::string("\x93NUMPY\x01\0", 8) + size + header +
         std::string(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
}

TEST_F(Convert, CountsZeroForWhatIsNoNumberAndTellsOfIt) {
  write_text(folder_ / "odd.npy", npy_of_odd_numbers());
  const Finished run = sarsim({"convert", "odd.npy", "odd.asc", "--bits", "8", "--lsb", "1"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(text_of(folder_ / "odd.asc"), "0 1\n128 -3\n\n");
  EXPECT_THAT(run.err, HasSubstr("I or Q of 1 of 2 samples is not a number"));
  EXPECT_THAT(run.err, HasSubstr("1 of 2 samples were clipped to 8 bits; some of the numbers are infinite"));
}

TEST_F(Convert, RefusesWhatTheNewFileCannotHold) {
  write_text(folder_ / "large.csv", "1,2\n3,1e39\n");
  for (const char* made : {"made.npy", "made.h5"}) {
    const Finished large = sarsim({"convert", "large.csv", made, "--lsb", "1"});
    EXPECT_EQ(large.status, 2) << made;
    EXPECT_THAT(large.err, HasSubstr("too large for the single precision of the new file"));
    EXPECT_THAT(large.err, HasSubstr("1e+39j V"));
    EXPECT_FALSE(fs::exists(folder_ / made));
  }
  const Finished small = sarsim({"convert", "sim.bin", "made.npy", "--script", "scene.scr", "--lsb", "1e-320"});
  EXPECT_EQ(small.status, 2);
  EXPECT_THAT(small.err, HasSubstr("--lsb is too small"));
  EXPECT_THAT(small.err, HasSubstr("expected at least 1e-37 V"));
}

}  // namespace convert_test
}  // namespace sarsim::test
