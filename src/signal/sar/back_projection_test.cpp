#include "signal/sar/back_projection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "core/maths/window.hpp"
#include "signal/measure/response_test_support.hpp"
#include "signal/sar/echo_records.hpp"
#include "signal/sar/reference_track.hpp"
#include "signal/sar/sar_test_support.hpp"

namespace sarsim::signal {
namespace back_projection_test {

using Values = std::vector<std::complex<double>>;
using Aperture = BackProjectionOptions::Aperture;
using test::CutFigures;
using test::measure_cut;

const core::WorkControl one{1, nullptr};

Values widened(const std::vector<std::complex<float>>& values) { return {values.begin(), values.end()}; }

double largest_difference(const Values& a, const Values& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Values cut_through(const SarEchoes& echoes, const core::Vec3& middle_m, const core::Vec3& direction, double step_m,
                   std::size_t half, const BackProjectionOptions& options = {}) {
  const core::Vec3 step = step_m * direction;
  return widened(
      back_project(echoes, {middle_m - static_cast<double>(half) * step, {}, step, 1, 2 * half + 1}, options, one));
}

// Direction from the antenna to a point in the middle of the flight, and the one perpendicular to it in the plane of
// the line of sight and the flight.
struct ResponseAxes {
  core::Vec3 range, azimuth;
};

ResponseAxes response_axes(const SarEchoes& echoes, const core::Vec3& point_m) {
  const ReferenceTrack line = fitted_track(echoes.track);
  const core::Vec3 sight = point_m - line.position_m;
  const core::Vec3 range = (1.0 / core::norm(sight)) * sight;
  const core::Vec3 along = line.velocity_mps - core::dot(line.velocity_mps, range) * range;
  return {range, (1.0 / core::norm(along)) * along};
}

// Sum over the pulses of the phases alone: the response in azimuth that a signal without bandwidth would have.
Values azimuth_theory(const SarEchoes& echoes, const core::Vec3& point_m, const core::Vec3& direction, double step_m,
                      std::size_t half) {
  Values cut;
  for (std::size_t i = 0; i <= 2 * half; ++i) {
    const core::Vec3 x = point_m + (static_cast<double>(i) - static_cast<double>(half)) * step_m * direction;
    std::complex<double> sum;
    for (const TrackPoint& t : echoes.track)
      sum += std::polar(1.0, 4.0 * core::pi * echoes.waveform.carrier_hz / echoes.waveform.light_speed_mps *
                                 (core::norm(x - t.position_m) - core::norm(point_m - t.position_m)));
    cut.push_back(sum / static_cast<double>(echoes.track.size()));
  }
  return cut;
}

Values range_theory(const SarWaveform& wave, double step_m, std::size_t half, double doppler_hz) {
  Values cut;
  const double rate = wave.pulse_width_s > 0.0 ? wave.bandwidth_hz / wave.pulse_width_s : 0.0;
  const double peak_s = rate > 0.0 ? -doppler_hz / rate : 0.0;
  for (std::size_t i = 0; i <= 2 * half; ++i) {
    const double x_m = (static_cast<double>(i) - static_cast<double>(half)) * step_m;
    cut.push_back(test::compressed_pulse(wave, 2.0 * x_m / wave.light_speed_mps + peak_s, doppler_hz));
  }
  return cut;
}

struct PointCase {
  double squint_rad;
  double pulse_width_s;  // 0: an ideal sinc
  bool start_stop;
};

void expect_a_point_as_theory_has_it(const PointCase& c) {
  SarEchoes echoes = test::thesis_echoes(1200, 600.0, c.squint_rad);
  echoes.waveform.pulse_width_s = c.pulse_width_s;
  // A chirp of 80 cycles has 1 % of its energy beyond its band: sampled coarsely, it is no longer its closed form.
  echoes.waveform.sample_rate_hz = 180e6;
  echoes.first_delay_s -= 64.0 / 60e6;
  echoes.samples = 3 * 384;
  const core::Vec3 point{3.21, 4.56, 0.0};
  test::write_echoes(echoes, {{point, std::polar(2.5, 0.7)}}, echoes.track, c.start_stop);
  BackProjectionOptions options;
  options.start_stop = c.start_stop;
  const ResponseAxes axes = response_axes(echoes, point);

  const double range_null_m = 0.5 * echoes.waveform.light_speed_mps / echoes.waveform.bandwidth_hz;
  const double range_step_m = range_null_m / 50.0;
  const Values range = cut_through(echoes, point, axes.range, range_step_m, 520, options);
  const double doppler_hz =
      c.start_stop ? 0.0 : 2.0 * 200.0 * std::sin(c.squint_rad) / (core::exact_light_speed_mps / 5.3e9);
  const CutFigures got = measure_cut(range, 50.0);
  const CutFigures want = measure_cut(range_theory(echoes.waveform, range_step_m, 520, doppler_hz), 50.0);
  EXPECT_NEAR(got.peak, 520.0, 0.02 * 50.0);
  EXPECT_NEAR(got.width, want.width, 0.01 * want.width);
  EXPECT_NEAR(got.pslr_db, want.pslr_db, 0.2);
  EXPECT_NEAR(got.islr_db, want.islr_db, 0.3);

  // 2 s at 200 m/s: lambda R/(2 L cos^2 of the squint) to the first null across the line of sight.
  const double distance_m = core::norm(point - fitted_track(echoes.track).position_m);
  const double azimuth_null_m =
      core::exact_light_speed_mps / 5.3e9 * distance_m / (2.0 * 400.0 * std::cos(c.squint_rad));
  const double azimuth_step_m = azimuth_null_m / 50.0;
  const Values azimuth = cut_through(echoes, point, axes.azimuth, azimuth_step_m, 520, options);
  const CutFigures got_azimuth = measure_cut(azimuth, 50.0);
  const CutFigures want_azimuth = measure_cut(azimuth_theory(echoes, point, axes.azimuth, azimuth_step_m, 520), 50.0);
  EXPECT_NEAR(got_azimuth.peak, 520.0, 0.02 * 50.0);
  EXPECT_NEAR(got_azimuth.width, want_azimuth.width, 0.01 * want_azimuth.width);
  EXPECT_NEAR(got_azimuth.pslr_db, want_azimuth.pslr_db, 0.2);
  EXPECT_NEAR(got_azimuth.islr_db, want_azimuth.islr_db, 0.3);
  // The textbook's figures for a uniform aperture, over ten nulls.
  EXPECT_NEAR(got_azimuth.width, 0.8859 * 50.0, 0.01 * 44.3);
  EXPECT_NEAR(got_azimuth.pslr_db, -13.26, 0.2);
  EXPECT_NEAR(got_azimuth.islr_db, -10.11, 0.3);

  const std::complex<double> peak = azimuth[520];
  EXPECT_NEAR(std::arg(peak), 0.7, 0.01);
  EXPECT_NEAR(std::abs(peak), 2.5, 0.0025 * 2.5);
  std::printf(
      "squint %.2f, width %g: range peak %+.4f cells, width %+.3f %%, PSLR %+.3f dB, ISLR %+.3f dB; azimuth %+.4f, "
      "%+.3f %%, %+.3f, %+.3f; phase %+.5f rad, height %+.5f\n",
      c.squint_rad, c.pulse_width_s, (got.peak - 520.0) / 50.0, 100.0 * (got.width / want.width - 1.0),
      got.pslr_db - want.pslr_db, got.islr_db - want.islr_db, (got_azimuth.peak - 520.0) / 50.0,
      100.0 * (got_azimuth.width / want_azimuth.width - 1.0), got_azimuth.pslr_db - want_azimuth.pslr_db,
      got_azimuth.islr_db - want_azimuth.islr_db, std::arg(peak) - 0.7, std::abs(peak) / 2.5 - 1.0);
}

TEST(BackProjection, FocusesAPointAtBroadsideToItsClosedForm) {
  expect_a_point_as_theory_has_it({0.0, 0.0, true});
  expect_a_point_as_theory_has_it({0.0, 1.6e-6, false});
}

TEST(BackProjection, FocusesASquintedPointToItsClosedForm) {
  expect_a_point_as_theory_has_it({20.0 * core::pi / 180.0, 0.0, true});
  expect_a_point_as_theory_has_it({20.0 * core::pi / 180.0, 1.6e-6, false});
}

// 100 us at 50 MHz: a Doppler of 2.4 kHz moves the compressed peak by a quarter of a range cell.
TEST(BackProjection, TakesTheDopplerShiftWithinAPulseOut) {
  const SarEchoes echoes = test::thesis_echoes(1, 600.0, 20.0 * core::pi / 180.0);
  const core::Vec3 sight = -1.0 * echoes.track[0].position_m;
  const double speed_mps = core::dot(sight, echoes.track[0].velocity_mps) / core::norm(sight);
  const double doppler_hz = 2.0 * speed_mps * echoes.waveform.carrier_hz / echoes.waveform.light_speed_mps;
  EXPECT_GT(doppler_hz * 100e-6, 0.2);
  expect_a_point_as_theory_has_it({20.0 * core::pi / 180.0, 100e-6, false});
}

// 50 kHz of Doppler in pulses of 1 MHz: compression keeps 0.95 of the peak, which the records of each pulse restore.
TEST(EchoRecords, RestoreWhatCompressionLosesOfAPulse) {
  SarWaveform wave = test::thesis_echoes(1, 600.0).waveform;
  wave.bandwidth_hz = 1e6;
  wave.pulse_width_s = 10e-6;
  EXPECT_DOUBLE_EQ(overlap_of(wave, 50e3), 0.95);
  EXPECT_DOUBLE_EQ(overlap_of(wave, -50e3), 0.95);
  EXPECT_DOUBLE_EQ(overlap_of(wave, 5e6), 0.5);
  wave.pulse_width_s = 0.0;
  EXPECT_DOUBLE_EQ(overlap_of(wave, 50e3), 1.0);
  SarEchoes echoes = test::thesis_echoes(40, 600.0, 60.0 * core::pi / 180.0);
  echoes.waveform.pulse_width_s = 2e-6;
  test::write_echoes(echoes, {{{}}}, echoes.track);
  const PointGrid point{{}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1, 1};
  const float kept = std::abs(back_project(echoes, point, {}, {})[0]);
  echoes.waveform.bandwidth_hz *= 0.01;  // fd is 2.4 % of it; echoes and records stay as they are but for that.
  echoes.waveform.pulse_width_s *= 0.01;
  const double doppler_hz = 2.0 * 200.0 * std::sin(core::pi / 3.0) / (core::exact_light_speed_mps / 5.3e9);
  EXPECT_NEAR(std::abs(back_project(echoes, point, {}, {})[0]) / kept, 1.0 / overlap_of(echoes.waveform, doppler_hz),
              2e-3);
}

TEST(BackProjection, HasTheWidthsAndSidelobesOfItsWindows) {
  SarEchoes echoes = test::thesis_echoes(1200, 600.0);
  echoes.waveform.pulse_width_s = 0.0;
  test::write_echoes(echoes, {{{}}}, echoes.track, true);
  BackProjectionOptions options;
  options.start_stop = true;
  options.range_window = core::hamming_window;
  options.aperture = Aperture::beam;
  options.beam_rad = 2.0 * std::asin(150.0 / std::hypot(std::hypot(10e3, 2e3), 150.0));
  options.azimuth_window = core::hamming_window;
  const ResponseAxes axes = response_axes(echoes, {});
  const double range_null_m = 0.5 * core::exact_light_speed_mps / 50e6;
  const double azimuth_null_m = core::exact_light_speed_mps / 5.3e9 * std::hypot(10e3, 2e3) / (2.0 * 300.0);
  for (const auto& [direction, null_m] :
       {std::pair{axes.range, range_null_m}, std::pair{axes.azimuth, azimuth_null_m}}) {
    const Values cut = cut_through(echoes, {}, direction, null_m / 50.0, 520, options);
    const CutFigures figures = measure_cut(cut, 50.0);
    EXPECT_NEAR(figures.width, 1.303 * 50.0, 0.01 * 65.0);
    EXPECT_NEAR(figures.pslr_db, -42.7, 1.0);
    EXPECT_NEAR(std::abs(cut[520]), 1.0, 0.002);
    EXPECT_NEAR(std::arg(cut[520]), 0.0, 0.002);
  }
}

SarEchoes three_points(std::size_t pulses, double squint_rad = 0.0) {
  SarEchoes echoes = test::thesis_echoes(pulses, 600.0, squint_rad);
  test::write_echoes(echoes, {{{}}, {{7.0, -12.0, 0.0}, {0.0, 0.6}}, {{-60.0, 25.0, 3.0}, -0.8}}, echoes.track);
  return echoes;
}

// Rows and columns that fill neither tiles nor vectors, oblique steps.
const PointGrid oblique_grid{{-31.0, -15.0, -2.0}, {0.9, 0.2, 0.03}, {-0.1, 0.7, 0.05}, 45, 75};

double angle_ahead(const core::Vec3& x, const TrackPoint& t) {
  const core::Vec3 r = x - t.position_m;
  return std::asin(core::dot(r, t.velocity_mps) / (core::norm(r) * core::norm(t.velocity_mps)));
}

TEST(BackProjection, IsTheDoublePrecisionSumOnEveryInstructionSet) {
  const SarEchoes echoes = three_points(40, 0.1);
  const Values expected = test::reference_back_projection(echoes, oblique_grid);
  Values first;
  test::on_every_instruction_set([&](std::int64_t target) {
    const Values got = widened(back_project(echoes, oblique_grid, {}, one));
    // The images of the interpolation of 40 pulses, beside a peak of 1.
    EXPECT_LT(largest_difference(got, expected), 1.5e-3) << target;
    if (first.empty()) first = got;
    EXPECT_LT(largest_difference(got, first), 2e-6) << target;
  });
}

TEST(BackProjection, WeighsThePulsesOfABeamByTheirAngleOnEveryInstructionSet) {
  const SarEchoes echoes = three_points(40, 0.1);
  // The points are seen from 0.6 degrees of angle: the beam takes some of the pulses for each.
  BackProjectionOptions options;
  options.aperture = Aperture::beam;
  options.squint_rad = 0.1;
  options.beam_rad = 0.0008;
  for (const bool windowed : {false, true}) {
    if (windowed) options.azimuth_window = [](double x) { return 0.2 + x * (1.5 - x); };
    const auto weight = [&](const core::Vec3& x, const TrackPoint& t) {
      const double place = (angle_ahead(x, t) - options.squint_rad) / options.beam_rad;
      if (std::abs(place) > 0.5) return 0.0;
      return windowed ? options.azimuth_window(place + 0.5) : 1.0;
    };
    const Values expected = test::reference_back_projection(echoes, oblique_grid, false, weight);
    test::on_every_instruction_set([&](std::int64_t target) {
      const Values got = widened(back_project(echoes, oblique_grid, options, one));
      EXPECT_LT(largest_difference(got, expected), 5e-3) << target << windowed;
    });
  }
}

TEST(BackProjection, CountsAnglesFromTheHeadingItIsGivenNotFromThatOfASwayingPulse) {
  SarEchoes echoes = three_points(40, 0.1);
  for (std::size_t p = 0; p < echoes.track.size(); ++p)
    echoes.track[p].velocity_mps.y = 20.0 * std::sin(static_cast<double>(p));  // 0.1 rad
  BackProjectionOptions options;
  options.aperture = Aperture::beam;
  options.heading = {1.0, 0.0, 0.0};
  options.squint_rad = 0.1;
  options.beam_rad = 0.0008;
  const auto weight = [&](const core::Vec3& x, const TrackPoint& t) {
    const core::Vec3 r = x - t.position_m;
    return std::abs(std::asin(r.x / core::norm(r)) - options.squint_rad) > 0.5 * options.beam_rad ? 0.0 : 1.0;
  };
  const Values expected = test::reference_back_projection(echoes, oblique_grid, false, weight);
  test::on_every_instruction_set([&](std::int64_t target) {
    EXPECT_LT(largest_difference(widened(back_project(echoes, oblique_grid, options, one)), expected), 5e-3) << target;
  });
  options.heading = {};
  EXPECT_GT(largest_difference(widened(back_project(echoes, oblique_grid, options, one)), expected), 0.1);
}

TEST(BackProjection, TakesThePulsesOfATimeAboutTheSquintedView) {
  const SarEchoes echoes = three_points(60, 0.1);
  BackProjectionOptions options;
  options.aperture = Aperture::time;
  options.squint_rad = 0.1;
  options.time_s = 0.05;
  options.azimuth_window = core::hamming_window;
  const auto weight = [&](const core::Vec3& x, const TrackPoint& t) {
    const core::Vec3 r = x - t.position_m;
    const double ahead_m = r.x, aside_m = std::hypot(r.y, r.z);  // the flight is along x
    const double place = (ahead_m - std::tan(0.1) * aside_m) / 200.0 / options.time_s;
    return std::abs(place) > 0.5 ? 0.0 : core::hamming_window(place + 0.5);
  };
  const Values expected = test::reference_back_projection(echoes, oblique_grid, false, weight);
  test::on_every_instruction_set([&](std::int64_t target) {
    EXPECT_LT(largest_difference(widened(back_project(echoes, oblique_grid, options, one)), expected), 5e-3) << target;
  });
  EXPECT_GT(std::abs(*std::ranges::max_element(expected, {}, [](auto v) { return std::abs(v); })), 0.5);
}

TEST(BackProjection, GivesTheSameBytesForAnyNumberOfThreads) {
  const SarEchoes echoes = three_points(150);
  BackProjectionOptions options;
  options.aperture = Aperture::beam;
  options.beam_rad = 0.004;
  options.azimuth_window = core::hamming_window;
  for (const BackProjectionOptions& o : {BackProjectionOptions{}, options}) {
    const auto expected = back_project(echoes, oblique_grid, o, one);
    for (const unsigned threads : {2u, 3u, 8u}) {
      const auto got = back_project(echoes, oblique_grid, o, {threads, nullptr});
      EXPECT_EQ(std::memcmp(got.data(), expected.data(), got.size() * sizeof(got[0])), 0) << threads;
    }
  }
}

// Stretches of any length, down to single points, where the antenna comes close.
TEST(BackProjection, IsExactAtAnyDistance) {
  for (const double distance_m : {3.0, 40.0, 150.0, 600.0, 3000.0}) {
    SarEchoes echoes = test::thesis_echoes(30, 600.0);
    echoes.waveform.pulse_width_s = 0.0;
    echoes.track = test::straight_flight({0.0, -distance_m, 0.0}, {200.0, 0.0, 0.0}, 600.0, 30);
    echoes.first_delay_s = std::max(0.0, 2.0 * distance_m / core::exact_light_speed_mps - 1.5e-6);
    test::write_echoes(echoes, {{{}}, {{4.0, 9.0, 0.0}}}, echoes.track);
    const PointGrid grid{{-20.0, -2.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.9, 0.0}, 40, 30};
    const PointGrid turned{{-20.0, -2.0, 0.0}, {0.0, 0.9, 0.0}, {1.0, 0.0, 0.0}, 30, 40};
    for (const PointGrid& g : {grid, turned}) {
      const Values expected = test::reference_back_projection(echoes, g);
      const Values got = widened(back_project(echoes, g, {}, one));
      double largest = 0.0;
      for (const auto& v : expected) largest = std::max(largest, std::abs(v));
      EXPECT_LT(largest_difference(got, expected), 4e-3 * largest) << distance_m;
    }
  }
}

TEST(BackProjection, TakesNothingFromBeyondTheRecordedDelays) {
  SarEchoes echoes = test::thesis_echoes(20, 600.0);
  std::ranges::fill(echoes.volts, 0.0F);
  echoes.volts.assign(echoes.track.size() * echoes.samples, 1.0F);
  const double spacing_m = 0.5 * core::exact_light_speed_mps / 60e6;
  const double near_m = 0.5 * core::exact_light_speed_mps * echoes.first_delay_s;
  // Along the line of sight of the middle of the flight, from before the first sample to behind the last.
  const core::Vec3 antenna = fitted_track(echoes.track).position_m;
  const core::Vec3 sight = (-1.0 / core::norm(antenna)) * antenna;
  const PointGrid grid{antenna + (near_m - 300.0) * sight, {}, spacing_m * sight, 1, 600};
  const auto got = back_project(echoes, grid, {}, one);
  const auto first = static_cast<std::size_t>(300.0 / spacing_m) + 1;
  EXPECT_EQ(got[first - 3], 0.0F);
  EXPECT_NE(got[first + 3], 0.0F);
  EXPECT_NE(got[first + echoes.samples - 5], 0.0F);
  EXPECT_EQ(got[first + echoes.samples + 3], 0.0F);
  EXPECT_EQ(got.front(), 0.0F);
  EXPECT_EQ(got.back(), 0.0F);
}

TEST(BackProjection, OfAPointOutsideTheBeamIsZero) {
  const SarEchoes echoes = three_points(20);
  BackProjectionOptions options;
  options.aperture = Aperture::beam;
  options.squint_rad = 0.5;
  options.beam_rad = 0.01;
  for (const auto& value : back_project(echoes, oblique_grid, options, one)) ASSERT_EQ(value, 0.0F);
}

// The track wavers by half a metre, ten wavelengths; told so, back-projection does not mind.
TEST(BackProjection, FocusesAlongADisturbedTrackAsAlongAnIdealOne) {
  SarEchoes ideal = test::thesis_echoes(1200, 600.0);
  SarEchoes disturbed = ideal;
  for (TrackPoint& t : disturbed.track) {
    t.position_m = t.position_m + core::Vec3{0.1 * std::sin(7.0 * t.time_s), 0.3 * std::sin(3.0 * t.time_s + 0.4),
                                             0.5 * std::cos(5.0 * t.time_s)};
    t.velocity_mps = t.velocity_mps + core::Vec3{0.7 * std::cos(7.0 * t.time_s), 0.9 * std::cos(3.0 * t.time_s + 0.4),
                                                 -2.5 * std::sin(5.0 * t.time_s)};
  }
  test::write_echoes(ideal, {{{}}}, ideal.track);
  test::write_echoes(disturbed, {{{}}}, disturbed.track);
  SarEchoes deceived = disturbed;
  deceived.track = ideal.track;
  const auto figures = [](const SarEchoes& echoes) {
    return measure_cut(cut_through(echoes, {}, {1.0, 0.0, 0.0}, 0.0145, 520), 50.0);
  };
  const CutFigures want = figures(ideal);
  const CutFigures got = figures(disturbed);
  EXPECT_NEAR(got.peak, want.peak, 0.02 * 50.0);
  EXPECT_NEAR(got.width, want.width, 0.01 * want.width);
  EXPECT_NEAR(got.pslr_db, want.pslr_db, 0.2);
  EXPECT_NEAR(got.islr_db, want.islr_db, 0.3);
  EXPECT_NEAR(got.height, want.height, 0.002);
  EXPECT_LT(figures(deceived).height, 0.5);
}

TEST(FocusedImageOfBackProjection, HasThePhaseOfTheClosestDistance) {
  const SarEchoes echoes = three_points(600);
  ImageFrame slant;
  slant.origin_m = {0.0, -10e3, 2e3};
  slant.across = (1.0 / std::hypot(10e3, 2e3)) * core::Vec3{0.0, 10e3, -2e3};
  const double range_m = std::hypot(10e3, 2e3);
  ImageFrame ground;
  ground.plane = ImagePlane::ground_grid;
  ground.across = {0.0, 1.0, 0.0};
  for (const ImageFrame& frame : {slant, ground}) {
    const double middle_m = frame.plane == ImagePlane::slant_range ? range_m : 0.0;
    const FocusedImage image = back_project(echoes, frame, {-8.0, 0.5, 33}, {middle_m - 10.0, 1.0, 21}, {}, one);
    const std::complex<double> peak(image.values[16 * 21 + 10]);
    const double turns = 2.0 * 5.3e9 * range_m / core::exact_light_speed_mps;
    EXPECT_NEAR(std::remainder(std::arg(peak) + 2.0 * core::pi * (turns - std::round(turns)), 2.0 * core::pi), 0.0,
                0.01);
    EXPECT_NEAR(std::abs(peak), 1.0, 0.01);
    EXPECT_EQ(image.carrier_hz, 5.3e9);
    EXPECT_EQ(image.azimuth.count, 33u);
    const ImagePlace place = place_of(image.frame, {0.0, 0.0, 0.0});
    EXPECT_NEAR(image.azimuth.index_of(place.azimuth_m), 16.0, 1e-9);
    EXPECT_NEAR(image.range.index_of(place.range_m), 10.0, 1e-6);
  }
}

TEST(BackProjection, ReportsItsProgressAndStopsWhenAsked) {
  const SarEchoes echoes = three_points(150);
  std::vector<std::size_t> done;
  const auto image = back_project(echoes, oblique_grid, {}, one, [&](const core::Progress& p) {
    EXPECT_EQ(p.total, 150u);
    EXPECT_EQ(p.columns, 45u * 75u);
    done.push_back(p.done);
  });
  EXPECT_EQ(image.size(), 45u * 75u);
  ASSERT_FALSE(done.empty());
  EXPECT_EQ(done.back(), 150u);
  EXPECT_TRUE(std::ranges::is_sorted(done));
  core::StopFlag stop;
  EXPECT_THROW((void)back_project(echoes, oblique_grid, {}, {2, &stop}, [&](const core::Progress&) { stop.request(); }),
               core::Interrupted);
}

TEST(BackProjection, OfNothingIsNothing) {
  SarEchoes echoes = three_points(3);
  EXPECT_TRUE(back_project(echoes, {}, {}, one).empty());
  echoes.track.clear();
  echoes.volts.clear();
  for (const auto& value : back_project(echoes, oblique_grid, {}, one)) ASSERT_EQ(value, 0.0F);
}

TEST(BackProjection, RefusesWhatContradictsItself) {
  const SarEchoes sound = three_points(3);
  const auto refuses = [&](const auto& spoil, const BackProjectionOptions& options = {}) {
    SarEchoes echoes = sound;
    spoil(echoes);
    EXPECT_THROW((void)back_project(echoes, oblique_grid, options, one), std::invalid_argument);
  };
  refuses([](SarEchoes& e) { e.volts.pop_back(); });
  refuses([](SarEchoes& e) { e.waveform.sample_rate_hz = 0.0; });
  refuses([](SarEchoes& e) { e.waveform.light_speed_mps = 0.0; });
  refuses([](SarEchoes& e) { e.waveform.carrier_hz = 0.0; });
  BackProjectionOptions options;
  options.aperture = Aperture::beam;
  refuses([](SarEchoes&) {}, options);
  options.aperture = Aperture::time;
  refuses([](SarEchoes&) {}, options);
  options.aperture = Aperture::all;
  options.squint_rad = 0.5 * core::pi;
  refuses([](SarEchoes&) {}, options);
  options.squint_rad = 0.0;
  options.heading = {2.0, 0.0, 0.0};
  refuses([](SarEchoes&) {}, options);
  options.heading = {};
  options.range_window = core::hamming_window;
  refuses([](SarEchoes& e) { e.waveform.bandwidth_hz = 0.0; }, options);
}

}  // namespace back_projection_test
}  // namespace sarsim::signal
