#include "workflow/focus/swath_remark.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/focus/seen_spectrum.hpp"

namespace sarsim::workflow {
namespace swath_remark_test {

using testing::HasSubstr;

// Two points at C band and 1.2 GHz, 14 degrees ahead: one in the middle of the swath, one 75 m beyond.
scene::Scene wide_band_scene(double far_m) {
  scene::Scene scene = sar_scene(700.0, {{0.0, 0.0, 0.0}, {far_m, 0.0, 0.0}}, 0.5);
  scene.platforms[1] = simulate::moving("Plane", {-2800.0, -750.0, 1000.0}, {0.0, 100.0, 0.0});
  scene.radars[0].bandwidth_hz = 1.2e9;
  scene.radars[0].pulse_width_s = 1e-6;
  scene.simulations[0].sample_rate_hz = 1.8e9;
  scene.simulations[0].range_start_m = 2940.0;
  scene.simulations[0].range_end_m = 3220.0;
  return scene;
}

TEST(SwathRemark, NamesTheTargetThatLosesMostAndItsLoss) {
  const auto [acquisition, rows] = sar_recording(wide_band_scene(90.0));
  signal::FocusOptions options{.method = signal::FocusMethod::range_doppler};
  options.doppler_centroid_hz = geometric_doppler_centroid_hz(*acquisition);
  const core::Problems problems = diagnose_swath_loss(*acquisition, rows, options);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::warning);
  EXPECT_THAT(problems[0].message, HasSubstr("range-Doppler focuses all ranges with the parameters of mid-swath"));
  EXPECT_THAT(problems[0].message, HasSubstr("target 2, 69.3 m away, loses "));
  const std::size_t at = problems[0].message.find("loses ") + 6;
  const double lost_db = std::stod(problems[0].message.substr(at));
  const signal::ImagePlace place = signal::place_of(signal::image_of(rows, options).frame, {90.0, 0.0, 0.0});
  const double found = focused_point(rows, place, options).amplitude / sar_targets(*acquisition, rows).at(1).amplitude;
  EXPECT_NEAR(-20.0 * std::log10(found), lost_db, 0.1);
  options.method = signal::FocusMethod::omega_k;
  EXPECT_TRUE(diagnose_swath_loss(*acquisition, rows, options).empty());
}

// What is found of the target that is named, against its theory, which knows of the antenna.
signal::SwathLoss found_loss(const simulate::Acquisition& acquisition, const signal::EchoRows& rows,
                             const signal::SarEchoes& echoes, const signal::FocusOptions& options) {
  const TargetTheory theory = theory_of_targets(acquisition, rows, options).at(0);
  const signal::FocusedImage image = signal::focus(echoes, options, {.threads = 2});
  const signal::PointResponse found = signal::measure_point(image, signal::reader_of(image), theory.place, 2.0).value();
  signal::SwathLoss loss;
  loss.shift = {found.place.azimuth_m - theory.place.azimuth_m, found.place.range_m - theory.place.range_m};
  loss.amplitude = found.amplitude / theory.amplitude;
  const double carried = image.azimuth.spectrum_centre_per_m * loss.shift.azimuth_m +
                         image.range.spectrum_centre_per_m * loss.shift.range_m;
  loss.phase_rad = std::remainder(found.phase_rad - theory.phase_rad - 2.0 * core::pi * carried, 2.0 * core::pi);
  return loss;
}

// An antenna of 3 degrees, whose beam tapers the Doppler spectrum, and windows: neither is even over the band. Up to 27
// m off the middle of the swath 2 dB are lost, and side lobes stay 6 dB below the peak: farther off the response has
// peaks of equal height, and which of them is the largest is left to chance.
TEST(SwathRemark, PredictsLossAndPhaseOfTaperedSpectra) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> off(8.0, 27.0);
  using Kind = signal::SarWindow::Kind;
  for (int i = 0; i < 2; ++i) {
    scene::Scene scene = wide_band_scene(0.0);
    scene.targets.resize(1);
    const double middle_m = std::sqrt(2988.0 * 2988.0 - 1000.0 * 1000.0) - 2800.0;
    scene.targets[0].position_m = {middle_m + (i == 0 ? off(random) : -off(random)), 0.0, 0.0};
    scene.simulations[0].range_start_m = 3020.0;
    scene.simulations[0].range_end_m = 3140.0;
    scene.radars[0].pulse_width_s = 300e-9;
    scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
    scene.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(3.0);
    scene.radars[0].transmit_antenna.elevation_beamwidth = core::Angle::from_deg(40.0);
    scene.radars[0].beam_azimuth = core::Angle::from_deg(90.0 - std::atan2(750.0, 2800.0) * 180.0 / core::pi);
    scene.radars[0].beam_elevation = core::Angle::from_deg(-19.0);
    const auto [acquisition, rows] = sar_recording(scene);
    const signal::SarEchoes echoes = signal::sar_echoes(rows, {.threads = 2});
    for (const signal::FocusMethod method : {signal::FocusMethod::range_doppler, signal::FocusMethod::chirp_scaling}) {
      const bool scaled = method == signal::FocusMethod::chirp_scaling;
      const Kind kind = scaled == (i == 0) ? Kind::hamming : Kind::rectangular;
      signal::FocusOptions options{.method = method, .range_window = {.kind = kind}, .azimuth_window = {.kind = kind}};
      options.doppler_centroid_hz = geometric_doppler_centroid_hz(*acquisition);
      const auto predicted = worst_method_loss(*acquisition, rows, options);
      ASSERT_TRUE(predicted);
      const signal::SwathLoss found = found_loss(*acquisition, rows, echoes, options);
      const double predicted_db = 20.0 * std::log10(predicted->loss.amplitude);
      EXPECT_NEAR(20.0 * std::log10(found.amplitude), predicted_db, 0.1 - 0.2 * predicted_db);
      EXPECT_NEAR(found.phase_rad, predicted->loss.phase_rad,
                  std::max(0.02, 0.2 * std::abs(predicted->loss.phase_rad)));
    }
  }
}

