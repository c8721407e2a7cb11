#include "signal/sar/phasor_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace sarsim::signal {
namespace {

// A spectrum of so many cycles per metre whose phase bends by up to `bend_turns` and is displaced to `at`.
std::vector<SpectrumPhasor> spectrum(const ImagePlace& at, double azimuth_per_m, double range_per_m, double bend_turns,
                                     double skew) {
  constexpr int count = 21;
  std::vector<SpectrumPhasor> phasors;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      const double u = 2.0 * i / (count - 1) - 1.0;
      const double v = 2.0 * k / (count - 1) - 1.0;
      SpectrumPhasor phasor{3.0 + 0.5 * azimuth_per_m * u, 40.0 + 0.5 * range_per_m * v, 1.0 + skew * u * v, 0.0};
      phasor.turns = bend_turns * (u * u - v * v * v) - phasor.azimuth_per_m * at.azimuth_m -
                     phasor.range_per_m * at.range_m + 0.3;
      phasors.push_back(phasor);
    }
  return phasors;
}

TEST(PhasorSum, NewtonFindsThePeakThatAGridFinds) {
  std::mt19937 random(54);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int draw = 0; draw < 20; ++draw) {
    const double azimuth_per_m = std::pow(10.0, between(-2.0, 2.0));
    const double range_per_m = std::pow(10.0, between(-2.0, 2.0));
    const ImagePlace at{between(-0.3, 0.3) / azimuth_per_m, between(-0.3, 0.3) / range_per_m};
    const std::vector<SpectrumPhasor> phasors =
        spectrum(at, azimuth_per_m, range_per_m, between(-0.06, 0.06), between(-0.5, 0.5));
    const auto peak = phasor_peak(phasors, {});
    ASSERT_TRUE(peak) << draw;
    const double height = std::abs(phasor_sum(phasors, *peak));
    double highest = 0.0;
    for (int i = -20; i <= 20; ++i)
      for (int k = -20; k <= 20; ++k)
        highest = std::max(highest, std::abs(phasor_sum(phasors, {0.04 * i / azimuth_per_m, 0.04 * k / range_per_m})));
    EXPECT_GT(height, highest * (1.0 - 1e-12)) << draw;
    EXPECT_LT(height, highest * (1.0 + 2e-3)) << draw;
    for (const double aside : {-1e-3, 1e-3}) {
      EXPECT_LT(std::abs(phasor_sum(phasors, {peak->azimuth_m + aside / azimuth_per_m, peak->range_m})), height);
      EXPECT_LT(std::abs(phasor_sum(phasors, {peak->azimuth_m, peak->range_m + aside / range_per_m})), height);
    }
  }
}

TEST(PhasorSum, WithoutPhasesThePeakIsAtTheDisplacement) {
  const ImagePlace at{0.2, -0.001};
  const auto peak = phasor_peak(spectrum(at, 1.0, 100.0, 0.0, 0.0), {});
  ASSERT_TRUE(peak);
  EXPECT_NEAR(peak->azimuth_m, at.azimuth_m, 1e-7);
  EXPECT_NEAR(peak->range_m, at.range_m, 1e-9);
}

TEST(PhasorSum, AnAxisOfOneWaveNumberKeepsItsPlace) {
  std::vector<SpectrumPhasor> phasors;
  for (int i = -10; i <= 10; ++i) phasors.push_back({0.1 * i, 7.0, 1.0, -0.1 * i * 0.125});
  const auto peak = phasor_peak(phasors, {0.0, 0.25});
  ASSERT_TRUE(peak);
  EXPECT_NEAR(peak->azimuth_m, 0.125, 1e-6);
  EXPECT_EQ(peak->range_m, 0.25);
}

TEST(PhasorSum, BetweenTwoPeaksThereIsNone) {
  // 1 - 0.4 cos(2 pi x) is smallest at 0.
  const std::vector<SpectrumPhasor> phasors{{-1.0, 0.0, 0.2, 0.5}, {0.0, 0.0, 1.0, 0.0}, {1.0, 0.0, 0.2, 0.5}};
  EXPECT_FALSE(phasor_peak(phasors, {}));
  EXPECT_FALSE(phasor_peak({}, {}));
}

}  // namespace
}  // namespace sarsim::signal
