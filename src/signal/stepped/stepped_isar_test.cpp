#include "signal/stepped/stepped_isar.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "signal/measure/image_quality.hpp"
#include "signal/stepped/isar.hpp"
#include "signal/stepped/stepped_test_support.hpp"

namespace sarsim::signal {
namespace stepped_isar_test {

using test::burst_echoes;

constexpr double c = core::exact_light_speed_mps;
constexpr double interval_s = 125e-6;
const core::WorkControl one{1, nullptr};

// A point of a target that travels and turns in the horizontal plane, seen from the origin.
struct Turning {
  double range_m = 5000.0;
  core::Vec3 velocity_mps{6.0, 8.0, 0.0};
  double rate_radps = 0.05;

  [[nodiscard]] TargetPose pose(double t) const {
    const double a = rate_radps * t;
    return {core::Vec3{0.0, range_m, 0.0} + t * velocity_mps,
            velocity_mps,
            {{core::Vec3{std::cos(a), -std::sin(a), 0.0}, core::Vec3{std::sin(a), std::cos(a), 0.0},
              core::Vec3{0.0, 0.0, 1.0}}},
            {0.0, 0.0, rate_radps}};
  }
  [[nodiscard]] test::SteppedPoint point(const core::Vec3& place_m, double amplitude) const {
    const auto sight = [*this, place_m](double t) {
      const TargetPose p = pose(t);
      const core::Vec3 offset = p.world_from_target * place_m;
      const core::Vec3 r = p.centre_m + offset;
      return std::pair(core::norm(r),
                       core::dot(r, p.velocity_mps + core::cross(p.turn_rate_radps, offset)) / core::norm(r));
    };
    return {[sight](double t) { return sight(t).first; }, [sight](double t) { return sight(t).second; }, amplitude};
  }
};

struct Scene {
  Turning target;
  std::vector<std::pair<core::Vec3, double>> points{
      {{0.0, 0.0, 0.0}, 1.0}, {{14.0, 6.0, 0.0}, 0.8}, {{-11.0, -7.0, 0.0}, 0.7}, {{5.0, -9.0, 0.0}, 0.9}};
  BurstEchoes echoes;
  std::vector<TrackPoint> seen;

