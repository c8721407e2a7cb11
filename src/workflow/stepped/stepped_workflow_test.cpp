#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/format/envi.hpp"
#include "scene/script/writer.hpp"
#include "support/test_folder.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/profiles.hpp"
#include "workflow/stepped/stepped_test_scene.hpp"

// The workflows of stepped carriers as a program without a command line calls them.
namespace sarsim::workflow {
namespace stepped_workflow_test {

using test::TestFolder;
using testing::HasSubstr;

std::string refusal_of_stepped(const auto& work) {
  try {
    work();
  } catch (const core::InvalidRequest& refused) {
    std::string text;
    for (const core::Problem& problem : refused.problems) text += core::to_string(problem) + "\n";
    return text;
  }
  return "not refused";
}

class SteppedWorkflow : public testing::Test {
 protected:
  // Two points that rest, or turn by 60 degrees a second.
  [[nodiscard]] std::string script(double end_s, bool turning) const {
    scene::Scene scene = stepped_scene(end_s);
    scene.platforms.push_back(simulate::resting("Ship", {0.0, 3000.0, 0.0}));
    if (turning) scene.platforms.back().rotation_rate = {core::Angle{}, core::Angle{}, core::Angle::from_deg(60.0)};
    scene.targets.push_back(simulate::target_on("Ship", {0.0, 0.0, 0.0}, 4.0));
    scene.targets.push_back(simulate::target_on("Ship", {0.0, 6.0, 0.0}, 1.0));
    return test::put(folder_ / "ship.scr", scene::write_script(scene)).string();
  }
  [[nodiscard]] ProfilesRequest profiles_request() const {
    ProfilesRequest request;
    request.input.path = script(0.05, false);
    request.output = folder_ / "ship.csv";
    request.threads = 2;
    return request;
  }
  [[nodiscard]] IsarRequest isar_request() const {
    IsarRequest request;
    request.input.path = script(0.4, true);
    request.output = folder_ / "ship.img";
    request.threads = 2;
    return request;
  }

