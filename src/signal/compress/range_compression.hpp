#pragma once

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "radar/waveform/band_limited_pulse.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::signal {

/// Weight against the fraction of the pulse width, 0 to 1.
using WindowFunction = std::function<double(double)>;

/// The finite filter that compresses pulses: y[i] = sum over k of taps[k] x[i + k].
struct CompressionFilter {
  std::vector<std::complex<double>> taps;
};

/// Filter of the physical profile (decision 12): the conjugate of the transmitted pulse sampled from its leading edge,
/// times the window, divided by the sum of window |pulse|^2: the peak of a resting point target on the sampling grid
/// keeps the amplitude and phase of its raw echo. Where that sum cancels, nothing is divided by.
/// @param band_limited  the pulse as confined to a band, or null for the ideal one
[[nodiscard]] CompressionFilter matched_filter(const radar::Pulse& pulse, const radar::BandLimitedPulse* band_limited,
                                               const WindowFunction& window, double sample_rate_hz);

/// Filter of the classic profile (docs/theory/compression.md): both ends of the pulse included, envelope left out,
/// divided by twice the sampling rate; a point target's peak is A Tp/2 times the window's mean. A user-defined pulse is
/// matched as it is.
[[nodiscard]] CompressionFilter classic_matched_filter(const radar::Pulse& pulse, const WindowFunction& window,
                                                       double sample_rate_hz);

/// Applies a filter to rows of one length by fast convolution.
class RangeCompressor {
 public:
  /// @param input_count   samples of a raw row
  /// @param output_index  for each output sample the raw index i it is taken at, in [0, input_count)
  RangeCompressor(CompressionFilter filter, std::size_t input_count, std::vector<std::size_t> output_index);

  [[nodiscard]] const CompressionFilter& filter() const { return filter_; }
  [[nodiscard]] const std::vector<std::size_t>& output_index() const { return output_index_; }
  [[nodiscard]] std::size_t input_count() const { return input_count_; }
  [[nodiscard]] std::size_t output_count() const { return output_index_.size(); }
  /// Length of the scratch space that `compress` needs.
  [[nodiscard]] std::size_t scratch_size() const { return fft_.size(); }

  /// @param raw      input_count samples; samples beyond them count as 0
  /// @param[out] out output_count samples
  /// @param scratch  scratch_size values, overwritten
  void compress(std::span<const std::complex<double>> raw, std::span<std::complex<double>> out,
                std::span<std::complex<double>> scratch) const;

 private:
  CompressionFilter filter_;
  std::size_t input_count_;
  std::vector<std::size_t> output_index_;
  core::Fft fft_;
  std::vector<std::complex<double>> response_;
};

}  // namespace sarsim::signal