  Scene(const SteppedBand& band, const radar::Pulse* pulse, std::size_t bursts, const Turning& turning = {})
      : target(turning) {
    std::vector<test::SteppedPoint> moving;
    for (const auto& [place, amplitude] : points) moving.push_back(target.point(place, amplitude));
    const double start_s = -0.5 * interval_s * static_cast<double>(bursts * band.waveform().burst_pulses());
    echoes = burst_echoes(band, pulse, moving, start_s, interval_s, bursts);
    SarEchoes still;
    std::vector<TargetPose> poses;
    for (const double t : echoes.time_s) {
      still.track.push_back({t, {}, {}});
      poses.push_back(target.pose(t));
    }
    seen = seen_from_target(still, poses).track;
  }
};

SteppedWaveform sampled(std::size_t steps) {
  SteppedWaveform w = test::sampled_waveform(4955.0, 7);
  w.steps = steps;
  return w;
}

// Peak and widths of a point about where it is to be.
PointResponse measured(const FocusedImage& image, const ImagePlace& place) {
  return measure_point(image, reader_of(image), place, 0.6).value();
}

void expect_points(const FocusedImage& image, const Scene& scene, const IsarPlane& plane, double place_error_m,
                   double min_amplitude) {
  for (const auto& [place, amplitude] : scene.points) {
    // A spherical wave: a point aside is farther than its projection on the line of sight by x^2/(2 R).
    const double x = core::dot(place, plane.cross_range);
    const ImagePlace expected{x, core::dot(place, plane.range)};
    const PointResponse found = measured(image, expected);
    EXPECT_NEAR(found.place.azimuth_m, expected.azimuth_m, place_error_m);
    EXPECT_NEAR(found.place.range_m, expected.range_m, place_error_m);
    EXPECT_GT(found.amplitude, min_amplitude * amplitude);
    EXPECT_LT(found.amplitude, 1.1 * amplitude);
  }
}

TEST(IsarPlane, IsSweptByTheLineOfSight) {
  const SteppedBand band(sampled(16));
  const Scene scene(band, nullptr, 64);
  const IsarPlane plane = plane_of(scene.seen);
  EXPECT_NEAR(plane.range_m, 5000.0, 0.01);
  EXPECT_NEAR(plane.range.y, 1.0, 1e-4);
  // The frame turns from x towards y: a point ahead of it recedes.
  EXPECT_NEAR(plane.cross_range.x, 1.0, 1e-4);
  // The target turns, and the line of sight turns with its travelling, 6 m/s in 5 km the other way.
  EXPECT_NEAR(plane.rate_radps, 0.05 + 6.0 / 5000.0, 1e-4);
  EXPECT_EQ(plane.lever[scene.seen.size() / 2], 0.0);
  EXPECT_THROW((void)plane_of(std::span(scene.seen).first(1)), std::invalid_argument);
}

TEST(IsarRangeDoppler, PutsThePointsOfATravellingAndTurningTargetWithinAFractionOfACell) {
  const SteppedBand band(sampled(32));  // 160 MHz: 0.94 m
  const Scene scene(band, nullptr, 160);
  const IsarPlane plane = plane_of(scene.seen);
  const ProfileMaker maker(band, {}, 4980.0, 5020.0, 4);
  const auto motion = motion_of_origin(scene.seen, c);
  const double wavelength_m = c / band.centre_hz();
  const double cell_m = wavelength_m / (2.0 * plane.turn_rad);
  const ImageAxis across{-20.0, cell_m / 4.0, static_cast<std::size_t>(40.0 / cell_m * 4.0) + 1};
  const FocusedImage image = isar_range_doppler(maker, {scene.echoes.values, motion, {}}, plane, across, one);
  EXPECT_LT(cell_m, 0.6);
  expect_points(image, scene, plane, 0.1 * cell_m + 0.05, 0.85);
  const PointResponse centre = measured(image, {0.0, 0.0});
  EXPECT_NEAR(centre.azimuth.width, 0.886 * cell_m, 0.1 * cell_m);
  EXPECT_NEAR(centre.range.width, 0.886 * c / (2.0 * band.band_hz()), 0.1);
  // The same bytes on three threads.
  const FocusedImage again = isar_range_doppler(maker, {scene.echoes.values, motion, {}}, plane, across, {3, nullptr});
  EXPECT_EQ(image.values, again.values);
}

// Without each pulse's own time the image would be sheared by w f T/df = 0.036 m for each metre of cross-range: half a
// metre at 14 m.
TEST(IsarRangeDoppler, TakesTheTurningWithinABurstOut) {
  Turning fast;
  fast.rate_radps = 0.16;
  const SteppedBand band(sampled(32));
  const Scene scene(band, nullptr, 40, fast);
  const IsarPlane plane = plane_of(scene.seen);
  const ProfileMaker maker(band, {}, 4980.0, 5020.0, 4);
  const auto motion = motion_of_origin(scene.seen, c);
  const double cell_m = c / band.centre_hz() / (2.0 * plane.turn_rad);
  const ImageAxis across{-20.0, cell_m / 4.0, static_cast<std::size_t>(40.0 / cell_m * 4.0) + 1};
  const FocusedImage image = isar_range_doppler(maker, {scene.echoes.values, motion, {}}, plane, across, one);
  expect_points(image, scene, plane, 0.12, 0.8);
}

TEST(IsarRangeDoppler, ImagesWithStepsOfChirps) {
  const radar::Pulse pulse = test::chirp_of(12e6, 5e-6);
  const SteppedBand band(test::chirped_waveform(pulse, 9.4e9, 10e6, 16, 20e6, 4950.0, 16));
  const Scene scene(band, &pulse, 120);
  const IsarPlane plane = plane_of(scene.seen);
  const ProfileMaker maker(band, {}, 4980.0, 5020.0, 4);
  const auto motion = motion_of_origin(scene.seen, c);
  const double cell_m = c / band.centre_hz() / (2.0 * plane.turn_rad);
  const ImageAxis across{-20.0, cell_m / 4.0, static_cast<std::size_t>(40.0 / cell_m * 4.0) + 1};
  const FocusedImage image = isar_range_doppler(maker, {scene.echoes.values, motion, {}}, plane, across, one);
  expect_points(image, scene, plane, 0.15 * cell_m + 0.05, 0.8);
}

// 12 degrees: points 14 m aside walk through 2.9 m of range and blur in the image of the first order.
TEST(IsarBackProjection, IsExactForLargeAngles) {
  Turning far;
  far.rate_radps = 0.35;
  const SteppedBand band(sampled(32));
  const Scene scene(band, nullptr, 150, far);
  const IsarPlane plane = plane_of(scene.seen);
  EXPECT_GT(plane.turn_rad, 0.2);
  const double cell_m = c / band.centre_hz() / (2.0 * plane.turn_rad);
  for (const auto& [place, amplitude] : scene.points) {
    const double x = core::dot(place, plane.cross_range);
    const double range_m = plane.range_m + core::dot(place, plane.range);
    const ProfileMaker maker(band, {}, range_m - 5.0, range_m + 5.0, 2);
    const ImageAxis across{x - 0.8, cell_m / 2.0, static_cast<std::size_t>(1.6 / cell_m * 2.0) + 1};
    const FocusedImage image =
        isar_back_projection(maker, {scene.echoes.values, {}, {}}, scene.seen, plane, across, {2, nullptr});
    const PointResponse found = measured(image, {x, core::dot(place, plane.range)});
    EXPECT_NEAR(found.place.azimuth_m, x, 0.1 * cell_m);
    EXPECT_NEAR(found.place.range_m, core::dot(place, plane.range), 0.03);
    EXPECT_NEAR(found.amplitude, amplitude, 0.1 * amplitude);
    EXPECT_NEAR(found.azimuth.width, 0.886 * cell_m, 0.12 * cell_m);
  }
}

TEST(IsarBackProjection, AgreesWithRangeAndDopplerForSmallAnglesAndChirps) {
  const radar::Pulse pulse = test::chirp_of(12e6, 5e-6);
  const SteppedBand band(test::chirped_waveform(pulse, 9.4e9, 10e6, 8, 20e6, 4950.0, 16));
  // 200 m/s: the Doppler shift moves compressed chirps by 0.8 m.
  Turning fast;
  fast.velocity_mps = {6.0, 200.0, 0.0};
  const Scene scene(band, &pulse, 60, fast);
  const IsarPlane plane = plane_of(scene.seen);
  const ProfileMaker maker(band, {}, 4990.0, 5010.0, 2);
  const auto motion = motion_of_origin(scene.seen, c);
  const ImageAxis across{-3.0, 0.5, 13};
  const FocusedImage first = isar_range_doppler(maker, {scene.echoes.values, motion, {}}, plane, across, one);
  const FocusedImage exact = isar_back_projection(maker, {scene.echoes.values, {}, {}}, scene.seen, plane, across, one);
  for (std::size_t i = 0; i < first.values.size(); ++i)
    EXPECT_LT(std::abs(first.values[i] - exact.values[i]), 0.03F) << i;
}

TEST(StoppedIsar, EndsWhenAskedTo) {
  const SteppedBand band(sampled(8));
  const Scene scene(band, nullptr, 4);
  const IsarPlane plane = plane_of(scene.seen);
  const ProfileMaker maker(band, {}, 4990.0, 5010.0, 1);
  const auto motion = motion_of_origin(scene.seen, c);
  core::StopFlag stop;
  stop.request();
  const ImageAxis across{0.0, 1.0, 3};
  EXPECT_THROW((void)isar_range_doppler(maker, {scene.echoes.values, motion, {}}, plane, across, {1, &stop}),
               core::Interrupted);
  EXPECT_THROW((void)isar_back_projection(maker, {scene.echoes.values, {}, {}}, scene.seen, plane, across, {2, &stop}),
               core::Interrupted);
}

TEST(IsarEchoes, ThatContradictThemselvesAreRefused) {
  const SteppedBand band(sampled(8));
  const Scene scene(band, nullptr, 4);
  const IsarPlane plane = plane_of(scene.seen);
  const ProfileMaker maker(band, {}, 4990.0, 5010.0, 1);
  const ImageAxis across{0.0, 1.0, 3};
  const auto motion = motion_of_origin(scene.seen, c);
  const auto values = std::span(scene.echoes.values);
  EXPECT_THROW((void)isar_range_doppler(maker, {values, {}, {}}, plane, across, one), std::invalid_argument);
  EXPECT_THROW((void)isar_range_doppler(maker, {values.first(10), motion, {}}, plane, across, one),
               std::invalid_argument);
  const auto cancelling = [](double x) { return x - 0.5; };
  EXPECT_THROW((void)isar_range_doppler(maker, {values, motion, cancelling}, plane, across, one),
               std::invalid_argument);
}

}  // namespace stepped_isar_test
}  // namespace sarsim::signal
