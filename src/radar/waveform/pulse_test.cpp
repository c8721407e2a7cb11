

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/maths/constants.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::radar {
namespace pulse_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

core::Interpolator function(std::vector<core::Knot> knots, core::Interpolation method = core::Interpolation::linear) {
  return core::Interpolator(core::SampledFunction{method, std::move(knots)});
}

Pulse chirp(double sweep_hz, double width_s) {
  Pulse pulse;
  pulse.kind = Pulse::Kind::chirp;
  pulse.sweep_hz = sweep_hz;
  pulse.width_s = width_s;
  return pulse;
}

TEST(BarkerCode, HasTheSevenKnownCodes) {
  const std::string expected[] = {"+-", "++-", "++-+", "+++-+", "+++--+-", "+++---+--+-", "+++++--++-+-+"};
  for (int i = 0; i < 7; ++i) {
    std::string signs;
    for (const int chip : barker_code(i)) signs += chip > 0 ? '+' : '-';
    EXPECT_EQ(signs, expected[i]);
  }
}

// What makes a Barker code: aperiodic autocorrelation side lobes of magnitude 1 at most.
TEST(BarkerCode, AutocorrelationHasSideLobesOfAtMostOne) {
  for (int i = 0; i < 7; ++i) {
    const auto& code = barker_code(i);
    for (std::size_t lag = 0; lag < code.size(); ++lag) {
      int sum = 0;
      for (std::size_t n = 0; n + lag < code.size(); ++n) {
        EXPECT_EQ(std::abs(code[n]), 1);
        sum += code[n] * code[n + lag];
      }
      if (lag == 0)
        EXPECT_EQ(sum, static_cast<int>(code.size()));
      else
        EXPECT_LE(std::abs(sum), 1) << "code " << i << ", lag " << lag;
    }
  }
}

TEST(Pulse, MonochromeIsOne) {
  Pulse pulse;
  EXPECT_EQ(pulse.value(0.0), 1.0);
  EXPECT_EQ(pulse.value(0.7e-6), 1.0);
  EXPECT_EQ(pulse.sweep_rate_hz_per_s(), 0.0);
}

// The phase is quadratic, so that the central difference over any step gives the frequency exactly.
TEST(Pulse, ChirpSweepsFromMinusHalfTheBandwidthThroughZeroAtItsCentre) {
  const Pulse pulse = chirp(100e6, 2e-6);
  EXPECT_DOUBLE_EQ(pulse.sweep_rate_hz_per_s(), 5e13);
  constexpr double h = 1e-9;
  const auto frequency_hz = [&](double t) {
    return std::arg(pulse.value(t + h) * std::conj(pulse.value(t - h))) / (4.0 * core::pi * h);
  };
  EXPECT_EQ(pulse.value(1e-6), 1.0);
  for (const double t : {h, 0.4e-6, 1e-6, 1.3e-6, 2e-6 - h})
    // Phases up to pi K Tp^2/4 = 157 rad are rounded to 157 epsilon.
    EXPECT_NEAR(frequency_hz(t), 5e13 * (t - 1e-6), 2.0 * 157.0 * epsilon / (4.0 * core::pi * h) * 2.0);
}

TEST(Pulse, DownChirpIsTheConjugateOfTheUpChirp) {
  const Pulse up = chirp(20e6, 3e-6), down = chirp(-20e6, 3e-6);
  for (const double t : {0.0, 0.3e-6, 1.5e-6, 2.2e-6}) EXPECT_EQ(down.value(t), std::conj(up.value(t)));
}

TEST(Pulse, CodeChangesSignAtTheChipBordersAndToleratesRounding) {
  Pulse pulse;
  pulse.kind = Pulse::Kind::code;
  pulse.code = barker_code(4);  // +++--+-
  pulse.width_s = 7e-6;
  const double signs[] = {1, 1, 1, -1, -1, 1, -1};
  for (int chip = 0; chip < 7; ++chip) EXPECT_EQ(pulse.value((chip + 0.5) * 1e-6), signs[chip]);
  EXPECT_EQ(pulse.value(0.0), 1.0);
  EXPECT_EQ(pulse.value(3e-6 - 1e-16), 1.0);
  EXPECT_EQ(pulse.value(3e-6 - 1e-16, 1e-15), -1.0);
  EXPECT_EQ(pulse.value(7e-6 - 1e-16, 1e-15), -1.0);  // the last chip has no successor
}

TEST(Pulse, UserPulseIsReadAtTheFractionOfItsWidth) {
  Pulse pulse;
  pulse.kind = Pulse::Kind::user;
  pulse.width_s = 4e-6;
  pulse.in_phase = function({{0.0, 0.0}, {1.0, 8.0}});
  pulse.quadrature = function({{0.0, 2.0}, {1.0, -2.0}});
  pulse.envelope = Pulse::Envelope::user;
  pulse.envelope_gain = function({{0.0, 1.0}, {1.0, 0.0}});
  const std::complex<double> value = pulse.value(1e-6);
  EXPECT_NEAR(value.real(), 0.75 * 2.0, 10.0 * epsilon);
  EXPECT_NEAR(value.imag(), 0.75 * 1.0, 10.0 * epsilon);
}

TEST(Pulse, LinearEnvelopeRisesAndFalls) {
  Pulse pulse = chirp(1e6, 10e-6);
  pulse.envelope = Pulse::Envelope::linear;
  pulse.rise_s = 2e-6;
  pulse.fall_s = 4e-6;
  EXPECT_EQ(pulse.envelope_value(0.0), 0.0);
  EXPECT_NEAR(pulse.envelope_value(0.5e-6), 0.25, 2.0 * epsilon);
  EXPECT_EQ(pulse.envelope_value(2e-6), 1.0);
  EXPECT_EQ(pulse.envelope_value(6e-6), 1.0);
  EXPECT_NEAR(pulse.envelope_value(9e-6), 0.25, 10.0 * epsilon);
  EXPECT_NEAR(std::abs(pulse.value(9e-6)), 0.25, 10.0 * epsilon);
}

TEST(Pulse, LinearEnvelopeOfNoRiseAndFallIsOne) {
  Pulse pulse;
  pulse.envelope = Pulse::Envelope::linear;
  for (const double t : {0.0, 0.5e-6, std::nextafter(1e-6, 0.0)}) EXPECT_EQ(pulse.envelope_value(t), 1.0);
}

TEST(Pulse, LinearEnvelopeWhoseRampsOverlapTakesTheLowerRamp) {
  Pulse pulse;
  pulse.width_s = 4e-6;
  pulse.envelope = Pulse::Envelope::linear;
  pulse.rise_s = 4e-6;
  pulse.fall_s = 4e-6;
  EXPECT_NEAR(pulse.envelope_value(1e-6), 0.25, 2.0 * epsilon);
  EXPECT_NEAR(pulse.envelope_value(3e-6), 0.25, 2.0 * epsilon);
}

TEST(Pulse, BreaksAreTheBordersAndKnotsInside) {
  Pulse pulse;
  pulse.width_s = 2.0;
  EXPECT_TRUE(pulse.breaks_s().empty());
  pulse.kind = Pulse::Kind::code;
  pulse.code = {1, -1, 1, 1};
  EXPECT_EQ(pulse.breaks_s(), (std::vector<double>{0.5, 1.0, 1.5}));
  pulse.envelope = Pulse::Envelope::linear;
  pulse.rise_s = 0.25;
  pulse.fall_s = 0.5;  // its corner coincides with the third border
  EXPECT_EQ(pulse.breaks_s(), (std::vector<double>{0.25, 0.5, 1.0, 1.5}));
  pulse.rise_s = 1.5;  // meets the fall before either is over
  pulse.fall_s = 1.0;
  EXPECT_EQ(pulse.breaks_s(), (std::vector<double>{0.5, 1.0, 1.2, 1.5}));
  pulse.kind = Pulse::Kind::user;
  pulse.in_phase = function({{0.0, 0.0}, {0.375, 1.0}, {1.0, 0.0}});
  pulse.quadrature = function({{0.0, 0.0}, {0.75, 1.0}, {1.5, 0.0}});
  pulse.envelope = Pulse::Envelope::rectangular;
  EXPECT_EQ(pulse.breaks_s(), (std::vector<double>{0.75, 1.5}));
}

TEST(Bandwidth, IsTheSweepTheChipRateOrTheInverseWidth) {
  Pulse mono;
  mono.width_s = 4e-6;
  EXPECT_EQ(bandwidth_hz(mono), 1.0 / 4e-6);
  EXPECT_EQ(bandwidth_hz(chirp(-30e6, 1e-6)), 30e6);
  Pulse code = mono;
  code.kind = Pulse::Kind::code;
  code.code = barker_code(6);
  EXPECT_EQ(bandwidth_hz(code), 13.0 / 4e-6);
}

// The share of sinc^2 between -x and x.
double sinc_energy(double x) {
  constexpr int panels = 40'000;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    const double z = core::pi * x * (i + 0.5) / panels;
    sum += std::pow(std::sin(z) / z, 2.0);
  }
  return 2.0 * x * sum / panels;
}

