#include "workflow/focus/movers.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "core/report/invalid_request.hpp"
#include "scene/script/writer.hpp"
#include "support/test_folder.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_options.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace movers_test {

using testing::HasSubstr;

constexpr double recession_mps = 3.0;  // along the slant range: displaces the image by R u/V = 153 m

// A resting target, and one on a car that recedes.
class FocusOfMovers : public testing::Test {
 protected:
  void SetUp() override {
    scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.25);
    scene.platforms.push_back(simulate::moving("Car", {}, {recession_mps * closest_m / 10000.0, 0.0, 0.0}));
    scene.targets.push_back(simulate::target_on("Car", {}));
    std::ofstream(folder_ / "cars.scr") << scene::write_script(scene);
  }

  [[nodiscard]] FocusRequest request(GivenWords words) const {
    words.emplace("--doppler-centroid", "0");
    words.emplace("--threads", "2");
    FocusRequest made = focus_request((folder_ / "cars.scr").string(), words);
    made.output = folder_ / "cars.img";
    made.force = true;
    return made;
  }

  static constexpr double closest_m = 10198.039;
  test::TestFolder folder_;
};

std::string texts_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n" + problem.hint + "\n";
  return text;
}

TEST_F(FocusOfMovers, NamesThemAndWhereTheirImagesAre) {
  const std::string said = texts_of(focus(request({}), {}).problems);
  EXPECT_THAT(said, HasSubstr("1 of 2 targets (2) move or turn with their platform, at up to 3.06 m/s"));
  EXPECT_THAT(said, HasSubstr("displaced by up to 153 m along the track"));
  EXPECT_THAT(said, HasSubstr("the images of moving targets (2) are displaced to azimuths from -153 to -153 m"));
  EXPECT_THAT(said, HasSubstr("--azimuth -163:"));
  const std::string early = texts_of(diagnose_focus(open_focus_input(request({}).input, {})));  // What check says.
  EXPECT_THAT(early, HasSubstr("the images of moving targets (2) are displaced to azimuths from -153 to -153 m"));
  MeasureRequest measured;
  measured.image = folder_ / "cars.img";
  EXPECT_THAT(texts_of(measure(measured, {}).problems), HasSubstr("1 of 2 targets (2) move or turn"));
}

TEST_F(FocusOfMovers, ReachesAsFarAsTheirImagesWhenAsked) {
  for (const char* algorithm : {"omega-k", "range-doppler", "chirp-scaling", "back-projection"}) {
    const FocusReport report =
        focus(request({{"--algorithm", algorithm}, {"--azimuth", "-170:-130"}, {"--range", "10180:10220"}}), {});
    EXPECT_THAT(texts_of(report.problems), testing::Not(HasSubstr("does not reach that far")));
    const signal::ImageAxis& rows = report.image.image.azimuth;
    EXPECT_GE(rows.first_m, -170.0 - 1e-6);
    EXPECT_LE(rows.at(static_cast<double>(rows.count) - 1.0), -130.0 + 1e-6);
    EXPECT_NEAR(static_cast<double>(rows.count) * rows.step_m, 40.0, 2.0 * rows.step_m);
    const signal::FocusedImage image = signal::in_memory(report.image);
    const auto found = signal::measure_point(image, signal::reader_of(image), {-153.0, closest_m}, 5.0);
    ASSERT_TRUE(found) << algorithm;
    EXPECT_NEAR(found->place.azimuth_m, -recession_mps * closest_m / 200.0, 1.0) << algorithm;
  }
}

TEST_F(FocusOfMovers, CutsAnAreaOutOfTheImageThatItWouldMake) {
  const signal::FocusedImage whole = signal::in_memory(focus(request({{"--algorithm", "omega-k"}}), {}).image);
  const signal::FocusedImage part = signal::in_memory(
      focus(request({{"--algorithm", "omega-k"}, {"--azimuth", "-20:10"}, {"--range", "10150:10200"}}), {}).image);
  const auto row = static_cast<std::size_t>(std::llround(whole.azimuth.index_of(part.azimuth.first_m)));
  const auto column = static_cast<std::size_t>(std::llround(whole.range.index_of(part.range.first_m)));
  ASSERT_GT(part.values.size(), 100U);
  for (std::size_t r = 0; r < part.azimuth.count; ++r)
    for (std::size_t c = 0; c < part.range.count; ++c)
      ASSERT_EQ(part.values[r * part.range.count + c], whole.values[(row + r) * whole.range.count + column + c]);
}

TEST_F(FocusOfMovers, RefusesAreasThatAreNone) {
  EXPECT_THROW(static_cast<void>(request({{"--azimuth", "20"}})), core::InvalidRequest);
  EXPECT_THROW(static_cast<void>(request({{"--range", "20:10"}})), core::InvalidRequest);
  EXPECT_THROW(static_cast<void>(focus(request({{"--range", "1:2"}}), {})), core::InvalidRequest);
}

}  // namespace movers_test
}  // namespace sarsim::workflow
