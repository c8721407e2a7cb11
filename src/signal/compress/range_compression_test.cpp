#include "signal/compress/range_compression.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"

namespace sarsim::signal {
namespace range_compression_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
using Row = std::vector<std::complex<double>>;

const WindowFunction rectangular = [](double) { return 1.0; };
const WindowFunction hanning = [](double x) { return core::hanning_window(x, 0.1); };
const WindowFunction windows[]{rectangular, hanning, core::bartlett_window, core::hamming_window,
                               [](double x) { return 0.2 + x * x; }};

radar::Pulse pulse_of(radar::Pulse::Kind kind, double width_s) {
  radar::Pulse pulse;
  pulse.kind = kind;
  pulse.width_s = width_s;
  pulse.sweep_hz = 8e6;
  pulse.code = radar::barker_code(5);
  pulse.in_phase =
      core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, 0.2}, {0.5, 1.0}, {1.0, -1.0}}});
  pulse.quadrature =
      core::Interpolator(core::SampledFunction{core::Interpolation::cubic, {{0.0, 1.0}, {0.3, -1.0}, {1.0, 2.0}}});
  return pulse;
}

constexpr std::array kinds{radar::Pulse::Kind::mono, radar::Pulse::Kind::chirp, radar::Pulse::Kind::code,
                           radar::Pulse::Kind::user};

Row compressed(const CompressionFilter& filter, const Row& raw) {
  std::vector<std::size_t> index(raw.size());
  std::iota(index.begin(), index.end(), 0u);
  const RangeCompressor compressor(filter, raw.size(), index);
  Row out(raw.size()), scratch(compressor.scratch_size());
  compressor.compress(raw, out, scratch);
  return out;
}

// A raw row with the echo of a pulse whose leading edge stands on sample `at`.
Row raw_echo(const radar::Pulse& pulse, double rate_hz, std::size_t size, std::size_t at,
             std::complex<double> amplitude) {
  Row raw(size);
  for (std::size_t i = at; i < size; ++i) {
    const double t = static_cast<double>(i - at) / rate_hz;
    if (t < pulse.width_s * (1.0 - 1e-12)) raw[i] = amplitude * pulse.value(t, 1e-9 / rate_hz);
  }
  return raw;
}

TEST(MatchedFilter, KeepsTheAmplitudeAndPhaseOfATargetOnTheGrid) {
  constexpr double rate_hz = 10e6;
  const std::complex<double> amplitude = std::polar(3e-7, 2.1);
  for (const radar::Pulse::Kind kind : kinds)
    for (const WindowFunction& window : windows)
      for (const double width_s : {4e-6, 4.03e-6}) {
        radar::Pulse pulse = pulse_of(kind, width_s);
        pulse.envelope = radar::Pulse::Envelope::linear;
        pulse.rise_s = 0.7e-6;
        const CompressionFilter filter = matched_filter(pulse, nullptr, window, rate_hz);
        ASSERT_EQ(filter.taps.size(), width_s > 4e-6 ? 41u : 40u);
        const Row out = compressed(filter, raw_echo(pulse, rate_hz, 150, 37, amplitude));
        EXPECT_LT(std::abs(out[37] - amplitude), 150.0 * 10.0 * epsilon * std::abs(amplitude));
      }
}

TEST(MatchedFilter, KeepsTheAmplitudeAndPhaseOfABandLimitedPulse) {
  constexpr double rate_hz = 10e6;
  const std::complex<double> amplitude = std::polar(3e-7, -0.4);
  for (const radar::Pulse::Kind kind : kinds) {
    const radar::Pulse pulse = pulse_of(kind, 4e-6);
    const radar::BandLimitedPulse limited(pulse, 0.5 * rate_hz, rate_hz, pulse.width_s);
    const CompressionFilter filter = matched_filter(pulse, &limited, hanning, rate_hz);
    Row raw(150);
    for (std::size_t i = 0; i < raw.size(); ++i)
      raw[i] = amplitude * limited.value((static_cast<double>(i) - 37.0) / rate_hz);
    EXPECT_LT(std::abs(compressed(filter, raw)[37] - amplitude), 1e5 * epsilon * std::abs(amplitude));
  }
}

