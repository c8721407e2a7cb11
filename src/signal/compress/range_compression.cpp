#include "signal/compress/range_compression.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/window.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

constexpr double edge_tolerance = 1e-9;  // of a sampling interval

// The classic replica at t after its own beginning, 0 <= t <= Tp: the conjugate pulse backwards, without its envelope.
// Chips are counted from the replica's beginning by plain double arithmetic, as the 1998 program did: a sample on the
// border of two chips falls to either side by rounding, and only the same rounding gives the same samples.
std::complex<double> classic_replica(const radar::Pulse& pulse, double t_s, double tolerance_s) {
  if (pulse.kind == radar::Pulse::Kind::code) {
    const std::size_t length = pulse.code.size();
    const auto chip = static_cast<std::size_t>(t_s * static_cast<double>(length) / pulse.width_s);
    return pulse.code[length - 1 - std::min(chip, length - 1)];
  }
  radar::Pulse bare = pulse;
  bare.envelope = radar::Pulse::Envelope::rectangular;
  return std::conj(bare.value(std::clamp(pulse.width_s - t_s, 0.0, pulse.width_s), tolerance_s));
}

}  // namespace

CompressionFilter matched_filter(const radar::Pulse& pulse, const radar::BandLimitedPulse* band_limited,
                                 const WindowFunction& window, double sample_rate_hz) {
  CORE_EXPECT(sample_rate_hz > 0.0);
  CORE_EXPECT(pulse.width_s > 0.0);
  const auto count =
      static_cast<std::size_t>(std::max(1.0, std::ceil(pulse.width_s * sample_rate_hz - edge_tolerance)));
  CompressionFilter filter;
  double energy = 0.0;
  double magnitudes = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / sample_rate_hz;
    const std::complex<double> p =
        band_limited ? band_limited->value(t) : pulse.value(t, edge_tolerance / sample_rate_hz);
    const double w = window(t / pulse.width_s);
    filter.taps.push_back(w * std::conj(p));
    energy += w * std::norm(p);
    magnitudes += std::abs(w) * std::norm(p);
  }
  if (!core::weights_cancel(energy, magnitudes))
    for (auto& tap : filter.taps) tap /= energy;
  return filter;
}

CompressionFilter classic_matched_filter(const radar::Pulse& pulse, const WindowFunction& window,
                                         double sample_rate_hz) {
  CORE_EXPECT(sample_rate_hz > 0.0);
  CORE_EXPECT(pulse.width_s > 0.0);
  const auto delay = static_cast<std::size_t>(std::floor(pulse.width_s * sample_rate_hz + edge_tolerance));
  CompressionFilter filter;
  filter.taps.resize(delay + 1);
  for (std::size_t i = 0; i <= delay; ++i) {
    // The replica runs backwards in the pulse: its sample i meets raw sample n + delay - i.
    const double t = static_cast<double>(i) / sample_rate_hz;
    const std::complex<double> replica = classic_replica(pulse, t, edge_tolerance / sample_rate_hz);
    filter.taps[delay - i] = window(t / pulse.width_s) * replica / (2.0 * sample_rate_hz);
  }
  return filter;
}

RangeCompressor::RangeCompressor(CompressionFilter filter, std::size_t input_count,
                                 std::vector<std::size_t> output_index)
    : filter_(std::move(filter)),
      input_count_(input_count),
      output_index_(std::move(output_index)),
      fft_(core::good_fft_size(input_count + filter_.taps.size())),
      response_(fft_.size()) {
  CORE_EXPECT(!filter_.taps.empty());
  CORE_EXPECT(input_count_ > 0);
  CORE_EXPECT(std::ranges::all_of(output_index_, [&](std::size_t i) { return i < fft_.size(); }));
  // Correlation: multiply by the transform of the filter run backwards in time.
  const std::size_t size = fft_.size();
  const double scale = 1.0 / static_cast<double>(size);
  for (std::size_t k = 0; k < filter_.taps.size(); ++k) response_[(size - k) % size] = scale * filter_.taps[k];
  fft_.forward(response_);
}

void RangeCompressor::compress(std::span<const std::complex<double>> raw, std::span<std::complex<double>> out,
                               std::span<std::complex<double>> scratch) const {
  CORE_EXPECT(raw.size() == input_count_);
  CORE_EXPECT(out.size() == output_index_.size());
  CORE_EXPECT(scratch.size() >= scratch_size());
  std::ranges::copy(raw, scratch.begin());
  std::fill(scratch.begin() + static_cast<std::ptrdiff_t>(raw.size()), scratch.end(), std::complex<double>());
  fft_.forward(scratch);
  for (std::size_t i = 0; i < scratch.size(); ++i) {
    const double re = scratch[i].real() * response_[i].real() - scratch[i].imag() * response_[i].imag();
    const double im = scratch[i].real() * response_[i].imag() + scratch[i].imag() * response_[i].real();
    scratch[i] = {re, im};
  }
  fft_.inverse(scratch);
  for (std::size_t i = 0; i < output_index_.size(); ++i) out[i] = scratch[output_index_[i]];
}

}  // namespace sarsim::signal
