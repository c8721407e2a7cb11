#include <gtest/gtest.h>

#include <cmath>

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
