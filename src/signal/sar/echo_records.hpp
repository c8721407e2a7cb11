#pragma once

#include <cstddef>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/compress/range_compression.hpp"
#include "signal/sar/sar_echoes.hpp"

namespace sarsim::signal {

/// Share of its peak that compression keeps of a chirp whose Doppler frequency the filter does not know: the part in
/// which both overlap once the peak has moved by fd/K, 1 - |fd|/B, at least one half. 1 where pulses have no width.
[[nodiscard]] double overlap_of(const SarWaveform& waveform, double doppler_hz);

/// Compressed echoes of a few pulses, ready to be read between samples (of which there are two or more): `factor`
/// records for each sample, each the value at its place.
///
/// Between records an echo is a straight line. Linear interpolation on a grid of f_up = factor sample_rate_hz is a
/// convolution with a triangle, that is a filter sinc^2(f/f_up); the spectrum is divided by it beforehand, so that what
/// lies in the band keeps its amplitude and phase exactly. What is left are the images of the band about multiples of
/// f_up: with u = f/f_up, 3.3 u^2 of an echo at f at the worst place, 1.5 u^2 in the root mean square over places:
/// 0.47 % (-47 dB) at 0.45 of the sampling rate, 0.2 % over a band as wide as that. Pulses meet a point at different
/// places, so the images of N of them fall by the root of N more.
class EchoRecords {
 public:
  static constexpr std::size_t factor = 8;
  static constexpr std::size_t floats = 2;  ///< Of a record: real and imaginary part.

  /// Room for the pulses of `echoes` from `first` to `last`, not `last` itself; each is transformed by `fill`.
  /// @param window  weight of the frequencies, its argument 0 and 1 at the edges of the pulse's band and held beyond
  ///                them; empty for none. It is divided by its mean, so that a peak keeps its height.
  /// @param gains   factor for each pulse of `echoes`; empty for 1
  EchoRecords(const SarEchoes& echoes, const WindowFunction& window, std::size_t pulses, std::vector<float> gains = {});

  /// Makes the records of the pulses `first` ... `first + count - 1`, count at most the room.
  void fill(std::size_t first, std::size_t count, const core::WorkControl& control);

  /// Record k of the pulse in slot p: `at(p)[floats * k]`. Record 0 stands at the first sample, the last one at the
  /// last sample.
  [[nodiscard]] const float* at(std::size_t slot) const { return records_.data() + slot * count_ * floats; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t slots() const { return slots_; }

 private:
  const SarEchoes* echoes_;
  std::size_t slots_;
  std::size_t count_;
  core::BasicFft<float> forward_;
  core::BasicFft<float> inverse_;
  std::vector<float> weights_;  // of the frequencies of the short transform
  std::vector<float> gains_;
  std::vector<float> records_;
};

}  // namespace sarsim::signal
