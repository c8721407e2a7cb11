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
  EXPECT_EQ(changed.status, 0) << changed.err;
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
