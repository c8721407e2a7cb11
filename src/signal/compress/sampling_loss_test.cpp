#include "signal/compress/sampling_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::signal {
namespace sampling_loss_test {

radar::Pulse mono(double width_s) {
  radar::Pulse pulse;
  pulse.width_s = width_s;
  return pulse;
}

radar::Pulse coded(double width_s) {
  radar::Pulse pulse;
  pulse.kind = radar::Pulse::Kind::code;
  pulse.code = radar::barker_code(6);
  pulse.width_s = width_s;
  return pulse;
}

radar::Pulse chirp(double width_s, double sweep_hz) {
  radar::Pulse pulse;
  pulse.kind = radar::Pulse::Kind::chirp;
  pulse.width_s = width_s;
  pulse.sweep_hz = sweep_hz;
  return pulse;
}

// 2.5 samples are 2 or 3 of the same value: correlated with three taps two thirds or less of the peak remain. The
// response of two samples that meet three taps is that of a triangle cut by one: 2/3 at two samples, 0.7074 between.
TEST(SamplingLoss, IsThatOfTheSamplesThatAPulseCovers) {
  const SamplingLoss loss = sampling_loss(mono(50e-9), 50e6);
  EXPECT_NEAR(loss.max_db, 3.007, 0.01);
  EXPECT_NEAR(loss.mean_db, -20.0 * std::log10(0.5 * (1.0 + std::pow(10.0, -3.007 / 20.0))), 0.01);
  EXPECT_NEAR(loss.max_shift_s * 50e6, 0.5, 0.07);
}

// Whole samples: no amplitude is lost, and the peak is that of the first sample, up to an interval late.
TEST(SamplingLoss, OfWholeSamplesIsAShiftOnly) {
  const SamplingLoss loss = sampling_loss(mono(50e-9), 80e6);
  EXPECT_LT(loss.max_db, 0.01);
  EXPECT_NEAR(loss.max_shift_s * 80e6, 1.0, 0.04);
}

TEST(SamplingLoss, OfACodeIsThatOfItsChipsEdges) {
  EXPECT_NEAR(sampling_loss(coded(650e-9), 25e6).max_db, 2.625, 0.01);
  EXPECT_NEAR(sampling_loss(coded(650e-9), 79e6).max_db, 0.783, 0.01);
  EXPECT_LT(sampling_loss(coded(650e-9), 2e9).max_db, 0.02);
}

// As one over the time-bandwidth product.
TEST(SamplingLoss, OfAChirpFallsWithItsProduct) {
  EXPECT_NEAR(sampling_loss(chirp(1e-6, 10e6), 12e6).max_db, 0.895, 0.01);
  EXPECT_NEAR(sampling_loss(chirp(1e-6, 100e6), 120e6).max_db, 0.1014, 0.002);
  EXPECT_NEAR(sampling_loss(chirp(1e-6, 100e6), 120e6).mean_db, 0.0622, 0.002);
  EXPECT_EQ(sampling_loss(chirp(10e-6, 100e6), 120e6).max_db, 0.0);
}

TEST(SamplingLoss, OfLongCodesTakesTheirFirstChips) {
  radar::Pulse pulse = coded(650e-9);
  for (int times = 0; times < 12; ++times) pulse.code.insert(pulse.code.end(), pulse.code.begin(), pulse.code.end());
  pulse.width_s *= 4096.0;
  const SamplingLoss loss = sampling_loss(pulse, 41e6);
  EXPECT_GT(loss.mean_db, 0.2);
  EXPECT_LT(loss.mean_db, 3.0);
}

}  // namespace sampling_loss_test
}  // namespace sarsim::signal
