#include "workflow/focus/sar_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "signal/sar/motion_compensation.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/seen_spectrum.hpp"

namespace sarsim::workflow {
namespace sar_theory_test {

void expect_like(const signal::ResponseFigures& found, const signal::ResponseFigures& theory) {
  EXPECT_NEAR(found.width, theory.width, 0.01 * theory.width);
  // Theory takes what folds over the sampled band as in phase with the rest; out of phase it changes 0.04 dB.
  EXPECT_NEAR(found.pslr_db, theory.pslr_db, 0.24);
  EXPECT_NEAR(found.islr_db, theory.islr_db, 0.3);
}

void expect_as_theory(const scene::Scene& scene, const signal::FocusOptions& options) {
  const auto [acquisition, rows] = sar_recording(scene);
  const TargetTheory theory = theory_of_targets(*acquisition, rows, options).at(0);
  const signal::PointResponse response = focused_point(rows, theory.place, options);
  EXPECT_NEAR(response.place.azimuth_m, theory.place.azimuth_m, 0.02);
  EXPECT_NEAR(response.place.range_m, theory.place.range_m, 0.03);
  EXPECT_NEAR(response.amplitude, theory.amplitude, 0.01 * theory.amplitude);
  EXPECT_NEAR(std::remainder(response.phase_rad - theory.phase_rad, 2.0 * core::pi), 0.0, 0.01);
  ASSERT_TRUE(theory.range && theory.azimuth);
  expect_like(response.range, *theory.range);
  expect_like(response.azimuth, *theory.azimuth);
}

TEST(TheoryOfTargets, IsWhatAPlainImageShows) { expect_as_theory(sar_scene(600.0, {{3.0, -31.0, 0.0}}), {}); }

TEST(TheoryOfTargets, IsWhatAnAntennaThatTapersTheEchoesShows) {
  // A beam of 1.5 degrees across track: echoes at both ends of 2.2 degrees of track are much weaker.
  scene::Scene scene = sar_scene(600.0, {{3.0, 0.0, 0.0}});
  scene::Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(1.5);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(30.0);
  radar.beam_azimuth = core::Angle::from_deg(90.0);
  radar.beam_elevation = core::Angle::from_deg(-11.3);
  expect_as_theory(scene, {.method = signal::FocusMethod::chirp_scaling});
}

// Apertures and bands of which the response is no product of one over range and one over azimuth: carriers of 0.4 to
// 1 GHz, 10 to 24 degrees, 5 to 60 MHz. The image leaves out 0.2 % of the echoes at either end of either axis.
TEST(TheoryOfTargets, IsWhatImagesOfWideAperturesShow) {
  std::mt19937 random(20261129);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int draw = 0; draw < 4; ++draw) {
    const double carrier_hz = between(0.4e9, 1e9);
    const double half_rad = between(5.0, 12.0) * core::pi / 180.0;
    const double band_hz = std::exp(between(std::log(5e6), std::log(60e6)));
    const double prf_hz = 1.25 * 4.0 * 200.0 * std::sin(half_rad) * carrier_hz / core::exact_light_speed_mps + 20.0;
    scene::Scene scene =
        sar_scene(prf_hz, {{between(-2.0, 2.0), between(-5.0, 5.0), 0.0}}, std::tan(half_rad) * 10198.0 / 200.0);
    scene.radars[0].carrier_hz = carrier_hz;
    scene.radars[0].bandwidth_hz = band_hz;
    scene.radars[0].pulse_width_s = 120.0 / band_hz;
    scene.simulations[0].sample_rate_hz = 1.4 * band_hz;
    const double spare_m = 12.0 * core::exact_light_speed_mps / band_hz;
    scene.simulations[0].range_start_m = 10198.0 - spare_m;
    scene.simulations[0].range_end_m = 10198.0 / std::cos(half_rad) + spare_m;
    const auto [acquisition, rows] = sar_recording(scene);
    signal::FocusOptions options;
    options.spectrum = seen_spectrum(*acquisition, rows, {}, SeenPulses::sampled);
    const signal::FocusedImage image = signal::focus(signal::sar_echoes(rows, {.threads = 2}), options, {.threads = 2});
    const TargetTheory theory = theory_on_image({*acquisition, rows, options}, image, {.threads = 2}).at(0);
    const auto response = signal::measure_point(image, signal::reader_of(image), theory.place, 3.0);
    ASSERT_TRUE(response && theory.range && theory.azimuth) << draw;
    EXPECT_NEAR(response->range.width, theory.range->width, 0.01 * theory.range->width) << draw;
    EXPECT_NEAR(response->azimuth.width, theory.azimuth->width, 0.01 * theory.azimuth->width) << draw;
    // Side lobes of -25 dB and less change by a decibel where the peak changes by a hundredth.
    EXPECT_NEAR(std::pow(10.0, response->range.pslr_db / 20.0), std::pow(10.0, theory.range->pslr_db / 20.0), 0.01)
        << draw;
    EXPECT_NEAR(std::pow(10.0, response->azimuth.pslr_db / 20.0), std::pow(10.0, theory.azimuth->pslr_db / 20.0), 0.01)
        << draw;
    EXPECT_NEAR(std::pow(10.0, response->range.islr_db / 10.0), std::pow(10.0, theory.range->islr_db / 10.0), 0.01)
        << draw;
    EXPECT_NEAR(response->amplitude, theory.amplitude, 0.02 * theory.amplitude) << draw;
  }
}

TEST(TheoryOfTargets, FollowsTheDopplerBandThatIsKept) {
  expect_as_theory(sar_scene(600.0, {{3.0, 20.0, 0.0}}), {.doppler_bandwidth_hz = 150.0});
}

// Whose matched filter multiplies amplitudes by half the time-bandwidth product.
TEST(TheoryOfTargets, HasTheAmplitudeOfTheClassicProfile) {
  scene::Scene scene = sar_scene(600.0, {{}});
  scene.options.profile = scene::Profile::classic;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  scene.simulations[0].range_end_m = 10098.0 + 200.0 * 0.5 * 299792500.0 / 150e6;
  const auto [acquisition, rows] = stored(scene);
  ASSERT_EQ(acquisition->reception.compressor->output_index().back() + 1, acquisition->reception.columns);
  const TargetTheory theory = theory_of_targets(*acquisition, rows, {}).at(0);
  EXPECT_NEAR(focused_point(rows, theory.place).amplitude, theory.amplitude, 0.01 * theory.amplitude);
}

// Of pulses that were sent closer together, a kept band holds more, and resampled it does not.
TEST(TheoryOfTargets, KnowsPulsesThatWereSentCloserTogetherThanOthers) {
  scene::Scene scene = sar_scene(600.0, {{0.0, 110.0, 0.0}});
  scene.radars[0].repetition = scene::Radar::Repetition::user;
  for (int i = 0; i < 1200; ++i)  // Intervals that grow by a fifth.
    scene.radars[0].pri_s.part[0].knots.push_back({static_cast<double>(i), (0.9 + i / 6000.0) / 600.0});
  const auto [acquisition, rows] = sar_recording(scene);
  signal::MotionCompensation how;
  how.reference = signal::fitted_track(rows.track);
  how.scene_m = scene_middle_m(*acquisition);
  const signal::EchoRows even = signal::compensate_motion(rows, how, {}, {.threads = 2});
  const signal::FocusOptions options{.doppler_bandwidth_hz = 150.0};
  signal::EchoRows told = rows;
  told.compensated = true;
  TargetTheory theory = theory_of_targets(*acquisition, told, options).at(0);
  const signal::StraightTrack line = signal::fit_straight(rows.track);
  theory.place.azimuth_m -= core::dot(signal::fit_straight(even.track).origin_m - line.origin_m, line.along);
  const signal::PointResponse response = focused_point(even, theory.place, options);
  EXPECT_NEAR(response.place.azimuth_m, theory.place.azimuth_m, 0.05);
  EXPECT_NEAR(response.amplitude, theory.amplitude, 0.015 * theory.amplitude);
}

TEST(TheoryOfTargets, HasNoRangeFiguresForOtherPulsesThanChirps) {
  scene::Scene scene = sar_scene(600.0, {{}}, 0.1);
  scene.radars[0].pulse = scene::Radar::Pulse::mono;
  const auto [acquisition, rows] = sar_recording(scene);
  EXPECT_FALSE(theory_of_targets(*acquisition, rows, {}).at(0).range);
}

// Slant range, from the start of the window, to a point on the ground.
core::Vec3 point_at(double from_start_m) {
  return {std::sqrt(std::pow(10098.0 + from_start_m, 2) - 4e6) - 10000.0, 0.0, 0.0};
}

TEST(TheoryOfTargets, OfARawRecordingsEndIsThatOfThePartOfTheEchoThatItHolds) {
  // 200 m of raw data, a pulse of 120 m: of an echo from 160 m on, 40 m are left, of one from 60 m on, all.
  const auto [acquisition, rows] = stored(sar_scene(600.0, {point_at(160.0), point_at(60.0)}, 0.5));
  const std::vector<TargetTheory> theories = theory_of_targets(*acquisition, rows, {});
  const double wavelength_m = core::exact_light_speed_mps / 5.3e9;
  EXPECT_NEAR(theories[0].amplitude / simulate::equation_amplitude(10258.0, 1.0, wavelength_m), 1.0 / 3.0, 0.01);
  // A hundredth of the energy lies beyond the sampled band, and some of that does not add up over the aperture.
  EXPECT_NEAR(theories[1].amplitude / simulate::equation_amplitude(10158.0, 1.0, wavelength_m), 1.0, 0.002);
  EXPECT_FALSE(theories[0].range);
  EXPECT_TRUE(theories[1].range);
  for (const TargetTheory& theory : theories)
    EXPECT_NEAR(focused_point(rows, theory.place).amplitude, theory.amplitude, 0.02 * theory.amplitude);
  // A taper over the band is one over the pulse: Hann's weight of the first third is 1/3 - sin(2 pi/3)/(2 pi).
  const signal::FocusOptions hann{.range_window = {.kind = signal::SarWindow::Kind::hann}};
  const TargetTheory tapered = theory_of_targets(*acquisition, rows, hann).at(0);
  EXPECT_NEAR(tapered.amplitude / simulate::equation_amplitude(10258.0, 1.0, wavelength_m),
              1.0 / 3.0 - std::sin(2.0 * core::pi / 3.0) / (2.0 * core::pi), 0.01);
}

// Before and behind the 200 m that are recorded; where they would be is known all the same.
TEST(TheoryOfTargets, SaysWhichTargetsAreNeverRecorded) {
  const auto [acquisition, rows] =
      sar_recording(sar_scene(600.0, {point_at(-60.0), point_at(100.0), point_at(400.0)}, 0.5));
  const std::vector<TargetTheory> theories = theory_of_targets(*acquisition, rows, {});
  const double range_m[] = {10038.0, 10198.0, 10498.0};
  for (std::size_t t = 0; t < theories.size(); ++t) {
    EXPECT_EQ(theories[t].unrecorded, t != 1) << t;
    EXPECT_EQ(theories[t].amplitude > 0.0, t == 1) << t;
    EXPECT_NEAR(theories[t].place.range_m, range_m[t], 0.1);
    EXPECT_NEAR(theories[t].place.azimuth_m, 0.0, 1.0);
  }
}

TEST(TheoryOfTargets, IsNoneOutsideTheRecordedRanges) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {point_at(250.0)}, 0.1));
  EXPECT_EQ(theory_of_targets(*acquisition, rows, {}).at(0).amplitude, 0.0);
}

