#include "workflow/focus/focus.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/format/envi.hpp"
#include "scene/language/scene_writer.hpp"
#include "workflow/focus/air_remarks.hpp"
#include "workflow/focus/focus_test_script.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace focus_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A script with one target in the middle of half a second of flight, as a program without a command line has it.
class FocusWorkflow : public FocusOfScript {
 protected:
  FocusWorkflow() : FocusOfScript(sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25)) {}

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(focus(request_, {}));
    } catch (const core::InvalidRequest& refused) {
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

// About a sample that is no number neither peak nor noise mean anything: no target is "not found" by it.
TEST_F(FocusWorkflow, AnImageWithoutSomeOfItsSamplesIsNotMeasured) {
  request_.output = folder_ / "a.img";
  const signal::FocusedImage image = signal::in_memory(focus(request_, {}).image);
  const std::size_t columns = image.range.count;
  const std::size_t row = image.azimuth.count / 2;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::fstream file(request_.output, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(8 * (row * columns + columns / 2)));
  file.write(reinterpret_cast<const char*>(&nan), sizeof(nan));
  file.close();
  try {
    static_cast<void>(measure(of_image(), {}));
    FAIL();
  } catch (const core::InvalidRequest& refused) {
    EXPECT_NE(refused.problems.at(0).message.find("not finite numbers"), std::string::npos);
    EXPECT_EQ(refused.problems.at(0).found,
              fmt::format("1, the first in row {}, column {} (from 0)", row, columns / 2));
  }
}

TEST_F(FocusWorkflow, ImagesHaveTheEndingsOfTheirFormats) {
  for (const char* const name : {"a.mat", "a.dat", "a.cphd", "a.ras", "a.foo"}) {
    request_.output = folder_ / name;
    EXPECT_THROW(static_cast<void>(focus(request_, {})), core::InvalidRequest) << name;
    EXPECT_FALSE(fs::exists(request_.output));
  }
  request_.output = folder_ / "plain";  // ENVI
  static_cast<void>(focus(request_, {}));
  EXPECT_TRUE(fs::exists(folder_ / "plain.hdr"));
}

// The image says with which values it was made, so that `measure` compares with the target where it was.
TEST_F(FocusWorkflow, AnImageOfOtherValuesIsMeasuredAgainstThem) {
  request_.output = folder_ / "a.img";
  request_.input.overrides.settings = {"Target1.x=7m", "Target1.y=-9m"};
  static_cast<void>(focus(request_, {}));
  const MeasureReport report = measure(of_image(), {});
  EXPECT_EQ(report.origin.settings, "--set Target1.x=7m --set Target1.y=-9m");
  EXPECT_TRUE(report.problems.empty());
  ASSERT_EQ(report.targets.size(), 1U);
  ASSERT_TRUE(report.targets.front().found);
  EXPECT_NEAR(report.targets.front().found->place.azimuth_m, report.targets.front().theory.place.azimuth_m, 0.05);
  request_.input.overrides = {};
  request_.force = true;
  static_cast<void>(focus(request_, {}));
  EXPECT_GT(std::abs(measure(of_image(), {}).targets.front().theory.place.azimuth_m -
                     report.targets.front().theory.place.azimuth_m),
            5.0);
}

// The mean over all pulses of matched filters leaves k T/Tp over their number of the noise, and no image less. (More
// where the band of Doppler frequencies that is focused is wider than the flight fills, as here.)
TEST_F(FocusWorkflow, MeasuringTellsNoiseFromTargets) {
  request_.output = folder_ / "a.img";
  request_.force = true;
  const auto measured = [&](double temperature_k) {
    scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25);
    scene.radars[0].noise_temperature_k = temperature_k;
    write(scene);
    static_cast<void>(focus(request_, {}));
    return measure(of_image(), {}).targets.front();
  };
  const MeasuredTarget quiet = measured(0.0);
  ASSERT_TRUE(quiet.found);
  const scene::Radar radar = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25).radars[0];
  const double cells = radar.pulse_width_s * 620.0 * 0.5;
  const double temperature_k = quiet.theory.amplitude * quiet.theory.amplitude * cells / core::boltzmann_j_per_k;
  const MeasuredTarget clear = measured(1e-3 * temperature_k);
  ASSERT_TRUE(clear.found);
  EXPECT_LT(clear.expected_snr_db(), 31.0);
  EXPECT_GT(clear.expected_snr_db(), 20.0);
  EXPECT_NEAR(clear.snr_db(), clear.expected_snr_db(), 1.5);
  const MeasuredTarget lost = measured(10.0 * temperature_k);
  EXPECT_FALSE(lost.found);
  EXPECT_NEAR(lost.expected_snr_db(), clear.expected_snr_db() - 40.0, 1.0);
  EXPECT_GT(lost.peak_v, 0.0);
  EXPECT_LT(lost.snr_db(), 10.0 * std::log10(lost.threshold));
  EXPECT_GT(lost.threshold, 5.0);
}

