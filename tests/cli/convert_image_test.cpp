#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <span>

#include "program.hpp"

namespace sarsim::test {
namespace convert_image_test {

namespace fs = std::filesystem;

using testing::HasSubstr;

std::string header_of_image(int type, const std::string& more) {
  return "ENVI\ndescription = {two lines}\nsamples = 3\nlines = 2\nbands = 1\nheader offset = 0\n"
         "file type = ENVI Standard\ndata type = " +
         std::to_string(type) + "\ninterleave = bsq\nbyte order = 0\nazimuth first m = {-200.5}\n" + more;
}

std::string bytes_of(std::span<const float> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

constexpr std::array<float, 12> numbers{1, 2, 3, -4, 0, 0.5F, -1, 0, 6, 8, 0.25F, 0};

// An image of two lines with its header, as `focus` leaves them.
class ConvertImage : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_text(folder_ / "image.img", bytes_of(numbers));
    write_text(folder_ / "image.hdr", header_of_image(6, "source from image = {scene.scr}\n"));
  }

  [[nodiscard]] Finished convert(std::vector<std::string> words) const {
    words.insert(words.begin(), "convert");
    return sarsim(words);
  }
};

TEST_F(ConvertImage, TakesTheHeaderAlongToNumpyAndBack) {
  const Finished there = convert({"image.img", "copy.npy"});
  ASSERT_EQ(there.status, 0) << there.err;
  EXPECT_EQ(there.err, "");
  const std::string header = text_of(folder_ / "copy.hdr");
  EXPECT_THAT(header, HasSubstr("header offset = 128\n"));
  EXPECT_THAT(header, HasSubstr("azimuth first m = {-200.5}\n"));
  EXPECT_EQ(fs::file_size(folder_ / "copy.npy"), 128U + sizeof numbers);
  const Finished back = convert({"copy.npy", "back.img"});
  ASSERT_EQ(back.status, 0) << back.err;
  EXPECT_EQ(text_of(folder_ / "back.img"), text_of(folder_ / "image.img"));
  EXPECT_EQ(text_of(folder_ / "back.hdr"), text_of(folder_ / "image.hdr"));
}

TEST_F(ConvertImage, GivesACopyOfTheSameNameAHeaderOfItsOwn) {
  const std::string before = text_of(folder_ / "image.hdr");
  ASSERT_EQ(convert({"image.img", "image.npy"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "image.hdr"), before);
  EXPECT_TRUE(fs::exists(folder_ / "image.npy.hdr"));
  for (const char* name : {"image.npy", "image.img"}) {
    const Finished again = convert({name, "again.img", "--force"});
    ASSERT_EQ(again.status, 0) << name << ": " << again.err;
    EXPECT_EQ(text_of(folder_ / "again.img"), text_of(folder_ / "image.img")) << name;
    EXPECT_EQ(text_of(folder_ / "again.hdr"), before) << name;
  }
}

TEST_F(ConvertImage, LeadsBackToTheSourceFromAnotherFolder) {
  fs::create_directory(folder_ / "sub");
  ASSERT_EQ(convert({"image.img", "sub/image.npy"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "sub/image.hdr"), HasSubstr("source from image = {../scene.scr}\n"));
}

TEST_F(ConvertImage, KeepsTheSignsOfRealPixelsAndMakesNoFocusedImageOfMagnitudes) {
  const auto real = std::span(numbers).first(6);
  write_text(folder_ / "real.img", bytes_of(real));
  write_text(folder_ / "real.hdr", header_of_image(4, "image plane = {slant range}\n"));
  ASSERT_EQ(convert({"real.img", "copy.img"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "copy.img"), bytes_of(real));
  EXPECT_EQ(text_of(folder_ / "copy.hdr"), text_of(folder_ / "real.hdr"));
  const Finished array = convert({"real.img", "array.npy"});
  ASSERT_EQ(array.status, 0) << array.err;
  EXPECT_THAT(array.err, HasSubstr("the magnitudes become complex numbers"));
  EXPECT_FALSE(fs::exists(folder_ / "array.hdr"));
}

TEST_F(ConvertImage, SaysWhatIsLeftBehind) {
  const Finished text = convert({"image.img", "copy.asc", "--bits", "8", "--lsb", "1"});
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.err, HasSubstr("in the header of 'image.img' are left behind"));
  const Finished counts = convert({"image.img", "copy.npy", "--counts", "--bits", "8", "--lsb", "1"});
  ASSERT_EQ(counts.status, 0) << counts.err;
  EXPECT_THAT(counts.err, HasSubstr("counts do not make an image"));
  EXPECT_FALSE(fs::exists(folder_ / "copy.hdr"));
}

TEST_F(ConvertImage, ReplacesNoHeaderWithoutForceAndItsOwnNever) {
  write_text(folder_ / "copy.hdr", "precious");
  const Finished refused = convert({"image.img", "copy.npy"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("copy.hdr"));
  EXPECT_FALSE(fs::exists(folder_ / "copy.npy"));
  EXPECT_EQ(text_of(folder_ / "copy.hdr"), "precious");
  EXPECT_EQ(convert({"image.img", "copy.npy", "--force"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "copy.hdr"), HasSubstr("ENVI"));
  const Finished own = convert({"image.img", "image.hdr", "--to", "npy", "--force"});
  EXPECT_EQ(own.status, 2);
  EXPECT_THAT(own.err, HasSubstr("would replace the file that it is made from"));
}

TEST_F(ConvertImage, MakesNoImageOfARecordingOrOfCounts) {
  write_text(folder_ / "sim.asc", "1 2\n3 4\n\n");
  const Finished recording = convert({"sim.asc", "made.img"});
  EXPECT_EQ(recording.status, 2);
  EXPECT_THAT(recording.err, HasSubstr("'sim.asc' has no header"));
  const Finished counts = convert({"image.img", "made.img", "--counts"});
  EXPECT_EQ(counts.status, 2);
  EXPECT_THAT(counts.err, HasSubstr("--counts"));
  EXPECT_FALSE(fs::exists(folder_ / "made.img"));
}

TEST_F(ConvertImage, MeasuresACopyAsTheImage) {
  const Finished focus = sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--quiet"});
  ASSERT_EQ(focus.status, 0) << focus.err;
  fs::create_directory(folder_ / "sub");
  ASSERT_EQ(convert({"sar_r.img", "sub/copy.npy"}).status, 0);
  const Finished image = sarsim({"measure", "sar_r.img"});
  const Finished copy = sarsim({"measure", "sub/copy.npy"});
  ASSERT_EQ(image.status, 0) << image.err;
  ASSERT_EQ(copy.status, 0) << copy.err;
  // The first line names the file.
  EXPECT_EQ(copy.out.substr(copy.out.find(": ")), image.out.substr(image.out.find(": ")));
}

}  // namespace convert_image_test
}  // namespace sarsim::test
