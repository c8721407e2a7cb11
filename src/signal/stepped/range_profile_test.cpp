#include "signal/stepped/range_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"

namespace sarsim::signal {
namespace range_profile_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double c = core::exact_light_speed_mps;
constexpr int steps = 32;
constexpr double start_hz = 3e9, step_hz = 2e6;
constexpr double bin_m = c / (2.0 * steps * step_hz);
using Row = std::vector<std::complex<double>>;

const WindowFunction rectangular = [](double) { return 1.0; };

// Cycles of the two-way phase are up to 2e5; their rounding times 2 pi is the error of all phases below.
constexpr double phase_error = 2.0 * core::pi * 2e5 * 4.0 * epsilon;

// The echo of a target at the carriers of a burst, the same at every gate.
void add_target(Row& sums, std::size_t gates, double range_m, double amplitude) {
  for (std::size_t n = 0; n < sums.size() / gates; ++n) {
    const double cycles = (start_hz + step_hz * static_cast<double>(n)) * 2.0 * range_m / c;
    for (std::size_t g = 0; g < gates; ++g)
      sums[n * gates + g] += std::polar(amplitude, -2.0 * core::pi * std::remainder(cycles, 1.0));
  }
}

Row profile(const std::vector<double>& gates_m, const Row& sums, const WindowFunction& window = rectangular) {
  const RangeProfiler profiler(gates_m, steps, step_hz, window, c);
  EXPECT_EQ(profiler.gates(), gates_m.size());
  EXPECT_EQ(profiler.steps(), static_cast<std::size_t>(steps));
  Row out(sums.size());
  profiler.profile(sums, out);
  return out;
}

std::complex<double> carrier_phase(double range_m) {
  return std::polar(1.0, -2.0 * core::pi * std::remainder(start_hz * 2.0 * range_m / c, 1.0));
}

TEST(RangeProfiler, PutsATargetIntoItsBinWithItsAmplitudeAndItsPhaseAtTheFirstCarrier) {
  for (const int bin : {0, 1, 7, 31}) {
    const double range_m = 5000.0 + bin * bin_m;
    Row sums(steps);
    add_target(sums, 1, range_m, 4.0);
    const Row out = profile({5000.0}, sums);
    for (int k = 0; k < steps; ++k) {
      const std::complex<double> expected = k == bin ? 4.0 * carrier_phase(range_m) : 0.0;
      EXPECT_LT(std::abs(out[static_cast<std::size_t>(k)] - expected), 4.0 * 4.0 * phase_error) << bin << " " << k;
    }
  }
}

// Between bins the response is Dirichlet's kernel: |sin(pi d)/(S sin(pi d/S))| at d bins from the target.
TEST(RangeProfiler, HasTheResponseOfDirichletsKernelBetweenBins) {
  Row sums(steps);
  add_target(sums, 1, 5000.0 + 9.3 * bin_m, 1.0);
  const Row out = profile({5000.0}, sums);
  for (int k = 0; k < steps; ++k) {
    const double d = k - 9.3;
    EXPECT_NEAR(std::abs(out[static_cast<std::size_t>(k)]),
                std::abs(std::sin(core::pi * d) / (steps * std::sin(core::pi * d / steps))), 4.0 * phase_error);
  }
}

TEST(RangeProfiler, SeparatesTwoTargetsTwoBinsApart) {
  Row sums(steps);
  add_target(sums, 1, 5000.0 + 10.0 * bin_m, 1.0);
  add_target(sums, 1, 5000.0 + 12.0 * bin_m, 0.5);
  const Row out = profile({5000.0}, sums);
  EXPECT_NEAR(std::abs(out[10]), 1.0, 8.0 * phase_error);
  EXPECT_NEAR(std::abs(out[11]), 0.0, 8.0 * phase_error);
  EXPECT_NEAR(std::abs(out[12]), 0.5, 8.0 * phase_error);
}

TEST(RangeProfiler, WrapsAtTheAmbiguousRange) {
  for (const double range_m :
       {5000.0 - 3.0 * bin_m, 5000.0 + (steps - 3.0) * bin_m, 5000.0 + (2.0 * steps - 3.0) * bin_m}) {
    Row sums(steps);
    add_target(sums, 1, range_m, 1.0);
    EXPECT_LT(std::abs(profile({5000.0}, sums)[steps - 3] - carrier_phase(range_m)), 8.0 * phase_error);
  }
}

TEST(RangeProfiler, TreatsEachGateByItsOwnRange) {
  const std::vector<double> gates_m{4990.0, 5000.0 - 2.0 * bin_m, 5000.0};
  Row sums(3 * steps);
  add_target(sums, 3, 5000.0, 1.0);
  for (std::size_t n = 0; n < steps; ++n) sums[n * 3] = 0.0;  // the first gate hears nothing
  const Row out = profile(gates_m, sums);
  for (std::size_t k = 0; k < steps; ++k) EXPECT_EQ(out[k], 0.0);
  EXPECT_NEAR(std::abs(out[steps + 2]), 1.0, 8.0 * phase_error);
  EXPECT_NEAR(std::abs(out[2 * steps]), 1.0, 8.0 * phase_error);
}

TEST(RangeProfiler, WindowKeepsThePeakAndLowersTheSideLobes) {
  const double range_m = 5000.0 + 9.0 * bin_m;
  Row sums(steps), between(steps);
  add_target(sums, 1, range_m, 2.0);
  add_target(between, 1, 5000.0 + 9.5 * bin_m, 2.0);
  EXPECT_LT(std::abs(profile({5000.0}, sums, core::hamming_window)[9] - 2.0 * carrier_phase(range_m)),
            16.0 * phase_error);
  const Row out = profile({5000.0}, between, core::hamming_window);
  for (std::size_t k = 13; k < steps; ++k) EXPECT_LT(std::abs(out[k]), 2.0 * 0.01);  // -40 dB
}

TEST(RangeProfiler, IsSilentWhereTheWindowLeavesNothing) {
  const RangeProfiler profiler({5000.0}, 2, step_hz, core::bartlett_window, c);  // 0 at both ends
  Row out(2);
  profiler.profile(Row{1.0, 1.0}, out);
  EXPECT_EQ(out, Row(2));
}

TEST(RangeProfiler, OfOneStepIsTheSampleItself) {
  const RangeProfiler profiler({5000.0, 6000.0}, 1, step_hz, core::bartlett_window, c);
  const Row sums{{1.0, 2.0}, {-3.0, 0.5}};
  Row out(2);
  profiler.profile(sums, out);
  EXPECT_EQ(out, sums);
}

}  // namespace range_profile_test
}  // namespace sarsim::signal
