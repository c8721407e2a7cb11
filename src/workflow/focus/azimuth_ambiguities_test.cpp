#include "workflow/focus/azimuth_ambiguities.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace sar_ghosts_test {

TEST(SarTargets, AreWhereAndAsStrongAsTheImageShowsThem) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{3.0, -31.0, 0.0}}));
  const SarTarget target = sar_targets(*acquisition, rows).at(0);
  const signal::PointResponse response = focused_point(rows, target.place);
  EXPECT_NEAR(response.place.azimuth_m, target.place.azimuth_m, 0.015);
  EXPECT_NEAR(response.place.range_m, target.place.range_m, 0.03);
  EXPECT_NEAR(response.amplitude, target.amplitude, 0.01 * target.amplitude);
  EXPECT_TRUE(target.in_swath);
}

TEST(SarTargets, AreDisplacedWhereTheyMove) {
  scene::Scene scene = sar_scene(600.0, {});
  scene.platforms.push_back(simulate::moving("Car", {0.0, 10.0, 0.0}, {2.0, 0.0, 0.0}));
  scene.targets.push_back(simulate::target_on("Car", {}));
  const auto [acquisition, rows] = sar_recording(scene);
  const SarTarget target = sar_targets(*acquisition, rows).at(0);
  const double recession = 2.0 * 10000.0 / std::hypot(10000.0, 2000.0);
  EXPECT_NEAR(target.place.azimuth_m, 10.0 - std::hypot(10000.0, 2000.0) * recession / 200.0, 0.5);
  const signal::PointResponse response = focused_point(rows, target.place);
  EXPECT_NEAR(response.place.azimuth_m, target.place.azimuth_m, 0.1);
}

TEST(SarTargets, AreOutOfTheSwathWhereTheirEchoesLeaveIt) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{400.0, 0.0, 0.0}, {}}, 0.1));
  const std::vector<SarTarget> targets = sar_targets(*acquisition, rows);
  EXPECT_FALSE(targets[0].in_swath);
  EXPECT_TRUE(targets[1].in_swath);
}

TEST(AzimuthAmbiguities, AreNoneWhereThePulsesSampleEverything) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{0.0, 190.0, 0.0}, {0.0, -190.0, 0.0}}));
  EXPECT_TRUE(sar_ghosts(*acquisition, rows, {}).empty());
}

// Of an image, within some distance of a place.
double energy(const signal::FocusedImage& image, const signal::ImagePlace& place, double azimuth_m, double range_m) {
  double sum = 0.0;
  for (std::size_t r = 0; r < image.azimuth.count; ++r)
    for (std::size_t c = 0; c < image.range.count; ++c) {
      const bool near = std::abs(image.azimuth.at(static_cast<double>(r)) - place.azimuth_m) < azimuth_m &&
                        std::abs(image.range.at(static_cast<double>(c)) - place.range_m) < range_m;
      if (near) sum += std::norm(std::complex<double>(image.values[r * image.range.count + c]));
    }
  return sum;
}

TEST(AzimuthAmbiguities, AppearInTheImageWhereTheyArePredicted) {
  // At 300 Hz a point 205 m ahead of the middle reaches 281 Hz: above 150 Hz it wraps around.
  const auto [acquisition, rows] = sar_recording(sar_scene(300.0, {{0.0, 205.0, 0.0}}));
  const std::vector<AzimuthAmbiguity> ghosts = sar_ghosts(*acquisition, rows, {});
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_EQ(ghosts[0].folds, 1);
  EXPECT_NEAR(ghosts[0].place.azimuth_m, 205.0 - 300.0 * 0.056565 * 10198.0 / 400.0, 1.0);
  const SarTarget target = sar_targets(*acquisition, rows).at(0);
  const signal::SarEchoes echoes = signal::sar_echoes(rows, {.threads = 2});
  const signal::FocusedImage image =
      signal::focus(echoes, {.method = signal::FocusMethod::chirp_scaling}, {.threads = 2});
  ASSERT_LT(image.azimuth.first_m, ghosts[0].place.azimuth_m);
  const double ghost = energy(image, ghosts[0].place, 0.5 * ghosts[0].azimuth_m + 8.0, 0.5 * ghosts[0].range_m + 8.0);
  const double truth = energy(image, target.place, 12.0, 12.0);
  EXPECT_NEAR(ghost / (ghost + truth), ghosts[0].share, 0.03);
}