  TestFolder folder_;
};

TEST_F(SteppedWorkflow, ProfilesShowBothPointsWhereTheyAre) {
  std::map<std::string, std::size_t> stages;
  core::Problems told;
  core::Observer observer;
  observer.progress = [&](const std::string& stage, const core::Progress&) { ++stages[stage]; };
  observer.remark = [&](const core::Problems& problems) { told = problems; };
  ProfilesRequest request = profiles_request();
  request.threads = 1;  // Of several, another than the one that tells may take all the rows.
  const ProfilesReport report = profiles(request, observer);
  EXPECT_THAT(report.files, testing::ElementsAre(folder_ / "ship.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "ship.csv"));
  EXPECT_THAT(stages, testing::ElementsAre(testing::Key((folder_ / "ship.csv").string())));
  EXPECT_EQ(told.size(), report.problems.size());
  EXPECT_EQ(report.bursts, 6U);
  EXPECT_EQ(report.series.rows.size(), 6U);
  EXPECT_EQ(report.series.scans.size(), 1U);
  ASSERT_EQ(report.targets.size(), 2U);
  for (const HeldTarget& target : report.targets) {
    ASSERT_TRUE(target.found);
    // 160 MHz resolve 0.94 m.
    EXPECT_NEAR(target.found->range_m, target.expected_m, 0.1);
  }
  ASSERT_GE(report.peaks.size(), 2U);
  EXPECT_NEAR(report.peaks[0].range_m, 3000.0, 0.1);
}

// The radar is abeam, at -90 degrees, and the ship turns away by 60 degrees a second.
TEST_F(SteppedWorkflow, ProfilesSayFromWhereTheShipWasSeen) {
  ProfilesRequest request = profiles_request();
  request.input.path = script(0.4, true);
  request.output = folder_ / "ship.img";
  static_cast<void>(profiles(request, {}));
  const auto [image, problems] = raster::EnviImage::open((folder_ / "ship.img").string());
  ASSERT_TRUE(image);
  const auto numbers = [&](const char* key) {
    std::istringstream words(image->header().field(key).value_or(""));
    std::vector<double> list;
    for (std::string word; std::getline(words, word, ',');) list.push_back(std::stod(word));
    return list;
  };
  const std::vector<double> times = numbers("time s");
  const std::vector<double> aspects = numbers("aspect deg");
  ASSERT_GT(times.size(), 40U);
  ASSERT_EQ(aspects.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(aspects[i], -90.0 + 60.0 * times[i], 1e-9);
}

TEST_F(SteppedWorkflow, ProfilesNameTheirWindowAndVelocityAsTheyWereAskedFor) {
  ProfilesRequest request = profiles_request();
  request.output = folder_ / "ship.img";
  request.window = signal::window_from_text("hamming");
  request.velocity = velocity_choice("Scene");
  request.set = ProfileGrouping::scans;
  const ProfilesReport report = profiles(request);
  EXPECT_EQ(report.velocity, SeriesOptions::Velocity::scene);
  const std::string header = test::contents(folder_ / "ship.hdr");
  EXPECT_THAT(header, HasSubstr("window = {hamming}"));
  EXPECT_THAT(header, HasSubstr("velocity = {Scene}"));
  EXPECT_THAT(header, HasSubstr("lines = 1\n"));
  request.replace = true;
  request.window = signal::window_from_text("Hanning");
  (void)profiles(request);
  EXPECT_THAT(test::contents(folder_ / "ship.hdr"), HasSubstr("window = {hann}"));
}

TEST_F(SteppedWorkflow, ProfilesRefuseBeforeAnythingIsWritten) {
  const auto refused = [&](const auto& change) {
    ProfilesRequest request = profiles_request();
    change(request);
    return refusal_of_stepped([&] { (void)profiles(request); });
  };
  EXPECT_THAT(refused([](ProfilesRequest& r) { r.align = true; }), HasSubstr("--align moves profiles by the speed"));
  EXPECT_THAT(refused([](ProfilesRequest& r) { r.fastest_mps = 0.0; }), HasSubstr("--fastest: 0 m/s is out of range"));
  EXPECT_THAT(refused([](ProfilesRequest& r) { r.illumination_db = -1.0; }), HasSubstr("--illumination"));
  EXPECT_THAT(refused([](ProfilesRequest& r) { r.oversampling = 0; }), HasSubstr("needs a bin"));
  EXPECT_THAT(refused([](ProfilesRequest& r) { r.burst = 6; }), HasSubstr("burst 7 is not illuminated"));
  EXPECT_THAT(refused([](ProfilesRequest& r) { r.from_m = 4000.0, r.to_m = 4010.0; }),
              HasSubstr("nothing was recorded"));
  EXPECT_EQ(folder_.entries(), 1U);
  EXPECT_THROW((void)velocity_choice("fast"), core::InvalidRequest);
  EXPECT_EQ(velocity_choice("-12.5").speed_mps, -12.5);
}

TEST_F(SteppedWorkflow, IsarPutsBothPointsInTheirPlaces) {
  IsarRequest request = isar_request();
  request.magnitude = true;
  request.options.algorithm = IsarOptions::Algorithm::back_projection;  // Exact for any turning.
  request.options.range_m = request.options.cross_range_m = 20.0;
  const IsarReport report = isar(request);
  EXPECT_EQ(report.algorithm, "isar-back-projection");
  EXPECT_THAT(report.files, testing::ElementsAre(folder_ / "ship.img", folder_ / "ship.hdr",
                                                 folder_ / "ship-magnitude.img", folder_ / "ship-magnitude.hdr"));
  for (const auto& file : report.files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  ASSERT_EQ(report.images.size(), 1U);
  EXPECT_EQ(report.images[0].first_burst, 0U);
  EXPECT_EQ(report.images[0].bursts, 50U);
  const IsarImage& image = report.images[0].image;
  EXPECT_TRUE(image.image.values.empty());
  EXPECT_NEAR(image.turn_rad, 0.4 * core::pi / 3.0, 0.02);
  ASSERT_EQ(image.points.size(), 2U);
  for (const HeldPoint& point : image.points) {
    ASSERT_TRUE(point.found);
    EXPECT_NEAR(point.found->place.range_m, point.expected.range_m, image.range_resolution_m);
    EXPECT_NEAR(point.found->place.azimuth_m, point.expected.azimuth_m, image.cross_range_resolution_m);
  }
}

TEST_F(SteppedWorkflow, IsarNumbersSeveralImages) {
  IsarRequest request = isar_request();
  request.bursts = 20;
  request.options.range_m = request.options.cross_range_m = 20.0;
  const IsarReport report = isar(request);
  EXPECT_EQ(report.algorithm, "isar-range-doppler");
  ASSERT_EQ(report.images.size(), 2U);
  EXPECT_EQ(report.images[1].file, folder_ / "ship-2.img");
  EXPECT_EQ(report.images[1].first_burst, 20U);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "ship-2.hdr"));
}

TEST_F(SteppedWorkflow, IsarRefusesBeforeAnythingIsWritten) {
  const auto refused = [&](const auto& change) {
    IsarRequest request = isar_request();
    change(request);
    return refusal_of_stepped([&] { (void)isar(request); });
  };
  EXPECT_THAT(refused([](IsarRequest& r) { r.options.turn_rate_radps = 0.0; }), HasSubstr("without rotation"));
  EXPECT_THAT(refused([](IsarRequest& r) {
                r.options.algorithm = IsarOptions::Algorithm::back_projection;
                r.options.motion = IsarOptions::Motion::estimated;
              }),
              HasSubstr("back-projection needs the path"));
  EXPECT_THAT(refused([](IsarRequest& r) { r.options.oversampling = 0; }), HasSubstr("needs a pixel"));
  EXPECT_THAT(refused([](IsarRequest& r) { r.platform = "Shop"; }), HasSubstr("did you mean 'Ship'?"));
  EXPECT_THAT(refused([](IsarRequest& r) { r.platform = "Earth"; }), HasSubstr("carries the radar itself"));
  EXPECT_THAT(refused([](IsarRequest& r) { r.bursts = 51; }), HasSubstr("an image takes 2 to 50 bursts"));
  EXPECT_THAT(refused([&](IsarRequest& r) { r.magnitude = true, r.output = folder_ / "a.h5"; }),
              HasSubstr("--magnitude makes ENVI images"));
  EXPECT_EQ(folder_.entries(), 1U);
}

}  // namespace stepped_workflow_test
}  // namespace sarsim::workflow
