// Compressed pulses against their autocorrelation functions.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/response.hpp"

namespace sarsim {
namespace compression_test {

using test::Response;

constexpr double bandwidth_hz = 50e6;
constexpr double fine = 64.0;  // samples per 1/B

scene::Scene chirp(double time_bandwidth) {
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = bandwidth_hz;
  scene.radars[0].pulse_width_s = time_bandwidth / bandwidth_hz;
  scene.simulations[0].sample_rate_hz = fine * bandwidth_hz;
  return scene;
}

// Autocorrelation of a chirp of rectangular envelope: sin(pi B s (1 - |s|/Tp))/(pi B s) (Cook and Bernfeld 1967).
double chirp_autocorrelation(double lag_s, double width_s) {
  if (lag_s == 0.0) return 1.0;
  const double x = core::pi * bandwidth_hz * lag_s;
  return std::abs(std::sin(x * (1.0 - std::abs(lag_s) / width_s)) / x);
}

TEST(CompressedChirp, IsTheAutocorrelationSampleBySample) {
  for (const double time_bandwidth : {25.0, 200.0}) {
    const Response r = test::point_response(chirp(time_bandwidth), 8 * 64);
    double worst = 0.0;
    for (std::size_t i = 0; i < r.amplitude.size(); ++i)
      worst = std::max(worst,
                       std::abs(r.amplitude[i] - chirp_autocorrelation(r.delay_s(i), time_bandwidth / bandwidth_hz)));
    // The sum over N samples differs from the integral by (pi B s/N)^2/6 of a lobe of height 1/(pi B s), and the lags
    // to the left overlap by one sample less: 1/N.
    const double samples = fine * time_bandwidth;
    EXPECT_LT(worst, 1.0 / samples + core::pi * 8.0 / (6.0 * samples * samples)) << time_bandwidth;
  }
}

TEST(CompressedChirp, HasTheSideLobesAndWidthsOfTheTable) {
  struct Row {
    double time_bandwidth;
    double side_lobe_db;
    double width;  // times B
  };
  for (const Row& row : {Row{25.0, -13.81, 0.8800}, Row{50.0, -13.52, 0.8831}, Row{100.0, -13.39, 0.8845},
                         Row{200.0, -13.32, 0.8852}, Row{1000.0, -13.27, 0.8858}}) {
    const Response r = test::point_response(chirp(row.time_bandwidth), 8 * 64);
    const double side_db = test::side_lobe_db(r);
    const double width = test::half_power_width_s(r) * bandwidth_hz;
    std::printf("TB %5g: side lobe %.3f dB, table %.2f; width %.5f/B, table %.4f\n", row.time_bandwidth, side_db,
                row.side_lobe_db, width, row.width);
    EXPECT_NEAR(side_db, row.side_lobe_db, 0.02) << row.time_bandwidth;
    EXPECT_NEAR(width, row.width, 0.0005) << row.time_bandwidth;
  }
}

TEST(CompressedChirp, KeepsAmplitudeAndPhaseOfTheRawEcho) {
  // Also a down chirp, an envelope and a window on top.
  for (const double sweep_hz : {bandwidth_hz, -bandwidth_hz})
    for (const bool shaped : {false, true}) {
      scene::Scene scene = chirp(100.0);
      scene.radars[0].bandwidth_hz = sweep_hz;
      if (shaped) {
        scene.radars[0].envelope = scene::Radar::Envelope::linear;
        scene.radars[0].rise_s = 0.2e-6;
        scene.radars[0].fall_s = 0.5e-6;
        scene.radars[0].window = scene::Radar::Window::hamming;
      }
      const double range_m = 1000.0 + 100.0 * core::exact_light_speed_mps / (2.0 * fine * bandwidth_hz);
      test::add_target(scene, {range_m, 0.0, 0.0});
      test::set_window(scene, 1000.0, 1000.0 + 200.0 * core::exact_light_speed_mps / (2.0 * fine * bandwidth_hz),
                       fine * bandwidth_hz);
      scene.simulations[0].processing = scene::Processing::matched_filter;
      const auto samples = test::recorded(scene).samples;
      const double wavelength_m = core::exact_light_speed_mps / 1e9;
      const std::complex<double> expected =
          std::polar(std::sqrt(1000.0) * wavelength_m / (std::pow(4.0 * core::pi, 1.5) * range_m * range_m),
                     -4.0 * core::pi * std::remainder(range_m / wavelength_m, 0.5));
      EXPECT_LT(std::abs(samples[100] - expected), 1e-8 * std::abs(expected)) << sweep_hz << shaped;
      EXPECT_EQ(test::peak_index(samples), 100u);
    }
}

TEST(CompressedMonochrome, IsATriangleWithABaseOfTwicePulseWidth) {
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].pulse_width_s = 1e-6;
  scene.simulations[0].sample_rate_hz = 200e6;
  const Response r = test::point_response(scene, 300);
  for (std::size_t i = 0; i < r.amplitude.size(); ++i) {
    const double lag = std::abs(static_cast<double>(i) - 300.0) / 200.0;
    EXPECT_NEAR(r.amplitude[i], std::max(0.0, 1.0 - lag), 1e-12) << i;
  }
}

TEST(CompressedBarker13, HasSideLobesOfOneThirteenth) {
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].pulse = scene::Radar::Pulse::barker;
  scene.radars[0].barker_code = 6;
  scene.radars[0].pulse_width_s = 1.3e-6;
  scene.simulations[0].sample_rate_hz = 100e6;  // ten samples a chip
  const Response r = test::point_response(scene, 150);
  for (int chip = 0; chip <= 13; ++chip)
    for (const int side : {-1, 1}) {
      const double expected = chip == 0 ? 1.0 : (chip % 2 == 0 && chip < 13 ? 1.0 / 13.0 : 0.0);
      EXPECT_NEAR(r.amplitude[static_cast<std::size_t>(150 + side * 10 * chip)], expected, 1e-12) << chip;
    }
  EXPECT_NEAR(test::side_lobe_db(r), -22.28, 0.005);
}

TEST(Resolution, IsTheHalfPowerWidthTimesHalfTheSpeedOfLight) {
  // 0.443 c/B: two targets that far apart in quadrature show a dip, at half of it they do not.
  const Response r = test::point_response(chirp(1000.0), 8 * 64);
  const double width_m = 0.5 * core::exact_light_speed_mps * test::half_power_width_s(r);
  EXPECT_NEAR(width_m, 0.443 * core::exact_light_speed_mps / bandwidth_hz, 0.001 * width_m);
}

}  // namespace compression_test
}  // namespace sarsim