std::string remarks(const scene::Scene& scene, const DopplerBand& kept = {},
                    AmbiguitiesIn image = AmbiguitiesIn::frequency) {
  const auto [acquisition, rows] = sar_recording(scene);
  std::string text;
  for (const core::Problem& problem : diagnose_sar(*acquisition, rows, kept, image))
    text += core::to_string(problem) + "\n";
  return text;
}

TEST(RemarksOnSar, AreNoneForASoundScene) { EXPECT_EQ(remarks(sar_scene(600.0, {{}})), ""); }

TEST(RemarksOnSar, NameTheTargetsThatWrapAround) {
  const std::string text = remarks(sar_scene(300.0, {{0.0, 150.0, 0.0}, {}, {0.0, -150.0, 0.0}}));
  EXPECT_NE(text.find("echoes of 2 of 3 targets (1, 3)"), std::string::npos) << text;
  EXPECT_NE(text.find("azimuth ambiguities"), std::string::npos) << text;
}

// An image by back-projection that is right is not warned of for a ghost of a few per cent somewhere else.
TEST(RemarksOnSar, OfBackProjectionSayNothingOfPeaks) {
  const std::string large = remarks(sar_scene(300.0, {{0.0, 150.0, 0.0}}), {}, AmbiguitiesIn::time);
  EXPECT_NE(large.find("warning: echoes of 1 of 1 targets (1)"), std::string::npos) << large;
  EXPECT_EQ(large.find("peaks lose"), std::string::npos) << large;
  const std::string small = remarks(sar_scene(300.0, {{0.0, 40.0, 0.0}}), {}, AmbiguitiesIn::time);
  EXPECT_NE(small.find("note: echoes of 1 of 1 targets (1)"), std::string::npos) << small;
  EXPECT_EQ(remarks(sar_scene(300.0, {{0.0, 150.0, 0.0}}), {}, AmbiguitiesIn::circle), "");
}

TEST(RemarksOnSar, NameTargetsBeyondTheSwathAndWideBeams) {
  scene::Scene scene = sar_scene(300.0, {{}, {400.0, 0.0, 0.0}}, 0.1);
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  scene.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(30.0);
  scene.radars[0].beam_azimuth = core::Angle::from_deg(90.0);
  const std::string text = remarks(scene);
  EXPECT_NE(text.find("1 of 2 targets (2) are never within the recorded ranges"), std::string::npos) << text;
  EXPECT_NE(text.find("Doppler band of 3661 Hz"), std::string::npos) << text;
}

TEST(RemarksOnSar, AreSilencedByABandIntoWhichNothingFolds) {
  // From 50 to 250 m behind it: 35 to 173 Hz, of which 300 pulses a second fold those above 150 Hz to -150 ... -127 Hz.
  const scene::Scene scene = sar_scene(300.0, {{0.0, 150.0, 0.0}}, 0.5);
  EXPECT_NE(remarks(scene), "");
  EXPECT_NE(remarks(scene, {.width_hz = 280.0}), "");
  EXPECT_EQ(remarks(scene, {.width_hz = 240.0}), "");
}