TEST(TheoryOfTargets, GrowsWithTheReceiversGainOverTime) {
  scene::Scene scene = sar_scene(600.0, {point_at(60.0)}, 0.2);
  const auto [plain_plan, plain_rows] = sar_recording(scene);
  const TargetTheory plain = theory_of_targets(*plain_plan, plain_rows, {}).at(0);
  const double plain_amplitude = focused_point(plain_rows, plain.place).amplitude;
  scene.radars[0].stc = scene::Radar::Stc::range_law;
  const double wavelength_m = core::exact_light_speed_mps / 5.3e9;
  // R^2 in the middle of the echo, 60 m behind its beginning, undoes the spreading of R^2 but for these 60 m.
  const double expected = simulate::equation_amplitude(1.0, 1.0, wavelength_m) * std::pow(10218.0 / 10158.0, 2);
  for (const auto& [acquisition, rows] : {sar_recording(scene), stored(scene)}) {
    const TargetTheory theory = theory_of_targets(*acquisition, rows, {}).at(0);
    EXPECT_NEAR(theory.amplitude / expected, 1.0, 0.001);
    EXPECT_NEAR(focused_point(rows, theory.place).amplitude / plain_amplitude / (10218.0 * 10218.0), 1.0, 0.001);
  }
  scene.radars[0].stc = scene::Radar::Stc::user;
  scene.radars[0].stc_gain.part = {simulate::lines({{0.0, 5.0}, {20000.0, 5.0}})};
  const auto [acquisition, rows] = sar_recording(scene);
  EXPECT_NEAR(theory_of_targets(*acquisition, rows, {}).at(0).amplitude /
                  simulate::equation_amplitude(10158.0, 1.0, wavelength_m),
              5.0, 0.005);
}