// The upper end of a band as wide as half its carrier has Doppler frequencies that pulses, enough at the carrier,
// alias.
TEST(SwathRemark, SaysWhatOmegaKLosesAtTheUpperEndOfTheBand) {
  scene::Scene scene = sar_scene(600.0, {{0.0, 0.0, 0.0}}, 3.0);
  scene.platforms[1] = simulate::moving("Plane", {-500.0, 0.0, 0.0}, {0.0, 100.0, 0.0});
  scene.radars[0].carrier_hz = 300e6;
  scene.radars[0].bandwidth_hz = 150e6;
  scene.simulations[0].sample_rate_hz = 225e6;
  scene.simulations[0].range_start_m = 400.0;
  scene.simulations[0].range_end_m = 800.0;
  for (const double prf_hz : {211.0, 400.0}) {
    scene.radars[0].prf_hz = prf_hz;
    const auto [acquisition, rows] = sar_recording(scene);
    signal::FocusOptions options;
    options.spectrum = seen_spectrum(*acquisition, rows, {}, SeenPulses::sampled);
    const auto predicted = worst_method_loss(*acquisition, rows, options);
    ASSERT_TRUE(predicted);
    const double predicted_db = 20.0 * std::log10(predicted->loss.amplitude);
    EXPECT_NEAR(
        20.0 * std::log10(found_loss(*acquisition, rows, signal::sar_echoes(rows, {.threads = 2}), options).amplitude),
        predicted_db, 0.1);
    const core::Problems problems = diagnose_swath_loss(*acquisition, rows, options);
    if (prf_hz == 400.0) {
      EXPECT_TRUE(problems.empty());
      continue;
    }
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].severity, core::Severity::warning);
    EXPECT_THAT(problems[0].message, HasSubstr(fmt::format("omega-k loses {:.3g} dB of target 1", -predicted_db)));
  }
}

TEST(SwathRemark, SaysNothingOfNarrowBandsAtBroadside) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{0.0, 0.0, 0.0}, {80.0, 0.0, 0.0}}));
  EXPECT_TRUE(diagnose_swath_loss(*acquisition, rows, {.method = signal::FocusMethod::chirp_scaling}).empty());
}

// The record and its ranges are a few kilometres long.
TEST(AreaRemark, NamesBothIntervalsWhereNoEchoComesFromTheArea) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{0.0, 0.0, 0.0}}));
  const auto remarks = [&rows = rows](double first_m, double last_m) {
    return diagnose_area(rows, {.azimuth_area = signal::AxisInterval{first_m, last_m}});
  };
  EXPECT_TRUE(diagnose_area(rows, {}).empty());
  EXPECT_TRUE(remarks(-1e5, 1e5).empty());
  EXPECT_TRUE(remarks(1000.0, 1e5).empty());
  for (const double side : {-1.0, 1.0}) {
    const core::Problems far = remarks(side * 1e5 - 1.0, side * 1e5 + 1.0);
    ASSERT_EQ(far.size(), 1U);
    EXPECT_EQ(far[0].severity, core::Severity::warning);
    EXPECT_THAT(far[0].found, HasSubstr(side > 0.0 ? "99999 to 100001 m" : "-100001 to -99999 m"));
    EXPECT_THAT(far[0].expected, HasSubstr("the record and the farthest range"));
  }
}

}  // namespace swath_remark_test
}  // namespace sarsim::workflow