TEST(MatchedFilter, WeighsTheReplicaByTheWindowFromTheLeadingEdgeOn) {
  const radar::Pulse pulse = pulse_of(radar::Pulse::Kind::mono, 4e-6);
  const WindowFunction rising = [](double x) { return x; };
  const CompressionFilter filter = matched_filter(pulse, nullptr, rising, 1e6);  // weights 0, 1/4, 1/2, 3/4
  ASSERT_EQ(filter.taps.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(std::abs(filter.taps[k] - static_cast<double>(k) / 6.0), 2.0 * epsilon);
  const CompressionFilter classic = classic_matched_filter(pulse, rising, 1e6);  // its replica runs backwards
  ASSERT_EQ(classic.taps.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_LT(std::abs(classic.taps[k] - (1.0 - static_cast<double>(k) / 4.0) / 2e6), 1e-6 * epsilon);
}

TEST(MatchedFilter, KeepsThePeakWhateverTheSignOfTheWeights) {
  const radar::Pulse pulse = pulse_of(radar::Pulse::Kind::chirp, 5e-6);
  const double rate_hz = 8e6;
  const std::complex<double> amplitude = std::polar(3.0, 0.7);
  for (const WindowFunction& window :
       {WindowFunction([](double) { return -1.0; }), WindowFunction([](double x) { return 0.5 - 2.0 * x; })}) {
    const CompressionFilter filter = matched_filter(pulse, nullptr, window, rate_hz);
    const Row raw = raw_echo(pulse, rate_hz, 150, 37, amplitude);
    EXPECT_LT(std::abs(compressed(filter, raw)[37] - amplitude), 1e3 * epsilon * std::abs(amplitude));
  }
}

TEST(MatchedFilter, WhoseWeightsCancelIsLeftAsItIs) {
  const radar::Pulse pulse = pulse_of(radar::Pulse::Kind::mono, 4e-6);
  const WindowFunction tilted = [](double x) { return 0.3 - 0.8 * x; };  // at 0, 1/4, 1/2 and 3/4
  const CompressionFilter filter = matched_filter(pulse, nullptr, tilted, 1e6);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_LT(std::abs(filter.taps[k] - tilted(static_cast<double>(k) / 4.0)), epsilon);
}

TEST(MatchedFilter, OfAMonochromePulseMakesATriangle) {
  const radar::Pulse pulse = pulse_of(radar::Pulse::Kind::mono, 5e-6);
  const Row out = compressed(matched_filter(pulse, nullptr, rectangular, 4e6), raw_echo(pulse, 4e6, 100, 40, 2.0));
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(std::abs(out[static_cast<std::size_t>(i)] - 2.0 * std::max(0.0, 1.0 - std::abs(i - 40) / 20.0)),
              1e3 * epsilon);
}

TEST(MatchedFilter, OfABarkerCodeOfThirteenHasSideLobesOfOneThirteenth) {
  radar::Pulse pulse = pulse_of(radar::Pulse::Kind::code, 13e-6);
  pulse.code = radar::barker_code(6);
  const Row out = compressed(matched_filter(pulse, nullptr, rectangular, 8e6), raw_echo(pulse, 8e6, 400, 150, 1.0));
  double lobe = 0.0;
  for (int i = 0; i < 400; ++i)
    if (std::abs(i - 150) >= 8) lobe = std::max(lobe, std::abs(out[static_cast<std::size_t>(i)]));
  EXPECT_NEAR(lobe, 1.0 / 13.0, 1e3 * epsilon);
  EXPECT_NEAR(20.0 * std::log10(lobe), -22.28, 0.005);
}

struct Lobes {
  double width_s = 0.0;  // between the half-power points
  double pslr_db = 0.0;
};

// Of a response with its peak at sample `at`.
Lobes lobes_of(const Row& out, std::size_t at, double rate_hz) {
  const auto power = [&](std::size_t i) { return std::norm(out[i]) / std::norm(out[at]); };
  std::size_t i = at;
  while (power(i) > 0.5) ++i;
  const double crossing = static_cast<double>(i) - (0.5 - power(i)) / (power(i - 1) - power(i));
  while (power(i + 1) < power(i)) ++i;  // down to the first null
  double lobe = 0.0;
  for (; i < out.size(); ++i) lobe = std::max(lobe, power(i));
  return {2.0 * (crossing - static_cast<double>(at)) / rate_hz, 10.0 * std::log10(lobe)};
}

// The exact autocorrelation of a rectangular chirp, for a few time-bandwidth products. Figures are rounded to 0.005 dB
// and 0.00005; 64 samples per 1/B add (pi/128)^2/2 = 0.0026 dB at a side lobe and (pi/128)^2/8 = 8e-5 in the width.
TEST(MatchedFilter, OfAChirpHasTheSideLobesAndWidthOfItsTimeBandwidthProduct) {
  struct Row4 {
    double product, pslr_db, width;
  };
  constexpr double bandwidth_hz = 10e6;
  for (const auto& [product, pslr_db, width] :
       {Row4{25, -13.81, 0.8800}, Row4{50, -13.52, 0.8831}, Row4{100, -13.39, 0.8845}, Row4{200, -13.32, 0.8852},
        Row4{1000, -13.27, 0.8858}}) {
    radar::Pulse pulse = pulse_of(radar::Pulse::Kind::chirp, product / bandwidth_hz);
    pulse.sweep_hz = bandwidth_hz;
    constexpr double rate_hz = 64.0 * bandwidth_hz;
    const auto count = static_cast<std::size_t>(64.0 * product);
    const Row raw = raw_echo(pulse, rate_hz, 2 * count + 200, 100, 1.0);
    const Lobes lobes = lobes_of(compressed(matched_filter(pulse, nullptr, rectangular, rate_hz), raw), 100, rate_hz);
    EXPECT_NEAR(lobes.pslr_db, pslr_db, 0.005 + 0.0026) << product;
    EXPECT_NEAR(lobes.width_s * bandwidth_hz, width, 5e-5 + 8e-5) << product;
  }
}

// Weighted chirps: PSLR and width of the window's own transform, nearly, at a high time-bandwidth product.
TEST(MatchedFilter, OfAHammingWindowedChirpHasLowSideLobesAndAWiderPeak) {
  constexpr double bandwidth_hz = 10e6, rate_hz = 32.0 * bandwidth_hz;
  radar::Pulse pulse = pulse_of(radar::Pulse::Kind::chirp, 1000.0 / bandwidth_hz);
  pulse.sweep_hz = -bandwidth_hz;
  const Row raw = raw_echo(pulse, rate_hz, 70'000, 100, 1.0);
  const Lobes lobes =
      lobes_of(compressed(matched_filter(pulse, nullptr, core::hamming_window, rate_hz), raw), 100, rate_hz);
  EXPECT_NEAR(lobes.width_s * bandwidth_hz, 1.303, 0.01);
  EXPECT_LT(lobes.pslr_db, -40.0);
}

TEST(ClassicMatchedFilter, ScalesThePeakToHalfThePulseWidthTimesTheMeanOfTheWindow) {
  constexpr double rate_hz = 10e6, width_s = 4e-6;
  const std::complex<double> amplitude = std::polar(2e-7, 0.9);
  struct Case {
    WindowFunction window;
    double mean;
  };
  for (const radar::Pulse::Kind kind : {radar::Pulse::Kind::mono, radar::Pulse::Kind::chirp})
    // Over whole periods the mean of the samples is that of the curve.
    for (const auto& [window, mean] : {Case{rectangular, 1.0}, Case{hanning, 0.55}, Case{core::hamming_window, 0.54},
                                       Case{core::bartlett_window, 0.5}}) {
      const radar::Pulse pulse = pulse_of(kind, width_s);
      const Row out =
          compressed(classic_matched_filter(pulse, window, rate_hz), raw_echo(pulse, rate_hz, 150, 37, amplitude));
      const std::complex<double> expected = 0.5 * width_s * mean * amplitude;
      EXPECT_LT(std::abs(out[37] - expected), 1e4 * epsilon * std::abs(expected));
    }
}

TEST(ClassicMatchedFilter, HasBothEndsOfThePulseAndNoEnvelope) {
  radar::Pulse pulse = pulse_of(radar::Pulse::Kind::chirp, 4e-6);
  pulse.envelope = radar::Pulse::Envelope::linear;
  pulse.rise_s = 2e-6;
  const CompressionFilter filter = classic_matched_filter(pulse, rectangular, 10e6);
  ASSERT_EQ(filter.taps.size(), 41u);
  for (std::size_t k = 0; k < 41; ++k) {
    const double u = static_cast<double>(k) / 10e6 - 2e-6;
    const std::complex<double> expected = std::polar(1.0 / 20e6, -core::pi * 8e6 / 4e-6 * u * u);
    EXPECT_LT(std::abs(filter.taps[k] - expected), 100.0 * epsilon / 20e6);
  }
  EXPECT_EQ(classic_matched_filter(pulse_of(radar::Pulse::Kind::mono, 4.03e-6), rectangular, 10e6).taps.size(), 41u);
}

// Chips are counted from the end of the pulse, so that a sample on a border may fall to the other side: at most two
// borders' worth of a sample each.
TEST(ClassicMatchedFilter, RunsThroughTheCodeBackwards) {
  radar::Pulse pulse = pulse_of(radar::Pulse::Kind::code, 4.4e-6);  // 11 chips of 0.4 us
  const Row out = compressed(classic_matched_filter(pulse, rectangular, 100e6), raw_echo(pulse, 100e6, 1500, 300, 1.0));
  EXPECT_NEAR(std::abs(out[300]), 2.2e-6, 2.2e-6 * 2.0 * 11.0 / 440.0);
  const auto peak = std::ranges::max_element(out, {}, [](const auto& v) { return std::abs(v); }) - out.begin();
  EXPECT_NEAR(static_cast<double>(peak), 300.0, 1.0);
}

TEST(RangeCompressor, IsTheCorrelationWithTheTaps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  CompressionFilter filter;
  for (int k = 0; k < 17; ++k) filter.taps.push_back({part(random), part(random)});
  Row raw(100);
  for (auto& x : raw) x = {part(random), part(random)};
  const Row out = compressed(filter, raw);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    std::complex<double> sum = 0.0;  // samples beyond the row count as 0
    for (std::size_t k = 0; k < filter.taps.size() && i + k < raw.size(); ++k) sum += filter.taps[k] * raw[i + k];
    EXPECT_LT(std::abs(out[i] - sum), 120.0 * 17.0 * epsilon);
  }
}

TEST(RangeCompressor, TakesTheAskedSamplesAlsoRepeatedly) {
  const CompressionFilter identity{{1.0}};
  const RangeCompressor compressor(identity, 4, {0, 0, 3, 2});
  EXPECT_EQ(compressor.input_count(), 4u);
  EXPECT_EQ(compressor.output_count(), 4u);
  const Row raw{1.0, 2.0, 3.0, 4.0};
  Row out(4), scratch(compressor.scratch_size());
  compressor.compress(raw, out, scratch);
  const double expected[] = {1.0, 1.0, 4.0, 3.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(std::abs(out[i] - expected[i]), 20.0 * epsilon);
}

}  // namespace range_compression_test
}  // namespace sarsim::signal
