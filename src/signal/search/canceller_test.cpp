#include "signal/search/canceller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "core/maths/constants.hpp"

namespace sarsim::signal {
namespace canceller_test {

using Volts = std::vector<std::complex<float>>;

TEST(Canceller, TakesDifferencesFromPulseToPulse) {
  const Volts volts{{1, 1}, {10, 0}, {3, 2}, {20, 0}, {9, -4}, {50, 0}};  // three pulses of two samples
  EXPECT_EQ(cancelled(volts, 2, 0), volts);
  EXPECT_EQ(cancelled(volts, 2, 1), (Volts{{2, 1}, {10, 0}, {6, -6}, {30, 0}}));
  EXPECT_EQ(cancelled(volts, 2, 2), (Volts{{4, -7}, {20, 0}}));
  EXPECT_TRUE(cancelled(volts, 2, 3).empty());
}

TEST(Canceller, SilencesWhatRestsAndHasTheGainOfItsFormulaForWhatMoves) {
  constexpr double prf_hz = 1000.0;
  for (const std::size_t order : {1u, 2u, 3u})
    for (const double doppler_hz : {0.0, 30.0, 250.0, 500.0, 700.0, 1000.0}) {
      Volts volts;
      for (int p = 0; p < 12; ++p)
        volts.push_back(std::complex<float>(std::polar(2.0, 0.3 + 2.0 * core::pi * doppler_hz * p / prf_hz)));
      const double gain = canceller_gain(order, doppler_hz, prf_hz);
      for (const auto& v : cancelled(volts, 1, order))
        EXPECT_NEAR(std::norm(std::complex<double>(v)), 4.0 * gain, 1e-4) << order << " " << doppler_hz;
    }
  EXPECT_NEAR(canceller_gain(1, 500.0, prf_hz), 4.0, 1e-12);
  EXPECT_NEAR(canceller_gain(2, 500.0, prf_hz), 16.0, 1e-12);
}

TEST(Canceller, RaisesWhiteNoiseByTheSumOfSquaredWeights) {
  EXPECT_EQ(canceller_noise_gain(0), 1.0);
  EXPECT_EQ(canceller_noise_gain(1), 2.0);
  EXPECT_EQ(canceller_noise_gain(2), 6.0);
  EXPECT_EQ(canceller_noise_gain(3), 20.0);
  std::mt19937_64 random(2);
  std::normal_distribution<float> normal;
  Volts volts(30000);
  for (auto& v : volts) v = {normal(random), normal(random)};
  double power = 0.0;
  const Volts out = cancelled(volts, 1, 2);
  for (const auto& v : out) power += std::norm(std::complex<double>(v)) / static_cast<double>(out.size());
  // Mean power 2 x 6; neighbours are correlated, so that the mean of n has the variance 144 (70/36)/n.
  EXPECT_NEAR(power, 12.0, 5.0 * 12.0 * std::sqrt(70.0 / 36.0 / 30000.0));
}

TEST(Canceller, RefusesPartsOfPulses) {
  const Volts volts(5);
  EXPECT_THROW((void)cancelled(volts, 2, 1), std::invalid_argument);
  EXPECT_THROW((void)cancelled(volts, 0, 1), std::invalid_argument);
}

}  // namespace canceller_test
}  // namespace sarsim::signal
