#include "simulate/sar_ghosts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulate/sar_test_scene.hpp"

namespace sarsim {
namespace {

TEST(SarTargets, AreWhereAndAsStrongAsTheImageShowsThem) {
  const auto [plan, rows] = sar_recording(sar_scene(600.0, {{3.0, -31.0, 0.0}}));
  const SarTarget target = sar_targets(*plan, rows).at(0);
  const PointResponse response = focused_point(rows, target.place);
  EXPECT_NEAR(response.place.azimuth_m, target.place.azimuth_m, 0.015);
  EXPECT_NEAR(response.place.range_m, target.place.range_m, 0.03);
  EXPECT_NEAR(response.amplitude, target.amplitude, 0.01 * target.amplitude);
  EXPECT_TRUE(target.in_swath);
}

TEST(SarTargets, AreDisplacedWhereTheyMove) {
  Scene scene = sar_scene(600.0, {});
  scene.platforms.push_back(moving("Car", {0.0, 10.0, 0.0}, {2.0, 0.0, 0.0}));
  scene.targets.push_back(target_on("Car", {}));
  const auto [plan, rows] = sar_recording(scene);
  const SarTarget target = sar_targets(*plan, rows).at(0);
  const double recession = 2.0 * 10000.0 / std::hypot(10000.0, 2000.0);
  EXPECT_NEAR(target.place.azimuth_m, 10.0 - std::hypot(10000.0, 2000.0) * recession / 200.0, 0.5);
  const PointResponse response = focused_point(rows, target.place);
  EXPECT_NEAR(response.place.azimuth_m, target.place.azimuth_m, 0.1);
}

TEST(SarTargets, AreOutOfTheSwathWhereTheirEchoesLeaveIt) {
  const auto [plan, rows] = sar_recording(sar_scene(600.0, {{400.0, 0.0, 0.0}, {}}, 0.1));
  const std::vector<SarTarget> targets = sar_targets(*plan, rows);
  EXPECT_FALSE(targets[0].in_swath);
  EXPECT_TRUE(targets[1].in_swath);
}

TEST(SarGhosts, AreNoneWhereThePulsesSampleEverything) {
  const auto [plan, rows] = sar_recording(sar_scene(600.0, {{0.0, 190.0, 0.0}, {0.0, -190.0, 0.0}}));
  EXPECT_TRUE(sar_ghosts(*plan, rows, 0.0).empty());
}

// Of an image, within some distance of a place.
double energy(const FocusedImage& image, const ImagePlace& place, double azimuth_m, double range_m) {
  double sum = 0.0;
  for (std::size_t r = 0; r < image.azimuth.count; ++r)
    for (std::size_t c = 0; c < image.range.count; ++c) {
      const bool near = std::abs(image.azimuth.at(static_cast<double>(r)) - place.azimuth_m) < azimuth_m &&
                        std::abs(image.range.at(static_cast<double>(c)) - place.range_m) < range_m;
      if (near) sum += std::norm(std::complex<double>(image.values[r * image.range.count + c]));
    }
  return sum;
}

TEST(SarGhosts, AppearInTheImageWhereTheyArePredicted) {
  // At 300 Hz a point 205 m ahead of the middle reaches 281 Hz: above 150 Hz it wraps around.
  const auto [plan, rows] = sar_recording(sar_scene(300.0, {{0.0, 205.0, 0.0}}));
  const std::vector<SarGhost> ghosts = sar_ghosts(*plan, rows, 0.0);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_EQ(ghosts[0].folds, 1);
  EXPECT_NEAR(ghosts[0].place.azimuth_m, 205.0 - 300.0 * 0.056565 * 10198.0 / 400.0, 1.0);
  const SarTarget target = sar_targets(*plan, rows).at(0);
  const SarEchoes echoes = sar_echoes(rows, {.threads = 2});
  const FocusedImage image = focus(echoes, {.method = FocusMethod::chirp_scaling}, {.threads = 2});
  ASSERT_LT(image.azimuth.first_m, ghosts[0].place.azimuth_m);
  const double ghost = energy(image, ghosts[0].place, 0.5 * ghosts[0].azimuth_m + 8.0, 0.5 * ghosts[0].range_m + 8.0);
  const double truth = energy(image, target.place, 12.0, 12.0);
  EXPECT_NEAR(ghost / (ghost + truth), ghosts[0].share, 0.03);
}

std::string remarks(const Scene& scene, double centroid_hz = 0.0) {
  const auto [plan, rows] = sar_recording(scene);
  std::string text;
  for (const Problem& problem : remarks_on_sar(*plan, rows, centroid_hz)) text += to_string(problem) + "\n";
  return text;
}

TEST(RemarksOnSar, AreNoneForASoundScene) { EXPECT_EQ(remarks(sar_scene(600.0, {{}})), ""); }

TEST(RemarksOnSar, NameTheTargetsThatWrapAround) {
  const std::string text = remarks(sar_scene(300.0, {{0.0, 150.0, 0.0}, {}, {0.0, -150.0, 0.0}}));
  EXPECT_NE(text.find("echoes of 2 of 3 targets (1, 3)"), std::string::npos) << text;
  EXPECT_NE(text.find("ghosts"), std::string::npos) << text;
}

TEST(RemarksOnSar, NameTargetsBeyondTheSwathAndWideBeams) {
  Scene scene = sar_scene(300.0, {{}, {400.0, 0.0, 0.0}}, 0.1);
  scene.radars[0].transmit_antenna.pattern = Antenna::Pattern::sinx;
  scene.radars[0].transmit_antenna.azimuth_beamwidth = Angle::from_deg(30.0);
  scene.radars[0].beam_azimuth = Angle::from_deg(90.0);
  const std::string text = remarks(scene);
  EXPECT_NE(text.find("1 of 2 targets (2) leave the recorded ranges"), std::string::npos) << text;
  EXPECT_NE(text.find("Doppler band of 3661 Hz"), std::string::npos) << text;
}

}  // namespace
}  // namespace sarsim