TEST(Bandwidth, OfAUserPulseHoldsNinetyNinePercentOfTheEnergyOfARectangle) {
  Pulse pulse;
  pulse.kind = Pulse::Kind::user;
  pulse.width_s = 5e-6;
  pulse.in_phase = function({{0.0, 3.0}});
  pulse.quadrature = function({{0.0, -4.0}});
  const double half_cycles = 0.5 * bandwidth_hz(pulse) * pulse.width_s;
  // Bins are 1/16 cycle wide where the density is below 1/(pi 10)^2; 1/(pi^2 2048) is folded back by the sampling.
  EXPECT_NEAR(sinc_energy(half_cycles), 0.99, 2.0 / 16.0 / std::pow(core::pi * 10.0, 2.0) + 5e-5);
}

TEST(Bandwidth, OfAUserPulseOfBellShapeIsThatOfTheNormalDistribution) {
  // exp(-x^2/(2 s^2)) has an energy spectrum of standard deviation 1/(2 pi s sqrt 2); 99 % lie within 2.5758 of them.
  Pulse pulse;
  pulse.kind = Pulse::Kind::user;
  pulse.width_s = 1e-6;
  std::vector<core::Knot> bell;
  for (int i = 0; i <= 100; ++i) bell.push_back({0.01 * i, std::exp(-0.5 * std::pow((0.01 * i - 0.5) / 0.1, 2.0))});
  pulse.in_phase = function(bell, core::Interpolation::cubic);
  const double expected_hz = 2.0 * 2.5758 / (2.0 * core::pi * 0.1 * std::sqrt(2.0)) * 1e6;
  EXPECT_NEAR(bandwidth_hz(pulse), expected_hz, 2.0 / 16.0 * 1e6);
}