TEST(TheoryOfTargets, KnowsTheRadarsWindowInCompressedRecordings) {
  scene::Scene scene = sar_scene(600.0, {point_at(100.0)}, 0.5);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  scene.radars[0].window = scene::Radar::Window::hamming;
  const auto [acquisition, rows] = stored(scene);
  const TargetTheory theory = theory_of_targets(*acquisition, rows, {}).at(0);
  const signal::PointResponse response = focused_point(rows, theory.place);
  ASSERT_TRUE(theory.range);
  EXPECT_NEAR(response.range.width, theory.range->width, 0.01 * theory.range->width);
  EXPECT_NEAR(response.amplitude, theory.amplitude, 0.01 * theory.amplitude);
  EXPECT_LT(response.range.pslr_db, -30.0);
  EXPECT_LT(theory.range->pslr_db, -30.0);
  // A Hamming window makes a sinc 1.303/0.886 as wide.
  scene.radars[0].window = scene::Radar::Window::rectangular;
  const auto [even_plan, even_rows] = stored(scene);
  const TargetTheory even = theory_of_targets(*even_plan, even_rows, {}).at(0);
  EXPECT_NEAR(theory.range->width / even.range->width, 1.303 / 0.886, 0.03);
}

TEST(TheoryOfTargets, IsTheSameForAnyNumberOfThreadsAndEndsWhenAskedTo) {
  std::vector<core::Vec3> points;
  for (int i = 0; i < 20; ++i) points.push_back({static_cast<double>(i), 3.0 * i, 0.0});
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, points, 0.1));
  const auto one = theory_of_targets(*acquisition, rows, {}, false, {.threads = 1});
  const auto three = theory_of_targets(*acquisition, rows, {}, false, {.threads = 3});
  ASSERT_EQ(one.size(), 20U);
  for (std::size_t t = 0; t < one.size(); ++t) {
    EXPECT_EQ(one[t].target, t);
    EXPECT_EQ(one[t].amplitude, three[t].amplitude);
    EXPECT_EQ(one[t].azimuth->width, three[t].azimuth->width);
  }
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)theory_of_targets(*acquisition, rows, {}, false, {.threads = 2, .stop = &stop}),
               core::Interrupted);
}

}  // namespace sar_theory_test
}  // namespace sarsim::workflow
