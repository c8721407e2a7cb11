#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "signal/sar/focusing.hpp"
#include "signal/sar/image_test_value.hpp"
#include "signal/sar/sar_test_scene.hpp"

namespace sarsim::signal {
namespace focusing_outside_test {

using namespace sar_test;

class FocusingOutside : public testing::TestWithParam<FocusMethod> {};

INSTANTIATE_TEST_SUITE_P(Methods, FocusingOutside,
                         testing::Values(FocusMethod::omega_k, FocusMethod::range_doppler, FocusMethod::chirp_scaling));

// X band at 3 km: Doppler frequencies fall by 222 Hz in a second.
Setting short_flight(std::size_t pulses) {
  Setting setting;
  setting.speed_mps = 100.0;
  setting.height_m = 1000.0;
  setting.ground_m = std::sqrt(3000.0 * 3000.0 - 1e6);
  setting.prf_hz = 1000.0;
  setting.pulses = pulses;
  setting.swath_m = 200.0;
  setting.waveform = {9.6e9, 50e6, 1e-6, 75e6, 299792458.0};
  return setting;
}

// Pulses of a flight of 95 m sample the Doppler frequency of a point 200 m ahead, 425 Hz; it stands far outside the
// image, which is 119 m long.
TEST_P(FocusingOutside, PointsBesideTheImageStayOutOfIt) {
  const Setting setting = short_flight(950);
  for (const double along_m : {-330.0, -200.0, 130.0, 200.0, 230.0}) {
    const FocusedImage image = focus(make_echoes(setting, {{point_at(setting, along_m, 3000.0), 1.0, {}}}),
                                     {.method = GetParam()}, {.threads = 2});
    ASSERT_GT(std::abs(along_m), std::abs(image.azimuth.first_m) + 50.0);
    float largest = 0.0F;
    for (const std::complex<float>& value : image.values) largest = std::max(largest, std::abs(value));
    // Side lobes of a response 0.5 m wide, 70 m off: 0.5/(pi 70).
    EXPECT_LT(largest, 0.01F) << along_m;
  }
}

// Points at the very ends of the image are seen by all pulses.
TEST_P(FocusingOutside, PointsAtTheEndsOfTheImageKeepTheirAmplitude) {
  const Setting setting = short_flight(950);
  for (const double along_m : {-58.0, 0.0, 58.0}) {
    const core::Vec3 point = point_at(setting, along_m, 3000.0);
    const FocusedImage image = focus(make_echoes(setting, {{point, 1.0, {}}}), {.method = GetParam()}, {.threads = 2});
    const auto row = static_cast<std::size_t>(std::lround(image.azimuth.index_of(along_m)));
    double largest = 0.0;
    for (std::size_t n = 0; n < image.range.count; ++n)
      largest = std::max(largest, static_cast<double>(std::abs(image.values[row * image.range.count + n])));
    // The nearest of the columns 2 m apart, of a response 2.7 m wide, is within 1 m.
    EXPECT_GT(largest, 0.80) << along_m;
    EXPECT_LT(largest, 1.02) << along_m;
  }
}

// The image is the mean of the pulses: of N of them, noise keeps 1/N of its power.
TEST_P(FocusingOutside, NoiseOfAShortFlightIsThatOfTheMeanOfItsPulses) {
  for (const std::size_t pulses : {40u, 200u, 950u}) {
    const Setting setting = short_flight(pulses);
    SarEchoes echoes = make_echoes(setting, {});
    std::mt19937_64 random(5);
    std::normal_distribution<float> normal(0.0F, std::sqrt(0.5F));
    for (std::complex<float>& value : echoes.volts) value = {normal(random), normal(random)};
    const FocusedImage image = focus(echoes, {.method = GetParam()}, {.threads = 2});
    double power = 0.0;
    std::size_t count = 0;
    for (std::size_t r = image.azimuth.count / 4; r < image.azimuth.count * 3 / 4; ++r)
      for (std::size_t n = image.range.count / 4; n < image.range.count * 3 / 4; ++n, ++count)
        power += std::norm(std::complex<double>(image.values[r * image.range.count + n]));
    // 50 columns and as many independent rows as the response is narrower than the image: few of a short flight.
    const double looks = 50.0 * std::max(1.0, 222.0 * std::pow(static_cast<double>(pulses) / 1000.0, 2));
    EXPECT_NEAR(10.0 * std::log10(power / static_cast<double>(count) * static_cast<double>(pulses)), 0.0,
                0.3 + 5.0 * 4.3 / std::sqrt(looks))
        << pulses;
  }
}

}  // namespace focusing_outside_test
}  // namespace sarsim::signal
