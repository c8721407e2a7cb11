// How `sarsim measure` finds the script of an image, and whether it is still the same.

#include <filesystem>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace measure_source_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class MeasureSource : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_text(folder_ / "scene.scr", text_of(SARSIM_SOURCE_DIR "/examples/sar_r.scr"));
  }

  [[nodiscard]] Finished measure_in(const std::string& folder, const std::vector<std::string>& words) const {
    Start start;
    start.folder = folder_ / folder;
    return Program(words, start).finish();
  }

  void change_script(const std::string& from, const std::string& to) const {
    std::string text = text_of(folder_ / "scene.scr");
    ASSERT_NE(text.find(from), std::string::npos);
    text.replace(text.find(from), from.size(), to);
    write_text(folder_ / "scene.scr", text);
  }
};

TEST_F(MeasureSource, AScriptThatChangedSinceIsToldOf) {
  ASSERT_EQ(sarsim({"focus", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  EXPECT_THAT(sarsim({"measure", "x.img", "--target", "1"}).err, Not(HasSubstr("warning")));
  change_script("-190, -100, 0", "-180, -100, 0");
  const Finished changed = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(changed.status, 1) << changed.out;  // Nothing is where the target is now.
  EXPECT_THAT(changed.err, AllOf(HasSubstr("warning: the script is not the one that 'x.img' was made from"),
                                 HasSubstr("scene.scr"), HasSubstr("--script")));
}

TEST_F(MeasureSource, CommentsDoNotMakeAnotherScript) {
  ASSERT_EQ(sarsim({"focus", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  write_text(folder_ / "scene.scr", "! another comment\n" + text_of(folder_ / "scene.scr"));
  EXPECT_THAT(sarsim({"measure", "x.img", "--target", "1"}).err, Not(HasSubstr("warning")));
}

TEST_F(MeasureSource, AScriptThatIsNamedIsTakenAsItIs) {
  ASSERT_EQ(sarsim({"focus", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  fs::rename(folder_ / "scene.scr", folder_ / "kept.scr");
  const Finished named = sarsim({"measure", "x.img", "--target", "1", "--script", "kept.scr"});
  EXPECT_EQ(named.status, 0) << named.err;
  EXPECT_THAT(named.err, Not(HasSubstr("warning")));
}

TEST_F(MeasureSource, AScriptThatIsNamedTakesThePlaceOfTheOneThatTheRecordingWasFocusedWith) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  std::string recording;
  for (const std::string& name : entries("."))
    if (name.ends_with(".npy")) recording = name;
  ASSERT_EQ(sarsim({"focus", recording, "--script", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  const std::string then = sarsim({"measure", "x.img", "--target", "1"}).out;
  fs::copy_file(folder_ / "scene.scr", folder_ / "then.scr");
  change_script("-190, -100, 0", "-150, -100, 0");
  EXPECT_EQ(sarsim({"measure", "x.img", "--target", "1", "--script", "then.scr"}).out, then);
  EXPECT_NE(sarsim({"measure", "x.img", "--target", "1"}).out, then);
}

TEST_F(MeasureSource, IsFoundFromTheFolderOfTheImage) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  std::string recording;
  for (const std::string& name : entries("."))
    if (name.ends_with(".h5")) recording = name;
  ASSERT_EQ(sarsim({"focus", recording, "--out", "sub/x.img", "--quiet"}).status, 0);
  const Finished below = measure_in("sub", {"measure", "x.img", "--target", "1"});
  EXPECT_EQ(below.status, 0) << below.err;
  fs::create_directory(folder_ / "far");
  EXPECT_EQ(measure_in("far", {"measure", "../sub/x.img", "--target", "1"}).status, 0);
  fs::rename(folder_ / "sub", folder_ / "far/moved");
  EXPECT_EQ(measure_in(".", {"measure", "far/moved/x.img", "--target", "1"}).status, 0);
  fs::rename(folder_ / recording, folder_ / "far/moved" / recording);
  EXPECT_EQ(measure_in("far", {"measure", "moved/x.img", "--target", "1"}).status, 0);
}

// Another recording of the name, of another seed: its targets are those of another flight.
TEST_F(MeasureSource, AnotherRecordingOfTheSameNameIsNotTakenForTheTruth) {
  const auto recorded = [&](const std::string& folder, const char* seed) {
    ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--seed", seed, "--set", "Radar1.noise_temperature=0.01K",
                      "--out", folder, "--quiet"})
                  .status,
              0);
  };
  recorded("a", "1");
  recorded("b", "2");
  const std::string name = entries("a").at(0);
  ASSERT_EQ(sarsim({"focus", "a/" + name, "--out", "x.img", "--quiet"}).status, 0);
  EXPECT_EQ(sarsim({"measure", "x.img", "--target", "1"}).status, 0);
  // Beside the image, while that of the header is gone.
  fs::copy_file(folder_ / "b" / name, folder_ / name);
  fs::rename(folder_ / "a" / name, folder_ / "kept.h5");
  const Finished other = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(other.status, 2) << other.out;
  EXPECT_THAT(other.err, AllOf(HasSubstr("is not the file that 'x.img' was made from"), HasSubstr("other samples"),
                               HasSubstr("--script")));
  // The same samples in another place are the truth, and it is said.
  fs::copy_file(folder_ / "kept.h5", folder_ / name, fs::copy_options::overwrite_existing);
  const Finished moved = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(moved.status, 0) << moved.err;
  EXPECT_THAT(moved.err, HasSubstr("is taken for 'a/" + name + "'"));
  // Replaced where it was.
  fs::copy_file(folder_ / "b" / name, folder_ / "a" / name);
  fs::remove(folder_ / name);
  EXPECT_EQ(sarsim({"measure", "x.img", "--target", "1"}).status, 2);
}

// Where nothing was compared, nobody speaks of other samples.
TEST_F(MeasureSource, WhatCannotBeComparedIsNotCalledAnother) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  std::string recording;
  for (const std::string& name : entries("."))
    if (name.ends_with(".h5")) recording = name;
  ASSERT_EQ(sarsim({"focus", recording, "--out", "x.img", "--quiet"}).status, 0);
  const std::string header = text_of(folder_ / "x.hdr");
  const std::size_t at = header.find("source checksum = {");
  ASSERT_NE(at, std::string::npos);
  std::string blank = header;
  blank.replace(at, header.find('}', at) - at, "source checksum = {");
  write_text(folder_ / "x.hdr", blank);
  const Finished nameless = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(nameless.status, 0) << nameless.err;
  EXPECT_THAT(nameless.err, HasSubstr("does not say which samples it was made from"));
  write_text(folder_ / "x.hdr", header);
  const std::string bytes = text_of(folder_ / recording);
  write_text(folder_ / recording, bytes.substr(0, bytes.size() / 2));
  const Finished damaged = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_NE(damaged.status, 0);
  EXPECT_THAT(damaged.err, AllOf(HasSubstr(recording), Not(HasSubstr("other samples"))));
}

// The samples are those of the image, the scene beside them is not: it is told of, as one in a file of its own is.
TEST_F(MeasureSource, ASceneInsideTheRecordingThatChangedIsToldOf) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "sigmf", "--quiet"}).status, 0);
  std::string recording;
  for (const std::string& name : entries("."))
    if (name.ends_with(".sigmf-meta")) recording = name;
  ASSERT_EQ(sarsim({"focus", recording, "--out", "x.img", "--quiet"}).status, 0);
  EXPECT_THAT(sarsim({"measure", "x.img", "--target", "1"}).err, Not(HasSubstr("warning")));
  std::string text = text_of(folder_ / recording);
  ASSERT_NE(text.find("-190"), std::string::npos);
  write_text(folder_ / recording, text.replace(text.find("-190"), 4, "-189"));
  EXPECT_THAT(sarsim({"measure", "x.img", "--target", "1"}).err,
              AllOf(HasSubstr("warning: the script is not the one that 'x.img' was made from"), HasSubstr(recording)));
}

// What a header repeats of the recording.
TEST_F(MeasureSource, AHeaderThatContradictsTheRecordingIsToldOf) {
  ASSERT_EQ(sarsim({"focus", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  const std::string header = text_of(folder_ / "x.hdr");
  // That of the other profile.
  const bool classic = header.find("light speed mps = {299792500") != std::string::npos;
  for (const auto& [field, value] :
       {std::pair("carrier hz", "6.1e9"), std::pair("light speed mps", classic ? "299792458" : "299792500"),
        std::pair("along", "0, -1, 0")}) {
    std::string edited = header;
    const std::size_t at = edited.find(std::string("\n") + field + " = ");
    ASSERT_NE(at, std::string::npos) << field;
    edited.replace(at + 1, edited.find('\n', at + 1) - at - 1, std::string(field) + " = {" + value + "}");
    write_text(folder_ / "x.hdr", edited);
    EXPECT_THAT(sarsim({"measure", "x.img", "--target", "1"}).err,
                HasSubstr(std::string("warning: the header of 'x.img' contradicts what it was made from: ") + field));
  }
}

// A scene of the name elsewhere is not the one that was focused; edited at its place it is taken, with a warning.
TEST_F(MeasureSource, AnotherSceneOfTheSameNameIsNotTakenForTheTruth) {
  fs::create_directory(folder_ / "a");
  fs::rename(folder_ / "scene.scr", folder_ / "a/scene.scr");
  ASSERT_EQ(sarsim({"focus", "a/scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  fs::rename(folder_ / "a/scene.scr", folder_ / "scene.scr");
  const Finished moved = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(moved.status, 0) << moved.err;
  EXPECT_THAT(moved.err, HasSubstr("it has the scene that 'x.img' was made from"));
  change_script("-190, -100, 0", "-180, -100, 0");
  const Finished other = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("is not the file that 'x.img' was made from"));
}

// Focused from CPHD, an image lies in the world of the scene that was converted, wherever its reference point is.
TEST_F(MeasureSource, ImagesOfPhaseHistoriesAreMeasuredAgainstTheirScene) {
  const std::string scene = R"(format = "sarsim 2"
[[platform]]
name = "Plane"
path = { type = "line", start = [0, -2500, 1500], velocity = [100, 0, 0] }
[[target]]
positions = [[0, 0, 0], [31, 23, 0], [-12, 8, 0]]
[[radar]]
name = "X"
platform = "Plane"
pulse = { type = "chirp", bandwidth = "60 MHz", width = "0.5 us" }
repetition = "240 Hz"
carrier = "9.6 GHz"
power = "1 kW"
[[recording]]
radar = "X"
file = "small.h5"
format = "hdf5"
sample_rate = "75 MHz"
range = ["2850 m", "2990 m"]
time = ["-0.7 s", "0.7 s"]
)";
  write_text(folder_ / "strip.toml", scene);
  const std::string earth =
      "[world]\nframe = \"earth\"\nanchor = { latitude = \"47.5 deg\", longitude = \"8.25 deg\" }\n";
  std::string anchored = scene;
  write_text(folder_ / "earth.toml", anchored.insert(anchored.find('\n') + 1, earth));
  const auto measured = [&](const std::string& script, const std::vector<std::string>& anchor) {
    std::vector<std::string> convert{"convert", script, "strip.cphd", "--force"};
    convert.insert(convert.end(), anchor.begin(), anchor.end());
    EXPECT_EQ(sarsim(convert).status, 0) << script;
    EXPECT_EQ(sarsim({"focus", "strip.cphd", "--out", "strip.img", "--force", "--quiet"}).status, 0);
    return sarsim({"measure", "strip.img", "--script", script});
  };
  for (const Finished& measure :
       {measured("strip.toml", {"--anchor", "47.5,8.25,400"}),
        measured("strip.toml", {"--anchor", "-33.9,18.4,120,30"}), measured("earth.toml", {})}) {
    EXPECT_EQ(measure.status, 0) << measure.out << measure.err;
    EXPECT_THAT(measure.out, HasSubstr("3 of 3 targets found"));
  }
}

TEST_F(MeasureSource, ASourceThatIsGoneIsNamedWithTheWayOut) {
  ASSERT_EQ(sarsim({"focus", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  fs::remove(folder_ / "scene.scr");
  const Finished gone = sarsim({"measure", "x.img"});
  EXPECT_EQ(gone.status, 2);
  EXPECT_THAT(gone.err,
              AllOf(HasSubstr("'scene.scr', which 'x.img' was made from, is not there"), HasSubstr("--script")));
}

TEST_F(MeasureSource, ImagesOfEarlierHeadersAreStillMeasured) {
  ASSERT_EQ(sarsim({"focus", "scene.scr", "--out", "x.img", "--quiet"}).status, 0);
  std::string header = text_of(folder_ / "x.hdr");
  for (const char* field : {"source from image", "script from image", "script checksum"}) {
    const std::size_t begin = header.find(field);
    ASSERT_NE(begin, std::string::npos) << field;
    header.erase(begin, header.find('\n', begin) + 1 - begin);
  }
  write_text(folder_ / "x.hdr", header);
  const Finished measure = sarsim({"measure", "x.img", "--target", "1"});
  EXPECT_EQ(measure.status, 0) << measure.err;
  EXPECT_THAT(measure.err, Not(HasSubstr("warning")));
}

}  // namespace measure_source_test
}  // namespace sarsim::test
