#include "workflow/focus/focus.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "core/report/refused.hpp"
#include "raster/format/envi.hpp"
#include "scene/script/writer.hpp"
#include "support/test_folder.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace focus_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A script with one target in the middle of half a second of flight, as a program without a command line has it.
class FocusWorkflow : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "sar.scr") << scene::write_script(sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25));
    request_.input.path = (folder_ / "sar.scr").string();
    request_.threads = 2;
  }

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(focus(request_, {}));
    } catch (const core::Refused& refused) {
      return refused.problems.front().message;
    }
    return {};
  }

  [[nodiscard]] MeasureRequest of_image() const {
    MeasureRequest request;
    request.image = request_.output;
    request.threads = 2;
    return request;
  }

  test::TestFolder folder_;
  FocusRequest request_;
};

TEST_F(FocusWorkflow, WithoutAnOutputTheImageStaysInMemory) {
  const FocusReport report = focus(request_, {});
  EXPECT_TRUE(report.files.empty());
  EXPECT_EQ(folder_.entries(), 1U);
  EXPECT_FALSE(report.autofocus);
  EXPECT_EQ(report.motion, MotionOrder::none);
  const signal::FocusedImage image = signal::in_memory(report.image);
  const signal::ImagePlace place = signal::place_of(image.frame, {});
  const auto found = signal::measure_point(image, signal::reader_of(image), place, 3.0);
  ASSERT_TRUE(found);
  // A tenth of a cell: c/(2 B) = 1.5 m, and lambda R/(2 L) = 2.9 m of 100 m of flight.
  EXPECT_NEAR(found->place.range_m, place.range_m, 0.15);
  EXPECT_NEAR(found->place.azimuth_m, place.azimuth_m, 0.29);
}

TEST_F(FocusWorkflow, TheImageOfAFileIsTheOneInMemory) {
  for (const FocusAlgorithm algorithm : {FocusAlgorithm::chirp_scaling, FocusAlgorithm::back_projection}) {
    request_.algorithm = algorithm;
    request_.output = folder_ / "new" / fs::path(word_of(algorithm)).replace_extension(".img");
    const FocusReport report = focus(request_, {});
    EXPECT_EQ(report.files, outputs_of(request_));
    for (const fs::path& file : report.files) EXPECT_TRUE(fs::exists(file)) << file;
    const auto [file, problems] = raster::EnviImage::open(request_.output);
    ASSERT_TRUE(file);
    const signal::FocusedImage image = signal::in_memory(report.image);
    ASSERT_EQ(file->header().lines, image.azimuth.count);
    ASSERT_EQ(file->header().samples, image.range.count);
    std::vector<std::complex<float>> row(image.range.count);
    for (std::size_t r = 0; r < image.azimuth.count; ++r) {
      file->read(r, 0, row);
      ASSERT_TRUE(std::equal(row.begin(), row.end(), image.values.data() + r * row.size())) << r;
    }
  }
}

TEST_F(FocusWorkflow, WhatIsWrittenCanBeMeasuredAgainstTheory) {
  request_.output = folder_ / "a.img";
  static_cast<void>(focus(request_, {}));
  MeasureRequest request = of_image();
  request.cuts = true;
  const MeasureReport report = measure(request, {});
  EXPECT_EQ(report.origin.algorithm, "omega-k");
  EXPECT_TRUE(report.problems.empty());
  ASSERT_EQ(report.targets.size(), 1U);
  const MeasuredTarget& target = report.targets.front();
  ASSERT_TRUE(target.found);
  EXPECT_NEAR(target.amplitude_error_db(), 0.0, 0.3);
  EXPECT_NEAR(target.phase_error_rad(), 0.0, 0.1);
  EXPECT_FALSE(target.cuts.azimuth.values.empty());
  EXPECT_FALSE(target.cuts.range.values.empty());
  EXPECT_TRUE(target.picture.empty());
}

TEST_F(FocusWorkflow, MeasuringRefusesTargetsThatAreNotThereAndPicturesThatAre) {
  request_.output = folder_ / "a.img";
  static_cast<void>(focus(request_, {}));
  MeasureRequest request = of_image();
  request.target = 2;
  EXPECT_THROW(static_cast<void>(measure(request, {})), core::Refused);
  request.target = 1;
  request.pictures = folder_.path();
  EXPECT_EQ(measure(request, {}).targets.front().picture, folder_ / "target-1.png");
  std::ofstream(folder_ / "target-1.png") << "a picture";
  EXPECT_THROW(static_cast<void>(measure(request, {})), core::Refused);
  request.force = true;
  EXPECT_NO_THROW(static_cast<void>(measure(request, {})));
}

TEST_F(FocusWorkflow, TheObserverSeesTheStageAndWhatTheReportRemarks) {
  request_.output = folder_ / "a.img";
  std::set<std::string> stages;
  core::Problems remarks;
  core::Observer observer;
  observer.progress = [&](const std::string& stage, const core::Progress&) { stages.insert(stage); };
  observer.remark = [&](const core::Problems& problems) { remarks = problems; };
  const FocusReport report = focus(request_, observer);
  EXPECT_EQ(stages, std::set<std::string>{request_.output.string()});
  EXPECT_EQ(remarks.size(), report.problems.size());
}

TEST_F(FocusWorkflow, RefusesWhatContradictsItself) {
  request_.grid = FocusGrid::ground;
  EXPECT_THAT(refusal(), HasSubstr("--grid ground needs an algorithm"));
  request_.grid = FocusGrid::slant;
  request_.autofocus_phase = folder_ / "phase.csv";
  EXPECT_THAT(refusal(), HasSubstr("say how --autofocus works"));
  request_.autofocus_phase.clear();
  request_.magnitude = true;  // Of an image without a file.
  EXPECT_THAT(refusal(), HasSubstr("--magnitude makes ENVI images"));
  request_.magnitude = false;
  request_.output = folder_ / "sar.scr";
  EXPECT_THAT(refusal(), HasSubstr("the output would replace the file that it is made from"));
  EXPECT_EQ(folder_.entries(), 1U);
}

TEST_F(FocusWorkflow, ARequestedStopLeavesNoFile) {
  core::StopFlag stop;
  stop.request();
  core::Observer observer;
  observer.stop = &stop;
  request_.output = folder_ / "a.img";
  EXPECT_THROW(static_cast<void>(focus(request_, observer)), core::Interrupted);
  EXPECT_EQ(folder_.entries(), 1U);
}

}  // namespace focus_test
}  // namespace sarsim::workflow
