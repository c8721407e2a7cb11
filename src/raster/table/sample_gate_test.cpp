#include "raster/table/sample_gate.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sarsim::raster::sample_gate_test {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(SampleGate, LetsPassWhatCanBeComputedWith) {
  for (const std::complex<double> usable : {std::complex<double>(0.0, 0.0), {1e28, -1e28}, {-5e-324, 1.0}})
    EXPECT_TRUE(is_usable_sample(usable)) << usable;
  for (const std::complex<double> bad : {std::complex<double>(nan, 0.0), {0.0, nan}, {infinite, 0.0}, {0.0, -1.01e28}})
    EXPECT_FALSE(is_usable_sample(bad)) << bad;
}

TEST(SampleGate, NamesTheSample) {
  const std::string text = core::to_string(unusable_sample("a.npy", 3, 7, {nan, 1.0}));
  EXPECT_THAT(text, HasSubstr("a.npy: error: row 3, sample 7 (from 0) is not a number; found 'nan + 1j V'"));
  EXPECT_THAT(core::to_string(unusable_sample("a.npy", 0, 0, {infinite, 0.0})), HasSubstr("too large to compute with"));
}

}  // namespace sarsim::raster::sample_gate_test
