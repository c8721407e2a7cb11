#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/maths/constants.hpp"
#include "signal/sar/back_projection.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/reference_track.hpp"
#include "signal/sar/sar_test_support.hpp"

namespace sarsim::signal {
namespace back_projection_ground_test {

constexpr double height_m = 1500.0;
constexpr double middle_m = 3000.0;  // slant range

// Ka band and 1 GHz; the track sways by 6 cm to the side and up and down.
SarEchoes swaying_echoes(const std::vector<test::PointTarget>& targets) {
  SarEchoes echoes;
  echoes.waveform = {35e9, 1e9, 1e-6, 1.5e9, core::exact_light_speed_mps};
  echoes.track = test::straight_flight({0.0, 0.0, height_m}, {100.0, 0.0, 0.0}, 1000.0, 1200);
  for (TrackPoint& point : echoes.track) {
    const double turn = 2.0 * core::pi * point.time_s / 0.7;
    point.position_m = point.position_m + core::Vec3{0.0, 0.06 * std::sin(turn), 0.06 * std::cos(turn)};
  }
  echoes.samples = 900;
  echoes.first_delay_s = 2.0 * (middle_m - 45.0) / core::exact_light_speed_mps;
  test::write_echoes(echoes, targets, echoes.track);
  return echoes;
}

core::Vec3 ground_at(double along_m, double range_m) {
  return {along_m, std::sqrt(range_m * range_m - height_m * height_m), 0.0};
}

FocusedImage image_of_slant(const SarEchoes& echoes, std::optional<double> ground_m) {
  const ReferenceTrack line = fitted_track(echoes.track);
  ImageFrame frame;
  frame.origin_m = line.at(0.0);
  frame.along = (1.0 / core::norm(line.velocity_mps)) * line.velocity_mps;
  frame.speed_mps = core::norm(line.velocity_mps);
  const core::Vec3 middle = ground_at(0.0, middle_m) - frame.origin_m;
  frame.across = middle - core::dot(middle, frame.along) * frame.along;
  frame.across = (1.0 / core::norm(frame.across)) * frame.across;
  const ImageAxis azimuth{-7.0, 0.07, 200, 0.0};
  const ImageAxis range{middle_m - 30.0, 0.1, 640, 0.0};
  BackProjectionOptions options;
  options.ground_m = ground_m;
  return back_project(echoes, frame, azimuth, range, options, {.threads = 2});
}

// Relative to the ideal one of amplitude 1 and phase -4 pi f R0/c.
std::complex<double> response(const FocusedImage& image, const core::Vec3& point) {
  const ImagePlace place = place_of(image.frame, point);
  return test::value_at(image, place) *
         core::turned_exactly(2.0 * place.range_m * image.carrier_hz / image.light_speed_mps);
}

TEST(BackProjectionOntoSlantRanges, OfLevelGroundHasNoErrorOffMidSwath) {
  for (const double off_m : {-25.0, 0.0, 25.0}) {
    const core::Vec3 point = ground_at(0.3, middle_m + off_m);
    const SarEchoes echoes = swaying_echoes({{point}});
    const std::complex<double> on_ground = response(image_of_slant(echoes, 0.0), point);
    EXPECT_NEAR(20.0 * std::log10(std::abs(on_ground)), 0.0, 0.03) << off_m;
    EXPECT_NEAR(std::arg(on_ground), 0.0, 0.01) << off_m;
    // In the plane through the track and the middle of the swath: 25 m off, 4 pi/lambda * 6 cm * 25 m/(R tan b).
    const std::complex<double> in_plane = response(image_of_slant(echoes, {}), point);
    EXPECT_LT(20.0 * std::log10(std::abs(in_plane)), off_m != 0.0 ? -0.3 : 0.01) << off_m;
  }
}

// A flight that climbs, sways, heaves and turns, above level ground at height 0 that it sees to its left.
struct FlightDraw {
  SarEchoes echoes;
  core::Vec3 point_m;
};

FlightDraw drawn_flight(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double carrier_hz = 1e9 * std::pow(35.0, between(0.0, 1.0));
  const double bandwidth_hz = 100e6;
  const double cell_m = core::exact_light_speed_mps / (2.0 * bandwidth_hz);
  const double above_m = 50.0 * std::pow(160.0, between(0.0, 1.0));
  const double aside_m = above_m * std::pow(60.0, between(-1.0, 0.4));  // from straight below to grazing
  const double squint = std::tan(between(-0.7, 0.7));
  const double climb = std::tan(between(-10.0, 10.0) / core::deg_per_rad);
  const double sway_m = between(0.0, 5.0) * cell_m;
  const double phase = between(0.0, 2.0 * core::pi);
  FlightDraw draw;
  draw.echoes.waveform = {carrier_hz, bandwidth_hz, 0.0, 1.4 * bandwidth_hz, core::exact_light_speed_mps};
  const double range_m = std::hypot(above_m, aside_m) * std::hypot(1.0, squint);
  const double length_m = 0.2 * range_m;
  constexpr std::size_t pulses = 48;
  draw.echoes.track = test::straight_flight({0.0, 0.0, above_m}, {length_m, 0.0, climb * length_m},
                                            static_cast<double>(pulses), pulses);
  const double turn = between(0.0, 0.2) * length_m;
  for (TrackPoint& point : draw.echoes.track) {
    const double angle = phase + 7.0 * point.time_s;
    point.position_m = point.position_m + core::Vec3{0.2 * sway_m * std::sin(2.3 * angle),
                                                     sway_m * std::sin(angle) + turn * point.time_s * point.time_s,
                                                     sway_m * std::cos(1.7 * angle)};
    point.velocity_mps = 100.0 / length_m * point.velocity_mps;
  }
  draw.point_m = {std::hypot(above_m, aside_m) * squint, aside_m, 0.0};
  double min_m = INFINITY, max_m = 0.0;
  for (const TrackPoint& point : draw.echoes.track) {
    min_m = std::min(min_m, core::norm(draw.point_m - point.position_m));
    max_m = std::max(max_m, core::norm(draw.point_m - point.position_m));
  }
  const double sample_m = core::exact_light_speed_mps / (2.0 * draw.echoes.waveform.sample_rate_hz);
  draw.echoes.samples = static_cast<std::size_t>((max_m - min_m) / sample_m) + 300;
  draw.echoes.first_delay_s = 2.0 * (min_m - 150.0 * sample_m) / core::exact_light_speed_mps;
  test::write_echoes(draw.echoes, {{draw.point_m}}, draw.echoes.track);
  return draw;
}

// An image in which a point is one of the samples: at the row and the column that are given.
FocusedImage image_with_sample(const FlightDraw& draw, std::size_t row, std::size_t column) {
  const ReferenceTrack line = fitted_track(draw.echoes.track);
  ImageFrame frame;
  frame.origin_m = line.position_m;
  frame.speed_mps = core::norm(line.velocity_mps);
  frame.along = (1.0 / frame.speed_mps) * line.velocity_mps;
  const core::Vec3 to_point = draw.point_m - frame.origin_m;
  frame.across = to_point - core::dot(to_point, frame.along) * frame.along;
  frame.across = (1.0 / core::norm(frame.across)) * frame.across;
  const ImagePlace place = place_of(frame, draw.point_m);
  const ImageAxis azimuth{place.azimuth_m - 0.3 * static_cast<double>(row), 0.3, row + 3, 0.0};
  const ImageAxis range{place.range_m - 0.4 * static_cast<double>(column), 0.4, 160, 0.0};
  BackProjectionOptions options;
  options.ground_m = 0.0;
  return back_project(draw.echoes, frame, azimuth, range, options, {.threads = 2});
}

// Whatever the track does, each sample of the image is the sum for the point of level ground at its azimuth and range.
TEST(BackProjectionOntoSlantRanges, OfAnyTrackHasThePointsOfTheGroundInAllOfTheSwath) {
  std::mt19937 random(11);
  for (int number = 0; number < 60; ++number) {
    const FlightDraw draw = drawn_flight(random);
    const std::size_t row = number % 2 == 0 ? 61 : 5;
    const std::size_t column = number % 3 == 0 ? 150 : number % 3 == 1 ? 37 : 64;
    const FocusedImage image = image_with_sample(draw, row, column);
    const double range_m = image.range.at(static_cast<double>(column));
    const auto value = std::complex<double>(image.values[row * image.range.count + column]) *
                       core::turned_exactly(2.0 * range_m * image.carrier_hz / image.light_speed_mps);
    // A ten thousandth of a wavelength off the surface is 4 pi 1e-4 rad; the images of the interpolation between
    // records, -47 dB, differ from pulse to pulse.
    const double tolerance = 4.0 * core::pi * 1e-4 + 3.0 * 4.5e-3 / std::sqrt(48.0);
    EXPECT_NEAR(std::abs(value), 1.0, tolerance) << number;
    EXPECT_NEAR(std::arg(value), 0.0, tolerance) << number;
  }
}

TEST(BackProjectionOntoSlantRanges, HasNothingAtRangesOfZeroAndLess) {
  std::mt19937 random(3);
  const FlightDraw draw = drawn_flight(random);
  const ReferenceTrack line = fitted_track(draw.echoes.track);
  ImageFrame frame;
  frame.origin_m = line.position_m;
  frame.along = (1.0 / core::norm(line.velocity_mps)) * line.velocity_mps;
  frame.across = core::cross({0.0, 0.0, 1.0}, frame.along);
  const ImageAxis azimuth{0.0, 1.0, 3, 0.0};
  const double range_m = place_of(frame, draw.point_m).range_m;
  const ImageAxis range{-1.5 * range_m, 0.1 * range_m, 30, 0.0};
  BackProjectionOptions options;
  options.ground_m = 0.0;
  const FocusedImage image = back_project(draw.echoes, frame, azimuth, range, options, {.threads = 1});
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (range.at(static_cast<double>(i % 30)) > 0.0) continue;
    EXPECT_EQ(image.values[i], std::complex<float>()) << i;
  }
}

TEST(PointsOfSlantRanges, LieOnTheGroundAtTheirAzimuthAndRange) {
  ImageFrame frame;
  frame.origin_m = {10.0, 20.0, 700.0};
  frame.along = {0.8, 0.6 * std::cos(0.05), 0.6 * std::sin(0.05)};
  frame.across = {-0.6, 0.8, 0.0};
  const ImageAxis azimuth{-50.0, 1.0, 100, 0.0};
  const ImageAxis range{800.0, 0.5, 400, 0.0};
  const PointGrid grid = points_of(frame, azimuth, range, 12.0);
  for (const double row : {0.0, 31.5, 99.0})
    for (const double column : {0.0, 77.0, 399.0}) {
      const core::Vec3 point = grid.at(row, column);
      const ImagePlace place = place_of(frame, point);
      EXPECT_NEAR(point.z, 12.0, 1e-6);
      EXPECT_NEAR(place.azimuth_m, azimuth.at(row), 1e-6);
      EXPECT_NEAR(place.range_m, range.at(column), 1e-6);
    }
  EXPECT_FALSE(points_of(frame, azimuth, range).curved);
}

}  // namespace back_projection_ground_test
}  // namespace sarsim::signal