TEST(Bandwidth, OfASmallerShareOfTheEnergyIsSmaller) {
  Pulse pulse;
  pulse.kind = Pulse::Kind::user;
  pulse.width_s = 5e-6;
  pulse.in_phase = function({{0.0, 1.0}});
  const double half_cycles = 0.5 * energy_band_hz(pulse, 0.9) * pulse.width_s;
  // Bins are 1/16 cycle wide; the density there is below 1/(pi 0.8)^2.
  EXPECT_NEAR(sinc_energy(half_cycles), 0.9, 2.0 / 16.0 / std::pow(core::pi * 0.8, 2.0) + 1e-3);
  EXPECT_LT(energy_band_hz(pulse, 0.9), energy_band_hz(pulse, 0.99));
}

// The autocorrelation of a rectangle is a triangle: its power is half at 1 - 1/sqrt(2) of its width to either side.
TEST(HalfPowerWidth, IsThatOfTheAutocorrelation) {
  Pulse pulse;
  pulse.kind = Pulse::Kind::user;
  pulse.width_s = 5e-6;
  pulse.in_phase = function({{0.0, 1.0}});
  EXPECT_NEAR(half_power_width_s(pulse), (2.0 - std::sqrt(2.0)) * 5e-6, 5e-6 / 2048.0);
  pulse.quadrature = function({{0.0, -4.0}});
  EXPECT_NEAR(half_power_width_s(pulse), (2.0 - std::sqrt(2.0)) * 5e-6, 5e-6 / 2048.0);
}

// sin(x)/x of a chirp of time-bandwidth product 400 falls to half its power 0.443 of 1/B from its peak.
TEST(HalfPowerWidth, OfAChirpIsThatOfItsSweep) {
  EXPECT_NEAR(half_power_width_s(chirp(200e6, 2e-6)), 0.8859 / 200e6, 0.01 / 200e6);
}

TEST(HalfPowerWidth, OfACodeIsThatOfOneChip) {
  Pulse code;
  code.width_s = 13e-6;
  code.kind = Pulse::Kind::code;
  code.code = barker_code(6);
  EXPECT_NEAR(half_power_width_s(code), (2.0 - std::sqrt(2.0)) * 1e-6, 0.03e-6);
}

}  // namespace pulse_test
}  // namespace sarsim::radar
