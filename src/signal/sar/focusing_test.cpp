#include "signal/sar/focusing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "core/maths/constants.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/sar/sar_test_scene.hpp"

namespace sarsim::signal {
namespace focusing_test {

using namespace sar_test;

double phase_difference(double a, double b) { return std::remainder(a - b, 2.0 * core::pi); }

double expected_phase(const Setting& setting, double closest_m) {
  return -4.0 * core::pi * setting.waveform.carrier_hz * closest_m / setting.waveform.light_speed_mps;
}

PointResponse measured(const FocusedImage& image, const core::Vec3& point, double search_m = 3.0) {
  const auto response = measure_point(image, reader_of(image), place_of(image.frame, point), search_m);
  if (!response) throw std::runtime_error("no response found");
  return *response;
}

class EveryMethod : public testing::TestWithParam<FocusMethod> {};

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::Values(FocusMethod::range_doppler, FocusMethod::chirp_scaling, FocusMethod::omega_k),
                         [](const auto& method) {
                           switch (method.param) {
                             case FocusMethod::range_doppler: return "RangeDoppler";
                             case FocusMethod::chirp_scaling: return "ChirpScaling";
                             case FocusMethod::omega_k: break;
                           }
                           return "OmegaK";
                         });

// Distance between first nulls over two of a target that all pulses see, across the line of sight: half a wavelength
// over twice the sine of half the angle that the track subtends (constant angle; see 3.8 of any table of responses).
double azimuth_cell_m(const Setting& setting, double closest_m) {
  const double half_m = 0.5 * setting.speed_mps * static_cast<double>(setting.pulses) / setting.prf_hz;
  const double slant_m = closest_m / std::cos(setting.squint_rad);
  const double half_angle = std::atan(half_m * std::cos(setting.squint_rad) / slant_m);
  return setting.wavelength_m() / (4.0 * std::sin(half_angle));
}

double range_cell_m(const Setting& setting) {
  return setting.waveform.light_speed_mps / (2.0 * setting.waveform.bandwidth_hz);
}

double time_bandwidth(const Setting& setting) { return setting.waveform.bandwidth_hz * setting.waveform.pulse_width_s; }

void expect_in_place(const PointResponse& response, const ImagePlace& place, const Setting& setting, double cells) {
  EXPECT_NEAR(response.place.azimuth_m, place.azimuth_m, cells * azimuth_cell_m(setting, place.range_m));
  EXPECT_NEAR(response.place.range_m, place.range_m, cells * range_cell_m(setting));
}

void expect_figures(const ResponseFigures& found, const ResponseFigures& theory, double cell_m) {
  EXPECT_NEAR(found.width / cell_m, theory.width, 0.01 * theory.width);
  EXPECT_NEAR(found.pslr_db, theory.pslr_db, 0.2);
  EXPECT_NEAR(found.islr_db, theory.islr_db, 0.3);
}

// Position within 0.02 cell, widths within 1 %, sidelobes within 0.2 and 0.3 dB of theory, phase within 0.01 rad.
void expect_as_theory(const PointResponse& response, const core::Vec3& point, const FocusedImage& image,
                      const Setting& setting, double amplitude) {
  const ImagePlace place = place_of(image.frame, point);
  const double sampling = setting.waveform.sample_rate_hz / setting.waveform.bandwidth_hz;
  expect_in_place(response, place, setting, 0.02);
  expect_figures(response.range, theoretical_figures({}, time_bandwidth(setting), sampling), range_cell_m(setting));
  expect_figures(response.azimuth, theoretical_figures({}), azimuth_cell_m(setting, place.range_m));
  EXPECT_NEAR(response.amplitude / amplitude, 1.0, 0.01);
  EXPECT_NEAR(phase_difference(response.phase_rad, expected_phase(setting, place.range_m)), 0.0, 0.01);
}

TEST_P(EveryMethod, FocusesPointsOfTheThesisGeometryAsTheorySays) {
  const Setting setting;
  for (const auto& [along, offset] : {std::pair(0.0, 0.0), std::pair(31.37, 120.3), std::pair(-47.11, -131.9)}) {
    const core::Vec3 point = point_at(setting, along, setting.closest_m() + offset);
    const FocusedImage image = focus(make_echoes(setting, {{point, 2.0, {}}}), {.method = GetParam()});
    expect_as_theory(measured(image, point), point, image, setting, 2.0);
  }
}

TEST_P(EveryMethod, KeepsPointsAtTheEdgesOfTheRecordInPlace) {
  // Seen by all pulses, 200 m from the middle: Doppler frequencies up to 277 Hz, of 300.
  const Setting setting;
  for (const double along : {-199.7, 199.2}) {
    const core::Vec3 point = point_at(setting, along, setting.closest_m() + 11.3);
    const FocusedImage image = focus(make_echoes(setting, {{point, 1.0, {}}}), {.method = GetParam()});
    const PointResponse response = measured(image, point);
    expect_in_place(response, place_of(image.frame, point), setting, 0.02);
    EXPECT_NEAR(phase_difference(response.phase_rad, expected_phase(setting, setting.closest_m() + 11.3)), 0.0, 0.02);
  }
}

TEST_P(EveryMethod, AllowsForTheAntennasMotionBetweenSendingAndReceiving) {
  // It moves V R/c = 6.8 mm meanwhile.
  const Setting setting;
  const core::Vec3 point = point_at(setting, 7.1, setting.closest_m());
  const FocusedImage image = focus(make_echoes(setting, {{point, 1.0, {}}}), {.method = GetParam()});
  EXPECT_NEAR(measured(image, point).place.azimuth_m, 7.1, 0.002);
}

TEST_P(EveryMethod, FocusesAtASquintOfEightDegrees) {
  Setting setting;
  setting.squint_rad = 8.0 * core::pi / 180.0;
  setting.waveform.sample_rate_hz = 300e6;
  const double centroid_hz = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
  for (const double offset : {0.0, 30.3}) {
    const core::Vec3 point = point_at(setting, 3.0, setting.closest_m() + offset);
    const FocusedImage image =
        focus(make_echoes(setting, {{point, 1.0, {}}}), {.method = GetParam(), .doppler_centroid_hz = centroid_hz});
    expect_as_theory(measured(image, point), point, image, setting, 1.0);
  }
}

TEST_P(EveryMethod, AllowsForDopplerInsideALongPulseOfEitherSweep) {
  // 40 us at 10 degrees of squint: 1227 Hz move the peak by 0.49 ns, or 7.4 cm.
  for (const double sweep : {1.0, -1.0}) {
    Setting setting;
    setting.squint_rad = 10.0 * core::pi / 180.0;
    setting.waveform.sample_rate_hz = 200e6;
    setting.waveform.pulse_width_s = 40e-6;
    setting.waveform.bandwidth_hz *= sweep;
    const double centroid_hz = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
    const core::Vec3 point = point_at(setting, 3.0, setting.closest_m());
    const FocusedImage image =
        focus(make_echoes(setting, {{point, 1.0, {}}}), {.method = GetParam(), .doppler_centroid_hz = centroid_hz});
    const PointResponse response = measured(image, point);
    EXPECT_NEAR(response.place.azimuth_m, place_of(image.frame, point).azimuth_m, 0.01);
    EXPECT_NEAR(response.place.range_m, setting.closest_m(), 0.01);
    EXPECT_NEAR(phase_difference(response.phase_rad, expected_phase(setting, setting.closest_m())), 0.0, 0.02);
  }
}

TEST_P(EveryMethod, LowersSidelobesByItsWindows) {
  const Setting setting;
  const SarWindow taylor{.kind = SarWindow::Kind::taylor};
  const core::Vec3 point = point_at(setting, 13.1, setting.closest_m() - 40.2);
  const FocusedImage image =
      focus(make_echoes(setting, {{point, 1.0, {}}}),
            {.method = GetParam(), .range_window = taylor, .azimuth_window = {.kind = SarWindow::Kind::hamming}});
  const PointResponse response = measured(image, point);
  const ResponseFigures range = theoretical_figures(taylor, time_bandwidth(setting));
  const ResponseFigures azimuth = theoretical_figures({.kind = SarWindow::Kind::hamming});
  EXPECT_NEAR(response.range.width / range_cell_m(setting), range.width, 0.01 * range.width);
  EXPECT_NEAR(response.range.pslr_db, range.pslr_db, 0.5);
  EXPECT_NEAR(response.azimuth.width / azimuth_cell_m(setting, setting.closest_m()), azimuth.width,
              0.01 * azimuth.width);
  EXPECT_LT(response.azimuth.pslr_db, -41.0);
  EXPECT_NEAR(response.amplitude, 1.0, 0.01);
}

TEST_P(EveryMethod, GivesTheMeanOfTheEchoesInAChosenDopplerBand) {
  // 800 pulses of 0.4 s worth of Doppler band: most pulses see the point outside it.
  Setting setting;
  setting.pulses = 1600;
  const core::Vec3 point = point_at(setting, 5.0, setting.closest_m());
  const double band_hz = 120.0;
  const FocusedImage image =
      focus(make_echoes(setting, {{point, 3.0, {}}}), {.method = GetParam(), .doppler_bandwidth_hz = band_hz});
  const PointResponse response = measured(image, point);
  const double cell_m = setting.speed_mps / band_hz;
  EXPECT_NEAR(response.azimuth.width, 0.886 * cell_m, 0.01 * cell_m);
  EXPECT_NEAR(response.amplitude, 3.0, 0.03);
  EXPECT_NEAR(response.place.azimuth_m, 5.0, 0.02 * cell_m);
}

TEST_P(EveryMethod, PutsAMovingTargetRTimesUOverVAway) {
  // Receding across track at 3 m/s: its echoes are those of a point R u/v behind.
  const Setting setting;
  const double recession_mps = 3.0;
  const double closest = setting.closest_m();
  const core::Vec3 point = point_at(setting, 20.0, closest);
  const core::Vec3 velocity{recession_mps * closest / point.x, 0.0, 0.0};
  const FocusedImage image = focus(make_echoes(setting, {{point, 1.0, velocity}}), {.method = GetParam()});
  const double shift_m = closest * recession_mps / setting.speed_mps;
  const core::Vec3 seen{point.x, point.y - shift_m, 0.0};
  const PointResponse response = measured(image, seen, 10.0);
  EXPECT_NEAR(response.place.azimuth_m, 20.0 - shift_m, 0.1 * azimuth_cell_m(setting, closest));
}

TEST_P(EveryMethod, GivesTheSameBytesForAnyNumberOfThreadsAndFromDisk) {
  Setting setting;
  setting.pulses = 300;
  setting.swath_m = 150.0;
  const SarEchoes echoes = make_echoes(setting, {{point_at(setting, 3.0, setting.closest_m() + 7.0), 1.0, {}}});
  const FocusedImage one = focus(echoes, {.method = GetParam()}, {.threads = 1});
  const FocusedImage three = focus(echoes, {.method = GetParam()}, {.threads = 3});
  const FocusedImage disk = focus(echoes, {.method = GetParam(), .memory_bytes = 100000}, {.threads = 2});
  EXPECT_TRUE(one.values == three.values);
  EXPECT_TRUE(one.values == disk.values);
}

// 5 m/s and 620 pulses a second: all directions lie within 177 Hz, and most of the spectrum is that of none.
Setting slow_setting() {
  Setting setting;
  setting.speed_mps = 5.0;
  setting.height_m = 20.0;
  setting.ground_m = 100.0;
  setting.prf_hz = 620.0;
  setting.swath_m = 60.0;
  return setting;
}

TEST_P(EveryMethod, FocusesEchoesOfASlowPlatformThatSendsManyPulses) {
  const Setting setting = slow_setting();
  const core::Vec3 point = point_at(setting, 0.31, setting.closest_m() + 4.2);
  const SarEchoes echoes = make_echoes(setting, {{point, 3.0, {}}});
  for (const double band_hz : {0.0, 12.0}) {
    const FocusedImage image = focus(echoes, {.method = GetParam(), .doppler_bandwidth_hz = band_hz});
    const PointResponse response = measured(image, point);
    expect_in_place(response, place_of(image.frame, point), setting, 0.02);
    EXPECT_NEAR(response.amplitude, 3.0, 0.06) << band_hz;
    EXPECT_NEAR(phase_difference(response.phase_rad, expected_phase(setting, setting.closest_m() + 4.2)), 0.0, 0.02);
    for (const std::complex<float>& value : image.values) ASSERT_TRUE(std::isfinite(std::norm(value)));
  }
}

TEST_P(EveryMethod, IsFiniteWhereTheWindowBeginsAtTheAntenna) {
  Setting setting;
  setting.pulses = 64;
  setting.swath_m = 60.0;
  SarEchoes echoes = make_echoes(setting, {{point_at(setting, 0.0, setting.closest_m()), 1.0, {}}});
  echoes.first_delay_s = 0.0;
  const FocusedImage image = focus(echoes, {.method = GetParam(), .doppler_bandwidth_hz = 300.0});
  ASSERT_EQ(image.range.first_m, 0.0);
  for (const std::complex<float>& value : image.values) ASSERT_TRUE(std::isfinite(std::norm(value)));
  for (std::size_t r = 0; r < image.azimuth.count; ++r)
    ASSERT_EQ(image.values[r * image.range.count], std::complex<float>());
}

TEST(OmegaK, FocusesAtASquintOfTwentyDegrees) {
  Setting setting;
  setting.squint_rad = 20.0 * core::pi / 180.0;
  // At 150 MHz a hundredth of the chirp's energy folds back into the band, and out of its Doppler frequency it is lost
  // to the peak instead of adding to it.
  setting.waveform.sample_rate_hz = 300e6;
  const double centroid_hz = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
  for (const auto& [along, offset] : {std::pair(0.0, 0.0), std::pair(21.3, -60.7)}) {
    const core::Vec3 point = point_at(setting, along, setting.closest_m() + offset);
    const FocusedImage image = focus(make_echoes(setting, {{point, 1.0, {}}}),
                                     {.method = FocusMethod::omega_k, .doppler_centroid_hz = centroid_hz});
    expect_as_theory(measured(image, point), point, image, setting, 1.0);
  }
}

TEST(OmegaK, FocusesAnApertureOfThirtyDegrees) {
  // 0.5 m of wavelength and 520 m of track at 1 km: the curve of ranges bends by 20 cells.
  Setting setting;
  setting.speed_mps = 50.0;
  setting.height_m = 300.0;
  setting.ground_m = 954.0;
  setting.prf_hz = 250.0;
  setting.pulses = 2600;
  setting.swath_m = 200.0;
  setting.waveform.carrier_hz = 0.6e9;
  const core::Vec3 point = point_at(setting, 0.0, setting.closest_m() + 3.7);
  const FocusedImage image = focus(make_echoes(setting, {{point, 1.0, {}}}), {.method = FocusMethod::omega_k});
  const PointResponse response = measured(image, point);
  expect_in_place(response, place_of(image.frame, point), setting, 0.02);
  EXPECT_NEAR(phase_difference(response.phase_rad, expected_phase(setting, setting.closest_m() + 3.7)), 0.0, 0.02);
}

TEST(DopplerCentroid, IsMeasuredFromTheData) {
  Setting setting;
  setting.squint_rad = 4.0 * core::pi / 180.0;
  setting.pulses = 200;
  const SarEchoes echoes = make_echoes(setting, {{point_at(setting, 0.0, setting.closest_m()), 1.0, {}}});
  const double truth = doppler_centroid_hz(setting.waveform, setting.speed_mps, setting.squint_rad);
  EXPECT_NEAR(measured_doppler_centroid_hz(rows_of(echoes), truth - 200.0), truth, 3.0);
  EXPECT_EQ(measured_doppler_centroid_hz(rows_of(echoes), truth, {.threads = 3}),
            measured_doppler_centroid_hz(rows_of(echoes), truth));
}

SarEchoes small_echoes() {
  Setting setting;
  setting.pulses = 64;
  setting.swath_m = 60.0;
  return make_echoes(setting, {});
}

std::string first_error(const SarEchoes& echoes, const FocusOptions& options = {}) {
  const core::Problems problems = problems_of_focusing(rows_of(echoes), options);
  return problems.empty() ? std::string() : problems.front().message;
}

TEST(ProblemsOfFocusing, AreNoneForAStraightTrack) { EXPECT_EQ(first_error(small_echoes()), ""); }

TEST(ProblemsOfFocusing, NameWhatCannotBeFocused) {
  SarEchoes uneven = small_echoes();
  for (std::size_t p = 32; p < 64; ++p) uneven.track[p].time_s += 0.001;
  EXPECT_NE(first_error(uneven).find("not evenly spaced"), std::string::npos);

  SarEchoes resting = small_echoes();
  for (TrackPoint& point : resting.track) point.position_m = {0.0, 0.0, 2000.0};
  EXPECT_NE(first_error(resting).find("does not move"), std::string::npos);

  SarEchoes wide = small_echoes();
  wide.waveform.bandwidth_hz = 200e6;
  EXPECT_NE(first_error(wide).find("bandwidth"), std::string::npos);

  SarEchoes one = small_echoes();
  one.track.resize(1);
  EXPECT_NE(first_error(one).find("too few pulses"), std::string::npos);

  EXPECT_NE(first_error(small_echoes(), {.doppler_bandwidth_hz = 601.0}).find("Doppler bandwidth"), std::string::npos);
  EXPECT_NE(first_error(small_echoes(), {.doppler_bandwidth_hz = 0.001}).find("can resolve in Doppler"),
            std::string::npos);
  EXPECT_NE(first_error(small_echoes(), {.doppler_centroid_hz = 7065.0}).find("no look direction"), std::string::npos);
}

TEST(ProblemsOfFocusing, SayWhatWasFoundWithItsUnit) {
  const auto found = [](const SarEchoes& echoes, const FocusOptions& options) {
    return problems_of_focusing(rows_of(echoes), options).at(0).found;
  };
  EXPECT_EQ(found(small_echoes(), {.doppler_bandwidth_hz = 601.0}), "601 Hz");
  EXPECT_EQ(found(small_echoes(), {.doppler_centroid_hz = 7065.0}), "7065 Hz");
  SarEchoes bent = small_echoes();
  bent.track[bent.track.size() / 2].position_m.z += 2.0;
  EXPECT_TRUE(found(bent, {}).ends_with(" m")) << found(bent, {});
}

TEST(ProblemsOfFocusing, NameAnAreaThatIsTooLongOrTooFarAway) {
  for (const AxisInterval area :
       {AxisInterval{1e300, 1e301}, AxisInterval{-1e18, 1e18}, AxisInterval{1e15, 1e15 + 1}}) {
    EXPECT_NE(first_error(small_echoes(), {.azimuth_area = area}).find("too long in azimuth"), std::string::npos);
    const core::Problems in_time = problems_of_focusing_in_time(rows_of(small_echoes()), {.azimuth_area = area});
    ASSERT_EQ(in_time.size(), 1U) << area.first_m;
    EXPECT_NE(in_time[0].expected.find("samples with the record"), std::string::npos);
  }
  EXPECT_EQ(first_error(small_echoes(), {.azimuth_area = AxisInterval{1e5, 1e5 + 1}}), "");
}

TEST(ProblemsOfFocusing, NameABandThatReachesBeyondAllDirections) {
  // Two speeds over the wavelength are 7071.6 Hz.
  EXPECT_EQ(first_error(small_echoes(), {.doppler_centroid_hz = 6900.0, .doppler_bandwidth_hz = 300.0}), "");
  EXPECT_NE(first_error(small_echoes(), {.doppler_centroid_hz = 6950.0, .doppler_bandwidth_hz = 300.0})
                .find("beyond that of any look direction"),
            std::string::npos);
}

TEST(ProblemsOfFocusing, NameAllThatIsWrongAtOnce) {
  SarEchoes uneven = small_echoes();
  for (std::size_t p = 32; p < 64; ++p) uneven.track[p].time_s += 0.001;
  std::string text;
  for (const core::Problem& problem : problems_of_focusing(rows_of(uneven), {.doppler_bandwidth_hz = 601.0}))
    text += problem.message + "\n";
  EXPECT_NE(text.find("Doppler bandwidth"), std::string::npos);
  EXPECT_NE(text.find("not evenly spaced"), std::string::npos);
}

TEST(ProblemsOfFocusing, NameSamplingTooFastForChirpScalingAlone) {
  SarEchoes fine = small_echoes();
  fine.waveform.bandwidth_hz = 2e6;
  fine.waveform.sample_rate_hz = 75e6;
  // 256 (75/2)^2 = 360000 samples beside 60.
  EXPECT_NE(
      first_error(fine, {.method = FocusMethod::chirp_scaling}).find("too far above the bandwidth for chirp scaling"),
      std::string::npos);
  EXPECT_EQ(first_error(fine, {.method = FocusMethod::range_doppler}), "");
  EXPECT_EQ(first_error(fine), "");
  fine.waveform.bandwidth_hz = 7.5e6;
  EXPECT_EQ(first_error(fine, {.method = FocusMethod::chirp_scaling}), "");
}

TEST(ProblemsOfFocusingInTime, MindNeitherTheTracksShapeNorTheBandButTheOptions) {
  const auto errors = [](const SarEchoes& echoes, const FocusOptions& options) {
    return problems_of_focusing_in_time(rows_of(echoes), options).size();
  };
  SarEchoes uneven = small_echoes();
  for (std::size_t p = 32; p < 64; ++p) uneven.track[p].time_s += 0.001;
  EXPECT_EQ(errors(uneven, {.doppler_centroid_hz = 300.0}), 0U);
  EXPECT_EQ(errors(small_echoes(), {.doppler_centroid_hz = 6950.0, .doppler_bandwidth_hz = 300.0}), 0U);
  EXPECT_EQ(errors(uneven, {.doppler_centroid_hz = 7065.0}), 1U);
  EXPECT_EQ(errors(small_echoes(), {.doppler_bandwidth_hz = 601.0}), 1U);
  SarEchoes narrow = small_echoes();
  narrow.samples = 1;
  EXPECT_EQ(errors(narrow, {}), 1U);
  EXPECT_EQ(first_error(narrow), "");
}

TEST(ProblemsOfFocusing, WarnOfATrackThatIsNotStraight) {
  SarEchoes bent = small_echoes();
  for (TrackPoint& point : bent.track) point.position_m.z += 10.0 * point.time_s * point.time_s * 100.0;
  const core::Problems problems = problems_of_focusing(rows_of(bent), {});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().severity, core::Severity::warning);
  EXPECT_NE(problems.front().message.find("straight"), std::string::npos);
}

TEST(Focus, RefusesWhatHasProblems) {
  EXPECT_THROW((void)focus(small_echoes(), {.doppler_bandwidth_hz = -1.0}), std::invalid_argument);
}

TEST(Focus, EndsWhenAskedTo) {
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)focus(small_echoes(), {}, {.threads = 2, .stop = &stop}), core::Interrupted);
}

TEST(Focus, TellsHowFarItHasCome) {
  const SarEchoes echoes = small_echoes();
  core::Progress last;
  (void)focus_rows(rows_of(echoes), {}, {}, [&](const core::Progress& progress) {
    EXPECT_GE(progress.done, last.done);
    last = progress;
  });
  EXPECT_EQ(last.done, last.total);
  EXPECT_GT(last.total, 0U);
}

TEST(MeasurePoint, FindsNothingOutsideTheImageOrWhereItIsZero) {
  const FocusedImage image = focus(small_echoes(), {});
  EXPECT_FALSE(measure_point(image, reader_of(image), {0.0, 10198.0}, 3.0));
  EXPECT_FALSE(measure_point(image, reader_of(image), {1e6, 10198.0}, 3.0));
}

}  // namespace focusing_test
}  // namespace sarsim::signal
