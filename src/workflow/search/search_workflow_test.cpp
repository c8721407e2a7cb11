#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "scene/script/writer.hpp"
#include "support/test_folder.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"
#include "workflow/search/search_test_scene.hpp"

// The workflows of pulses as a program without a command line calls them.
namespace sarsim::workflow {
namespace search_workflow_test {

using test::TestFolder;
using testing::HasSubstr;

// What a workflow told whom it was watched by.
struct Heard {
  std::map<std::string, std::size_t> stages;  // how often
  core::Problems problems;

  core::Observer observer(const core::StopFlag* stop = nullptr) {
    core::Observer observer;
    observer.progress = [this](const std::string& stage, const core::Progress&) { ++stages[stage]; };
    observer.remark = [this](const core::Problems& all) { problems = all; };
    observer.stop = stop;
    return observer;
  }
};

std::string refusal_of(const auto& work) {
  try {
    work();
  } catch (const core::InvalidRequest& refused) {
    std::string text;
    for (const core::Problem& problem : refused.problems) text += core::to_string(problem) + "\n";
    return text;
  }
  return "not refused";
}

class PulseWorkflow : public testing::Test {
 protected:
  // A target that recedes with 10 m/s.
  [[nodiscard]] DopplerRequest doppler_request(int pulses = 128) const {
    scene::Scene scene = pulse_scene(10.0, pulses);
    DopplerRequest request;
    request.input.path = test::put(folder_ / "car.scr", scene::write_script(scene)).string();
    request.output = folder_ / "car.img";
    request.threads = 2;
    return request;
  }
  // A beam of 4 degrees that turns once in 500 pulses, about a target in the east.
  [[nodiscard]] SearchRequest search_request() const {
    scene::Scene scene = pulse_scene(0.0, 500);
    scene.platforms[1] = simulate::resting("Car", {5000.0, 0.0, 0.0});
    scene::Radar& radar = scene.radars[0];
    radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
    radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(4.0);
    radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(4.0);
    radar.beam = scene::Radar::Beam::rotating;
    radar.beam_rate = core::Angle::from_deg(360.0 * search_prf_hz / 500.0);
    SearchRequest request;
    request.input.path = test::put(folder_ / "turn.scr", scene::write_script(scene)).string();
    request.output = folder_ / "turn.img";
    request.threads = 2;
    return request;
  }

  TestFolder folder_;
};

TEST_F(PulseWorkflow, DopplerFindsTheCarAtItsSpeed) {
  Heard heard;
  const DopplerRequest request = doppler_request();
  const DopplerReport report = doppler(request, heard.observer());
  EXPECT_EQ(report.source, request.input.path);
  EXPECT_THAT(report.files,
              testing::ElementsAre(folder_ / "car.img", folder_ / "car.hdr", folder_ / "car-detections.csv"));
  for (const auto& file : report.files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(report.intervals, 2U);
  EXPECT_EQ(report.rows, usual_doppler_pulses);
  EXPECT_EQ(report.doppler_step_hz, search_prf_hz / 64.0);
  EXPECT_EQ(report.doppler_first_hz, -search_prf_hz / 2.0);
  // lambda/2 of 10 GHz, and approaching is positive.
  EXPECT_NEAR(report.speed_step_mps, -0.5 * core::exact_light_speed_mps / 10e9 * report.doppler_step_hz, 1e-12);
  EXPECT_NEAR(report.range_first_m + static_cast<double>(report.columns - 1) * report.range_step_m, report.range_last_m,
              1e-6);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "car.img"), 2 * report.rows * report.columns * 8);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].found, 2U);
  ASSERT_TRUE(report.findings[0].best);
  EXPECT_NEAR(report.findings[0].best->speed_mps, 10.0, 0.1);
  EXPECT_GE(report.detections, 2U);
  EXPECT_GT(heard.stages[(folder_ / "car.img").string()], 0U);
  EXPECT_EQ(heard.problems.size(), report.problems.size());
}

TEST_F(PulseWorkflow, DopplerMakesMapsOfCountsTwiceForTheirLargestMagnitude) {
  Heard heard;
  DopplerRequest request = doppler_request();
  request.output = folder_ / "car.bin";
  request.detect = false;
  const DopplerReport report = doppler(request, heard.observer());
  EXPECT_THAT(report.files, testing::ElementsAre(folder_ / "car.bin"));
  EXPECT_TRUE(report.table.empty());
  EXPECT_EQ(report.reference_cells, 0U);
  EXPECT_THAT(heard.stages, testing::UnorderedElementsAre(
                                testing::Key(request.output.string()),
                                testing::Key(request.output.string() + " (finding the largest magnitude)")));
}

