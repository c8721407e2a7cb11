#include "signal/sar/echo_records.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "core/maths/sinc.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

// Zeros beyond the last sample, so that the interpolated echo of one edge does not reach round to the other.
constexpr std::size_t guard_samples = 32;

// Mean of a window over the band, by the midpoint rule.
double mean_of(const WindowFunction& window) {
  constexpr int points = 4096;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) sum += window((i + 0.5) / points);
  return sum / points;
}

std::vector<float> frequency_weights(const SarWaveform& waveform, const WindowFunction& window, std::size_t size) {
  const double mean = window ? mean_of(window) : 1.0;
  std::vector<float> weights(size);
  for (std::size_t k = 0; k < size; ++k) {
    const double cycles = (static_cast<double>(k) - (2 * k >= size ? static_cast<double>(size) : 0.0)) /
                          static_cast<double>(size);  // per sample
    const double triangle = core::sinc(cycles / static_cast<double>(EchoRecords::factor));
    double weight = 1.0 / (triangle * triangle * static_cast<double>(size));
    if (window) {
      const double place = 0.5 + cycles * waveform.sample_rate_hz / std::abs(waveform.bandwidth_hz);
      weight *= window(std::clamp(place, 0.0, 1.0)) / mean;
    }
    // The highest frequency of an even length stands for both of its signs.
    weights[k] = static_cast<float>(2 * k == size ? 0.5 * weight : weight);
  }
  return weights;
}

}  // namespace

double overlap_of(const SarWaveform& waveform, double doppler_hz) {
  constexpr double least = 0.5;
  if (!(waveform.pulse_width_s > 0.0)) return 1.0;
  return std::max(1.0 - std::abs(doppler_hz / waveform.bandwidth_hz), least);
}

EchoRecords::EchoRecords(const SarEchoes& echoes, const WindowFunction& window, std::size_t pulses,
                         std::vector<float> gains)
    : echoes_(&echoes),
      slots_(pulses),
      count_(factor * (std::max<std::size_t>(echoes.samples, 1) - 1) + 1),
      forward_(core::good_fft_size(echoes.samples + guard_samples)),
      inverse_(factor * forward_.size()),
      weights_(frequency_weights(echoes.waveform, window, forward_.size())),
      gains_(std::move(gains)),
      records_(pulses * count_ * floats) {
  CORE_EXPECT(echoes.volts.size() == echoes.track.size() * echoes.samples);
  CORE_EXPECT(pulses > 0);
  CORE_EXPECT(gains_.empty() || gains_.size() == echoes.track.size());
}

void EchoRecords::fill(std::size_t first, std::size_t count, const core::WorkControl& control) {
  CORE_EXPECT(count <= slots_);
  CORE_EXPECT(first + count <= echoes_->track.size());
  const std::size_t size = forward_.size();
  const std::size_t half = size / 2;
  core::parallel_ranges(count, 4, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<float>> row(size), fine(inverse_.size());
    for (std::size_t slot = begin; slot < end; ++slot) {
      const auto* samples = echoes_->volts.data() + (first + slot) * echoes_->samples;
      std::copy_n(samples, echoes_->samples, row.begin());
      std::fill(row.begin() + static_cast<std::ptrdiff_t>(echoes_->samples), row.end(), std::complex<float>());
      forward_.forward(row);
      const float gain = gains_.empty() ? 1.0F : gains_[first + slot];
      for (std::size_t k = 0; k < size; ++k) row[k] *= gain * weights_[k];
      std::ranges::fill(fine, std::complex<float>());
      std::copy_n(row.begin(), half + 1, fine.begin());
      std::copy(row.end() - static_cast<std::ptrdiff_t>(half), row.end(),
                fine.end() - static_cast<std::ptrdiff_t>(half));
      inverse_.inverse(fine);
      std::copy_n(reinterpret_cast<const float*>(fine.data()), count_ * floats,
                  records_.data() + slot * count_ * floats);
    }
  });
}

}  // namespace sarsim::signal
