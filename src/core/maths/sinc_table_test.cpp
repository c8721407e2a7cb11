#include "core/maths/sinc_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/turns.hpp"

namespace sarsim::core {
namespace sinc_table_test {

// Largest error over positions of tones within a band.
double worst_error(const SincTable& table, double band) {
  constexpr std::size_t size = 96;
  double worst = 0.0;
  for (double hz = -0.5 * band; hz <= 0.5 * band + 1e-12; hz += band / 16.0) {
    std::vector<std::complex<float>> tone(size);
    for (std::size_t n = 0; n < size; ++n)
      tone[n] = std::complex<float>(std::polar(1.0, 2.0 * pi * hz * static_cast<double>(n)));
    for (double position = 40.0; position < 42.0; position += 0.0137) {
      const std::complex<double> truth = std::polar(1.0, 2.0 * pi * hz * position);
      worst = std::max(worst, std::abs(std::complex<double>(table.value(tone, position)) - truth));
    }
  }
  return worst;
}

TEST(SincTable, IsAsExactAsItSays) {
  EXPECT_LT(worst_error(SincTable(2.0 / 3.0), 2.0 / 3.0), 1e-3);
  EXPECT_LT(worst_error(SincTable(0.75), 0.75), 2e-3);
  EXPECT_LT(worst_error(SincTable(0.85), 0.85), 2e-2);
}

TEST(SincTable, TakesSamplesOutsideForZeroOrRepeatsThem) {
  const SincTable table(0.7);
  std::vector<std::complex<float>> samples(32);
  samples[0] = 1.0F;
  EXPECT_NEAR(std::abs(table.value(samples, 0.0)), 1.0, 1e-6);
  EXPECT_NEAR(std::abs(table.value(samples, 32.0)), 0.0, 1e-6);
  EXPECT_EQ(table.value(samples, 1000.0), std::complex<float>());
  EXPECT_EQ(table.value(samples, -1000.0), std::complex<float>());
  EXPECT_NEAR(std::abs(table.circular(samples, 32.0)), 1.0, 1e-6);
  EXPECT_NEAR(std::abs(table.circular(samples, -32.0)), 1.0, 1e-6);
}

TEST(Turned, IsThePhasorOfItsTurns) {
  for (double turns = -3.0; turns < 3.0; turns += 0.00371) {
    const std::complex<double> truth = std::polar(1.0, 2.0 * pi * turns);
    EXPECT_LT(std::abs(std::complex<double>(turned(turns)) - truth), 2e-7) << turns;
    EXPECT_LT(std::abs(std::complex<double>(turned(turns + 1048576.0)) - truth), 2e-7) << turns;
  }
}

}  // namespace sinc_table_test
}  // namespace sarsim::core
