#include "workflow/convert/convert.hpp"

#include <complex>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "raster/format/npy_header.hpp"
#include "raster/format/open_raster.hpp"
#include "workflow/convert/convert_scene.hpp"
#include "workflow/motion/motion_files.hpp"
#include "workflow/record/geometry.hpp"

namespace sarsim::workflow {
namespace convert_test {

namespace fs = std::filesystem;

using testing::HasSubstr;

// A file of two rows of three counts and what becomes of it.
class Convert : public testing::Test {
 protected:
  Convert() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(path("in.asc")) << "1 -2\n3 0\n-7 5\n\n0 0\n127 -127\n4 4\n\n";
    request_.input = path("in.asc");
    request_.sample.bits = 8;
  }
  ~Convert() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  ConvertReport converted(const std::string& output) {
    request_.output = path(output);
    return convert(request_, observer_);
  }

  [[nodiscard]] std::vector<std::complex<double>> samples_of(const std::string& name,
                                                             const raster::RasterHints& hints = {}) const {
    const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::whole, path(name), hints);
    if (!opened.raster) return {};
    std::vector<std::complex<double>> samples(opened.raster->rows() * opened.raster->columns());
    opened.raster->read_rows(0, opened.raster->rows(), samples);
    return samples;
  }

  // The problems of a refusal, as one text.
  std::string refusal(const std::string& output) {
    try {
      static_cast<void>(converted(output));
    } catch (const core::InvalidRequest& refused) {
      std::string text;
      for (const core::Problem& problem : refused.problems) text += core::to_string(problem) + "\n";
      return text;
    }
    return {};
  }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("convert-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  ConvertRequest request_;
  core::Observer observer_;
};

TEST_F(Convert, CountsGoThereAndBack) {
  const ConvertReport report = converted("out.bin");
  EXPECT_EQ(report.files, std::vector<fs::path>{path("out.bin")});
  EXPECT_EQ(report.rows, 2U);
  EXPECT_EQ(report.columns, 3U);
  EXPECT_TRUE(report.counts);
  EXPECT_TRUE(report.remarks.empty());
  raster::RasterHints hints;
  hints.columns = 3;
  hints.bits = 8;
  EXPECT_EQ(samples_of("out.bin", hints), samples_of("in.asc"));
}

TEST_F(Convert, CountsBecomeVolts) {
  request_.sample.lsb_v = 0.25;
  EXPECT_FALSE(converted("out.npy").counts);
  auto expected = samples_of("in.asc");
  for (auto& sample : expected) sample *= 0.25;
  EXPECT_EQ(samples_of("out.npy"), expected);
}

TEST_F(Convert, SaysThatSamplesAreNotFiniteAndThatAllCountsAreZero) {
  std::ofstream(path("volts.npy"), std::ios::binary)
      << raster::npy_header_text("<c8", std::vector<std::size_t>{1, 2})
      << std::string("\0\0\xC0\x7F\0\0\x80\x3F\0\0\x80\x3F\0\0\0\x40", 16);  // NaN + i, 1 + 2i
  request_.input = path("volts.npy");
  request_.sample.bits = {};
  const ConvertReport copied = converted("copy.npy");
  ASSERT_EQ(copied.remarks.size(), 1U);
  EXPECT_THAT(core::to_string(copied.remarks[0]), testing::HasSubstr("1 of 2 samples are not finite"));
  EXPECT_THAT(core::to_string(copied.remarks[0]), testing::HasSubstr("row 0, sample 0"));
  request_.sample.bits = 8;
  request_.sample.lsb_v = 100.0;
  const ConvertReport zeros = converted("zeros.csv");
  std::string text;
  for (const core::Problem& problem : zeros.remarks) text += core::to_string(problem);
  EXPECT_THAT(text, testing::HasSubstr("all counts are 0: the LSB is 100 V"));
}

TEST_F(Convert, CountsWhatItClips) {
  request_.sample.bits = 4;
  const ConvertReport report = converted("out.bin");
  EXPECT_EQ(report.tally.saturated, 1U);
  ASSERT_EQ(report.remarks.size(), 1U);
  EXPECT_EQ(core::to_string(report.remarks.front()),
            "warning: 1 of 6 samples were clipped to 4 bits; more --bits would avoid clipping");
}

TEST_F(Convert, RefusesWithAllThatIsNotKnown) {
  request_.sample.bits.reset();
  EXPECT_THAT(refusal("out.npy"), HasSubstr("the LSB of '" + path("in.asc") + "' is not known, but npy needs it"));
  EXPECT_THAT(refusal("out.bin"), HasSubstr("the A/D bits of '" + path("in.asc") + "' are not known"));
  EXPECT_THAT(refusal("out.xyz"), HasSubstr("names no format"));
  request_.simulation = 1;
  EXPECT_THAT(refusal("out.csv"), HasSubstr("--simulation is a number in a script"));
}

TEST_F(Convert, ReplacesNothingUnlessForced) {
  static_cast<void>(converted("out.csv"));
  EXPECT_THAT(refusal("out.csv"), HasSubstr("exists"));
  EXPECT_THAT(refusal("in.asc"), HasSubstr("in.asc"));
  request_.force = true;
  EXPECT_EQ(refusal("out.csv"), "");
  raster::RasterHints hints;
  hints.bits = 8;
  EXPECT_EQ(samples_of("out.csv", hints), samples_of("in.asc"));
}

TEST_F(Convert, StoppedItLeavesNothingBehind) {
  core::StopFlag stop;
  stop.request();
  observer_.stop = &stop;
  EXPECT_THROW(static_cast<void>(converted("out.csv")), core::Interrupted);
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder_)) left.push_back(entry.path().filename());
  EXPECT_EQ(left, std::vector<fs::path>{"in.asc"});
}

TEST_F(Convert, TellsHowFarItIs) {
  std::vector<std::string> stages;
  observer_.progress = [&](const std::string& stage, const core::Progress& progress) {
    stages.push_back(stage);
    EXPECT_EQ(progress.total, 2U);
  };
  static_cast<void>(converted("out.csv"));
  EXPECT_EQ(stages, std::vector<std::string>{path("out.csv")});
}

// The reading of a scene, too, which may be long.
TEST_F(Convert, ScenesAreReadUntilAStopIsAskedFor) {
  std::ofstream(path("scene.toml")) << "format = \"sarsim 2\"\n[[platform]]\nname = \"P\"\n";
  core::StopFlag stop;
  stop.request();
  const core::WorkControl control{1, &stop};
  EXPECT_THROW(static_cast<void>(convert_scene({path("scene.toml"), path("new.toml"), {}, false}, control)),
               core::Interrupted);
  EXPECT_FALSE(fs::exists(path("new.toml")));
  MotionRequest motion;
  motion.input = path("scene.toml");
  motion.output = path("p.csv");
  EXPECT_THROW(static_cast<void>(write_motion(motion, control)), core::Interrupted);
  GeometryRequest geometry;
  geometry.input.path = path("scene.toml");
  EXPECT_THROW(static_cast<void>(geometry_tables(geometry, control)), core::Interrupted);
}

}  // namespace convert_test
}  // namespace sarsim::workflow