// Whatever phases it finds in noise, they make no image.
TEST_F(FocusWorkflow, AutofocusFailsOnNoise) {
  request_.autofocus = true;
  for (const unsigned seed : {1U, 2U, 3U}) {
    // A target of which nothing is seen, so that there is something to focus.
    scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25);
    scene.targets[0].rcs_m2 = 1e-12;
    scene.radars[0].noise_temperature_k = 290.0;
    scene.options.seed = seed;
    write(scene);
    const FocusReport report = focus(request_, {});
    ASSERT_TRUE(report.autofocus);
    EXPECT_FALSE(report.autofocus->applied)
        << seed << ": " << report.autofocus->point_gain_db << " dB, " << report.autofocus->rms_rad << " rad";
  }
}

TEST_F(FocusWorkflow, MeasuringSumsUpAndWritesTables) {
  request_.output = folder_ / "a.img";
  static_cast<void>(focus(request_, {}));
  const MeasureReport report = measure(of_image(), {});
  const MeasureSummary sum = summary_of(report);
  EXPECT_EQ(sum.expected, 1U);
  EXPECT_EQ(sum.found, 1U);
  EXPECT_EQ(sum.lowest_amplitude_db, report.targets[0].amplitude_error_db());
  EXPECT_EQ(sum.highest_phase_rad, report.targets[0].phase_error_rad());
  const std::string table = csv_of(report);
  EXPECT_EQ(std::ranges::count(table, '\n'), 2);
  const std::string names = table.substr(0, table.find('\n'));
  const std::string line = table.substr(names.size() + 1);
  EXPECT_EQ(std::ranges::count(names, ','), std::ranges::count(line, ','));
  EXPECT_THAT(line, testing::StartsWith("1,1,"));
  MeasureRequest wrong = of_image();
  wrong.false_alarm = 0.0;
  EXPECT_THROW(static_cast<void>(measure(wrong, {})), core::InvalidRequest);
}

TEST_F(FocusWorkflow, MeasuringRefusesTargetsThatAreNotThereAndPicturesThatAre) {
  request_.output = folder_ / "a.img";
  static_cast<void>(focus(request_, {}));
  MeasureRequest request = of_image();
  request.target = 2;
  EXPECT_THROW(static_cast<void>(measure(request, {})), core::InvalidRequest);
  request.target = 1;
  request.pictures = folder_.path();
  EXPECT_EQ(measure(request, {}).targets.front().picture, folder_ / "target-1.png");
  std::ofstream(folder_ / "target-1.png") << "a picture";
  EXPECT_THROW(static_cast<void>(measure(request, {})), core::InvalidRequest);
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

// What the remark says is where the target then lies.
TEST_F(FocusWorkflow, SaysHowFarTheAtmosphereShiftsTargets) {
  scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25);
  EXPECT_TRUE(diagnose_air(*shared_acquisition(scene)).empty());
  scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
  const core::Problems remarks = diagnose_air(*shared_acquisition(scene));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0].severity, core::Severity::note);
  // 1e-6 N0 times the mean of exp(-h/H) over the heights up to 2000 m, on 10.198 km: 2.81 m.
  const double height_m = 2000.0, scale_m = scene.atmosphere.scale_height_m;
  const double mean = scale_m / height_m * (1.0 - std::exp(-height_m / scale_m));
  const double excess_m = 1e-6 * scene.atmosphere.refractivity * mean * std::hypot(10e3, height_m);
  EXPECT_THAT(remarks[0].found, testing::StartsWith(fmt::format("{:.3g} m of excess path", excess_m)));
  const fs::path file = folder_ / "air.toml";
  std::ofstream(file) << scene::write_format_2(scene);
  request_.input.path = file.string();
  const FocusReport report = focus(request_, {});
  EXPECT_THAT(report.problems, testing::Contains(testing::Field(&core::Problem::message, remarks[0].message)));
  const signal::FocusedImage image = signal::in_memory(report.image);
  const signal::ImagePlace place = signal::place_of(image.frame, {});
  const auto found = signal::measure_point(image, signal::reader_of(image), place, 6.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place.range_m - place.range_m, excess_m, 0.15);
}

TEST_F(FocusWorkflow, RefusesWhatContradictsItself) {
  request_.grid = FocusGrid::ground;
  EXPECT_THAT(refusal(), HasSubstr("--grid ground needs an algorithm"));
  request_.grid = FocusGrid::slant;
  request_.autofocus_phase = folder_ / "phase.csv";
  EXPECT_THAT(refusal(), HasSubstr("are options of --autofocus"));
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
