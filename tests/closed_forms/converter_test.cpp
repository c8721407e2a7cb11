// The A/D converter on a recorded echo.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/count_fit.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace converter_test {

// Signal over quantisation noise in dB, less what 6.02 b + 1.76 dB says for a sine of this amplitude.
double excess_db(const std::vector<std::complex<double>>& volts, int bits, double amplitude_v, double lsb_v) {
  const auto counts = test::converted(volts, bits, lsb_v);
  double signal = 0.0;
  double noise = 0.0;
  for (std::size_t i = 0; i < volts.size(); ++i) {
    signal += std::norm(volts[i]);
    noise += std::norm(counts[i] * lsb_v - volts[i]);
  }
  // The rule holds for a sine from -2^(b-1) to 2^(b-1) LSB.
  const double full_scale = amplitude_v / lsb_v / std::ldexp(1.0, bits - 1);
  return 10.0 * std::log10(signal / noise) - (6.0206 * bits + 1.7609 + 20.0 * std::log10(full_scale));
}

TEST(Converter, OfBBitsKeepsTheQuantisationNoiseSixDecibelsPerBitBelowAFullScaleSine) {
  // A long chirp: I and Q pass through all phases of full-scale sines.
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].pulse_width_s = 500e-6;
  test::add_target(scene, {1000.0, 0.0, 0.0});
  test::set_window(scene, 1000.0, 1000.0 + 0.5 * core::exact_light_speed_mps * 499e-6, 120e6);
  const simulate::Recording recording = test::recorded(scene);
  const double amplitude_v = recording.report.maximum_v;
  for (const int bits : {6, 8, 10, 12, 16}) {
    // A sine dwells at its ends; where these lie between two counts matters at few bits. The rule is the mean over
    // amplitudes from C - 1 to C counts.
    constexpr int amplitudes = 16;
    double mean_db = 0.0;
    for (int i = 0; i < amplitudes; ++i)
      mean_db += excess_db(recording.samples, bits, amplitude_v,
                           amplitude_v / (radar::full_scale_count(bits) - (i + 0.5) / amplitudes)) /
                 amplitudes;
    std::printf("%2d bits: %+.4f dB from 6.02 b + 1.76 dB, %zu samples\n", bits, mean_db, recording.samples.size());
    // The mean square of N = 60 000 pairs of uniform errors is known to sqrt(2/5)/sqrt(N): 5 sigma are 0.056 dB.
    EXPECT_NEAR(mean_db, 0.0, 0.056) << bits;
  }
}

TEST(Converter, FindsTheBestLsbFromTheLargestMagnitude) {
  scene::Scene scene = test::radar_at_origin();
  test::add_target(scene, {1000.0, 0.0, 0.0});
  scene.simulations[0].bits = 12;
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  const simulate::Recording recording = test::recorded(scene);
  EXPECT_DOUBLE_EQ(simulate::resolved_lsb_v(plan, {}), recording.report.maximum_v / 2047.0);
}

}  // namespace converter_test
}  // namespace sarsim