TEST_F(PulseWorkflow, RefusesBeforeAnythingIsWritten) {
  DopplerRequest request = doppler_request();
  request.false_alarm = 2.0;
  request.rank = 0.5;
  request.pulses = 0;
  request.canceller = 3;
  const std::string text = refusal_of([&] { (void)doppler(request); });
  EXPECT_THAT(text, HasSubstr("--pfa: no probability"));
  EXPECT_THAT(text, HasSubstr("--rank is for the ordered statistic"));
  EXPECT_THAT(text, HasSubstr("a coherent interval has no pulses"));
  EXPECT_THAT(text, HasSubstr("--canceller: there is none of that order"));
  request = doppler_request();
  request.image = request.detect = false;
  EXPECT_THAT(refusal_of([&] { (void)doppler(request); }), HasSubstr("leaves nothing to do"));
  request = doppler_request();
  test::put(folder_ / "car.hdr", "precious");
  EXPECT_THAT(refusal_of([&] { (void)doppler(request); }), HasSubstr("the output exists already"));
  EXPECT_EQ(folder_.entries(), 2U);
  request.replace = true;
  EXPECT_EQ(doppler(request).intervals, 2U);
}

TEST_F(PulseWorkflow, StopsWhereAskedToAndLeavesNothing) {
  core::StopFlag stop;
  stop.request();
  const DopplerRequest request = doppler_request();
  Heard heard;
  EXPECT_THROW((void)doppler(request, heard.observer(&stop)), core::Interrupted);
  EXPECT_EQ(folder_.entries(), 1U);
}

TEST_F(PulseWorkflow, SearchShowsTheTargetInTheEast) {
  Heard heard;
  SearchRequest request = search_request();
  request.picture.pixel_m = 100.0;
  const SearchReport report = search(request, heard.observer());
  ASSERT_TRUE(report.picture);
  EXPECT_EQ(report.picture->scans, 1U);
  EXPECT_EQ(report.picture->grid.pixel_m, 100.0);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "turn.img"),
            report.picture->grid.rows * report.picture->grid.columns * 4);
  // 2 degrees are 2.8 pulses.
  EXPECT_EQ(report.options.pulses, 2U);
  ASSERT_EQ(report.findings.size(), 1U);
  ASSERT_TRUE(report.findings[0].best);
  EXPECT_NEAR(report.findings[0].best->azimuth_rad, 0.5 * core::pi, 2.0 * core::pi / 180.0);
  EXPECT_NEAR(report.findings[0].best->range_m, 5000.0, 15.0);
  EXPECT_GT(heard.stages[(folder_ / "turn.img").string()], 0U);
}

TEST_F(PulseWorkflow, SearchRefusesTurnsThatAreNotMadeAndPartsOfNoPicture) {
  SearchRequest request = search_request();
  request.picture.scan = 1;
  EXPECT_THAT(refusal_of([&] { (void)search(request); }), HasSubstr("--scan 2: fewer turns are recorded"));
  request = search_request();
  request.image = false;
  request.picture.pixel_m = 50.0;
  EXPECT_THAT(refusal_of([&] { (void)search(request); }), HasSubstr("--pixel is for the picture"));
  EXPECT_EQ(folder_.entries(), 1U);
  request.picture.pixel_m.reset();
  const SearchReport report = search(request);
  EXPECT_FALSE(report.picture);
  EXPECT_THAT(report.files, testing::ElementsAre(folder_ / "turn-detections.csv"));
}

TEST(CellsFromText, AreOfRangeAndBehindAColonOfDoppler) {
  ASSERT_TRUE(cells_from_text("16"));
  EXPECT_EQ(cells_from_text("16")->columns, 16U);
  EXPECT_EQ(cells_from_text("16")->rows, 0U);
  EXPECT_EQ(cells_from_text("8:2")->columns, 8U);
  EXPECT_EQ(cells_from_text("8:2")->rows, 2U);
  for (const char* text : {"", "many", "2:-1", ":3", "3:", "100001"}) EXPECT_FALSE(cells_from_text(text)) << text;
}

}  // namespace search_workflow_test
}  // namespace sarsim::workflow