TEST(RemarksOnSar, NameTargetsWhoseEchoesTheEndOfARawRecordingCuts) {
  // 40 m before the end of the window, of which the last 120 m can be compressed in part alone.
  const scene::Scene scene = sar_scene(600.0, {{60.0, 0.0, 0.0}, {-60.0, 0.0, 0.0}}, 0.1);
  const auto acquisition = shared_acquisition(scene);
  const signal::EchoRows recorded = sar_rows_of_recording(
      acquisition,
      {acquisition->timing.rows, acquisition->reception.columns, [](std::size_t, std::span<std::complex<double>>) {}});
  const std::vector<SarTarget> targets = sar_targets(*acquisition, recorded);
  EXPECT_TRUE(targets[0].in_swath);
  EXPECT_FALSE(targets[0].whole);
  EXPECT_TRUE(targets[1].whole);
  const core::Problems problems = diagnose_sar(*acquisition, recorded, {}, AmbiguitiesIn::frequency);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].message.find("1 of 2 targets (1) are within a pulse length of the end"), std::string::npos)
      << problems[0].message;
  // 41 of 120 m of the echo are left.
  EXPECT_NE(problems[0].message.find("; the peak of target 1 loses 9."), std::string::npos) << problems[0].message;
  const double lost_db = -20.0 * std::log10(targets[0].kept);
  const double whole = sar_targets(*acquisition, sar_recording(scene).second).at(0).amplitude;
  const double found = focused_point(stored(scene).second, targets[0].place).amplitude;
  EXPECT_NEAR(-20.0 * std::log10(found / whole), lost_db, 0.2);
  EXPECT_EQ(remarks(scene), "");
}

// Some pulses see a point beyond the window's end: its peak is that of the rest.
TEST(RemarksOnSar, SayWhatIsLostOfTargetsThatLeaveTheRecordedRanges) {
  scene::Scene scene;
  std::vector<SarTarget> targets;
  for (double x_m = 98.0; x_m < 102.0 && (targets.empty() || targets[1].kept > 0.8); x_m += 0.2) {
    scene = sar_scene(600.0, {{}, {x_m, 0.0, 0.0}});
    const auto [acquisition, rows] = sar_recording(scene);
    targets = sar_targets(*acquisition, rows);
  }
  const signal::EchoRows rows = sar_recording(scene).second;
  ASSERT_FALSE(targets[1].in_swath);
  ASSERT_TRUE(targets[1].recorded);
  EXPECT_EQ(targets[0].kept, 1.0);
  const double found = focused_point(rows, targets[1].place).amplitude;
  const double lost_db = -20.0 * std::log10(targets[1].kept);
  EXPECT_GT(lost_db, 0.5);
  EXPECT_NEAR(-20.0 * std::log10(found / targets[1].amplitude), lost_db, 0.1 + 0.2 * lost_db);
  const std::string text = remarks(scene);
  EXPECT_NE(text.find("1 of 2 targets (2) leave the recorded ranges for some pulses"), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("; the peak of target 2 loses {:.2g} dB", lost_db)), std::string::npos) << text;
}

TEST(SarTargets, AreTheSameForAnyNumberOfThreads) {
  std::vector<core::Vec3> points;
  for (int i = 0; i < 50; ++i) points.push_back({static_cast<double>(i), 4.0 * i, 0.0});
  const auto [acquisition, rows] = sar_recording(sar_scene(300.0, points, 0.3));
  const std::vector<SarTarget> one = sar_targets(*acquisition, rows, {.threads = 1});
  const std::vector<SarTarget> three = sar_targets(*acquisition, rows, {.threads = 3});
  ASSERT_EQ(one.size(), 50U);
  for (std::size_t t = 0; t < one.size(); ++t) {
    EXPECT_EQ(one[t].target, t);
    EXPECT_EQ(one[t].amplitude, three[t].amplitude);
    EXPECT_EQ(one[t].place.azimuth_m, three[t].place.azimuth_m);
  }
  const auto ghosts = sar_ghosts(*acquisition, rows, {}, {.threads = 1});
  const auto same = sar_ghosts(*acquisition, rows, {}, {.threads = 3});
  ASSERT_EQ(ghosts.size(), same.size());
  ASSERT_FALSE(ghosts.empty());
  for (std::size_t i = 0; i < ghosts.size(); ++i) EXPECT_EQ(ghosts[i].share, same[i].share);
}

TEST(SarTargets, EndWhenAskedTo) {
  const auto [acquisition, rows] = sar_recording(sar_scene(300.0, {{}}, 0.3));
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)sar_targets(*acquisition, rows, {.threads = 2, .stop = &stop}), core::Interrupted);
  EXPECT_THROW((void)diagnose_sar(*acquisition, rows, {}, AmbiguitiesIn::frequency, {.threads = 2, .stop = &stop}),
               core::Interrupted);
}

}  // namespace sar_ghosts_test
}  // namespace sarsim::workflow
