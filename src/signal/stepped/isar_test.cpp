#include "signal/stepped/isar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/maths/window.hpp"
#include "signal/measure/response_test_support.hpp"
#include "signal/sar/sar_test_support.hpp"

namespace sarsim::signal {
namespace isar_test {

const core::WorkControl one{1, nullptr};
constexpr double prf_hz = 500.0;
constexpr double wavelength_m = core::exact_light_speed_mps / 10e9;

// A target that flies past at 80 m/s, 5 km away, and turns by `rate_radps` about the vertical.
struct Turning {
  SarEchoes echoes;
  std::vector<TargetPose> poses;
};

core::Mat3 turned_about_z(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{core::Vec3{c, -s, 0.0}, core::Vec3{s, c, 0.0}, core::Vec3{0.0, 0.0, 1.0}}};
}

// Points of the target in its own frame; they are where their poses put them when a pulse leaves.
Turning turning_target(const std::vector<test::PointTarget>& points, std::size_t pulses, double rate_radps,
                       const core::Vec3& velocity_mps = {80.0, 30.0, 0.0}) {
  Turning t;
  t.echoes.waveform = {10e9, 150e6, 0.0, 200e6, core::exact_light_speed_mps};
  t.echoes.samples = 256;
  t.echoes.first_delay_s = 2.0 * 5000.0 / core::exact_light_speed_mps - 128.0 / 200e6;
  t.echoes.volts.resize(pulses * 256);
  for (std::size_t p = 0; p < pulses; ++p) {
    const double time_s = (static_cast<double>(p) - 0.5 * static_cast<double>(pulses)) / prf_hz;
    t.echoes.track.push_back({time_s, {0.0, -5000.0, 0.0}, {}});
    t.poses.push_back(
        {time_s * velocity_mps, velocity_mps, turned_about_z(rate_radps * time_s), {0.0, 0.0, rate_radps}});
  }
  for (std::size_t p = 0; p < pulses; ++p)
    for (const test::PointTarget& point : points) {
      const TargetPose& pose = t.poses[p];
      const core::Vec3 offset = pose.world_from_target * point.position_m;
      const core::Vec3 r = pose.centre_m + offset - t.echoes.track[p].position_m;
      const double v = core::dot(r, pose.velocity_mps + core::cross(pose.turn_rate_radps, offset)) / core::norm(r);
      const double delay_s = 2.0 * core::norm(r) / (core::exact_light_speed_mps - v);
      const double turns = 10e9 * delay_s;
      for (std::size_t n = 0; n < 256; ++n) {
        const double lag_s = t.echoes.first_delay_s + static_cast<double>(n) / 200e6 - delay_s;
        t.echoes.volts[p * 256 + n] +=
            std::complex<float>(point.strength * test::sinc(150e6 * lag_s) *
                                std::polar(1.0, -2.0 * core::pi * (turns - std::round(turns))));
      }
    }
  return t;
}

TEST(SeenFromTarget, KeepsDistancesAndRangeRatesOfItsPoints) {
  const Turning t = turning_target({}, 40, 0.3);
  const SarEchoes seen = seen_from_target(t.echoes, t.poses);
  for (const core::Vec3& point : {core::Vec3{}, core::Vec3{7.0, -3.0, 2.0}})
    for (std::size_t p = 0; p < 40; p += 13) {
      const TargetPose& pose = t.poses[p];
      const core::Vec3 offset = pose.world_from_target * point;
      const core::Vec3 r = pose.centre_m + offset - t.echoes.track[p].position_m;
      const double v = core::dot(r, pose.velocity_mps + core::cross(pose.turn_rate_radps, offset)) / core::norm(r);
      const core::Vec3 own = point - seen.track[p].position_m;
      EXPECT_NEAR(core::norm(own), core::norm(r), 1e-9);
      EXPECT_NEAR(-core::dot(own, seen.track[p].velocity_mps) / core::norm(own), v, 1e-9);
    }
}

// Eight degrees of turning move a point 12 m from the centre through 1.7 m, almost two range cells.
TEST(IsarImages, FocusATargetThatTurnsThroughManyCells) {
  const double rate_radps = 0.14;
  const std::vector<test::PointTarget> points{{{}}, {{12.0, 5.0, 0.0}, {0.0, 1.0}}, {{-9.0, -8.0, 0.0}, 0.7}};
  const Turning t = turning_target(points, 500, rate_radps);
  // Towards the radar's far side: range along +y of the target, cross-range along +x.
  const double cell_m = wavelength_m / (4.0 * std::sin(0.5 * (rate_radps + 80.0 / 5000.0)));
  for (const test::PointTarget& point : points) {
    const ImageAxis along{point.position_m.x - 5.0, 0.01, 1001}, across{point.position_m.y, 1.0, 1};
    const auto images =
        isar_images(t.echoes, t.poses, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, along, across, {{500, 0, 0, {}}, {}}, one);
    ASSERT_EQ(images.size(), 1u);
    const auto figures = test::measure_cut({images[0].values.begin(), images[0].values.end()}, cell_m / 0.01);
    EXPECT_NEAR(figures.peak, 500.0, 0.02 * cell_m / 0.01);
    EXPECT_NEAR(figures.height, std::abs(point.strength), 0.04);
    EXPECT_NEAR(0.01 * figures.width, 0.886 * cell_m, 0.12 * cell_m);
  }
}

TEST(IsarImages, AreMadeBurstByBurstWithTheirWindow) {
  const Turning t = turning_target({{{}}}, 300, 0.1);
  const ImageAxis axis{-1.0, 1.0, 3}, across{0.0, 1.0, 1};
  const auto images = isar_images(t.echoes, t.poses, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, axis, across,
                                  {{100, 50, 0, core::hamming_window}, core::hamming_window}, one);
  ASSERT_EQ(images.size(), 5u);
  for (const FocusedImage& image : images) EXPECT_NEAR(std::abs(image.values[1]), 1.0F, 0.01F);
}

TEST(IsarRangeDopplerMaps, PutTheCentreAtRestAndPointsAsideAtTheirDoppler) {
  const double rate_radps = 0.05;
  const Turning t = turning_target({{{}}, {{6.0, 0.0, 0.0}, 0.8}}, 256, rate_radps, {0.0, 30.0, 0.0});
  const auto maps = isar_range_doppler_maps(t.echoes, t.poses, {128, 0, 1024, {}}, one);
  ASSERT_EQ(maps.size(), 2u);
  const double m_per_hz = cross_range_m_per_hz(t.echoes, t.poses);
  EXPECT_NEAR(m_per_hz, wavelength_m / (2.0 * rate_radps), 0.01 * m_per_hz);
  for (std::size_t i = 0; i < 2; ++i) {
    const RangeDopplerMap& map = maps[i];
    EXPECT_EQ(map.first_pulse, 128 * i);
    // The centre's range in the middle of its burst.
    const double centre_m = core::norm(t.poses[map.first_pulse + 64].centre_m - core::Vec3{0.0, -5000.0, 0.0});
    const auto gate = static_cast<std::size_t>(
        std::lround((2.0 * centre_m / (core::exact_light_speed_mps - 30.0) - t.echoes.first_delay_s) * 200e6));
    EXPECT_GT(std::abs(map.values[512 * 256 + gate]), 0.85F);
    // The point aside turns with x towards +y: it recedes, half a hertz of Doppler for each millimetre per second.
    const double doppler_hz = -2.0 * 6.0 * rate_radps / wavelength_m;
    EXPECT_NEAR(doppler_hz * m_per_hz, -6.0, 0.1);
    std::size_t top = 0;
    for (std::size_t k = 0; k < 470; ++k)
      if (std::abs(map.values[k * 256 + gate]) > std::abs(map.values[top * 256 + gate])) top = k;
    EXPECT_NEAR(map.doppler_hz(top), doppler_hz, 1.0);
  }
}

// A clutter point at rest near the end of the window, and a target that recedes by 137 samples in a burst: what follows
// it out of the window on one side does not come back on the other.
TEST(IsarRangeDopplerMaps, LoseWhatAFastTargetLeavesBehind) {
  Turning t = turning_target({}, 128, 0.0, {0.0, 400.0, 0.0});
  for (std::size_t p = 0; p < 128; ++p)
    for (std::size_t n = 230; n < 256; ++n)
      t.echoes.volts[p * 256 + n] = static_cast<float>(std::exp(-0.1 * std::pow(static_cast<double>(n) - 245.0, 2)));
  const auto maps = isar_range_doppler_maps(t.echoes, t.poses, {128, 0, 0, {}}, one);
  ASSERT_EQ(maps.size(), 1u);
  float nearer = 0.0F;
  float there = 0.0F;
  for (std::size_t k = 0; k < 128; ++k)
    for (std::size_t n = 0; n < 256; ++n) {
      const float found = std::abs(maps[0].values[k * 256 + n]);
      (n < 100 ? nearer : there) = std::max(n < 100 ? nearer : there, found);
    }
  EXPECT_GT(there, 0.01F);
  EXPECT_LT(nearer, 1e-3F * there);
}

TEST(IsarRangeDopplerMaps, AreEmptyOfPulsesWhoseTargetIsElsewhere) {
  // 16 km in the half second: far more samples than the window has.
  const Turning t = turning_target({{{}}}, 256, 0.0, {0.0, 32000.0, 0.0});
  const auto maps = isar_range_doppler_maps(t.echoes, t.poses, {256, 0, 0, {}}, one);
  ASSERT_EQ(maps.size(), 1u);
  for (const auto& value : maps[0].values) ASSERT_TRUE(std::isfinite(std::abs(value)));
}

TEST(IsarImages, RefuseWhatContradictsItself) {
  Turning t = turning_target({}, 10, 0.1);
  EXPECT_TRUE(isar_range_doppler_maps(t.echoes, t.poses, {11, 0, 0, {}}, one).empty());
  EXPECT_THROW((void)isar_range_doppler_maps(t.echoes, t.poses, {0, 0, 0, {}}, one), std::invalid_argument);
  const IsarBursts cancelling{{10, 0, 0, [](double x) { return x - 0.5; }}, {}};
  EXPECT_THROW((void)isar_images(t.echoes, t.poses, {1, 0, 0}, {0, 1, 0}, {0, 1, 2}, {0, 1, 2}, cancelling, one),
               std::invalid_argument);
  t.poses.pop_back();
  EXPECT_THROW((void)seen_from_target(t.echoes, t.poses), std::invalid_argument);
}

TEST(CrossRange, IsInfiniteWithoutTurning) {
  const Turning t = turning_target({}, 2, 0.0, {});
  EXPECT_TRUE(std::isinf(cross_range_m_per_hz(t.echoes, t.poses)));
}

}  // namespace isar_test
}  // namespace sarsim::signal
