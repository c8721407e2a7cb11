#include "signal/compress/sampling_loss.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "signal/compress/range_compression.hpp"

namespace sarsim::signal {

namespace {

constexpr double min_lossless_product = 125.0;
constexpr double max_code_samples = 4096.0;
constexpr int beginnings = 32;  // of an echo, in a sampling interval
// In sampling intervals: of the peak from the true delay, steps of the search for it, edges of chips.
constexpr double reach = 1.5;
constexpr double coarse_step = 0.25;
constexpr double fine_step = 0.0625;
constexpr double edge = 1e-9;

radar::Pulse shortened(radar::Pulse pulse, double sample_rate_hz) {
  const double samples = pulse.width_s * sample_rate_hz;
  if (pulse.kind != radar::Pulse::Kind::code || samples <= max_code_samples) return pulse;
  const double chip_s = pulse.width_s / static_cast<double>(pulse.code.size());
  const auto chips = static_cast<std::size_t>(std::max(1.0, std::floor(max_code_samples / (chip_s * sample_rate_hz))));
  pulse.code.resize(std::min(chips, pulse.code.size()));
  pulse.width_s = chip_s * static_cast<double>(pulse.code.size());
  return pulse;
}

// An echo that begins `part` of an interval before the sample after `ahead` zeros.
std::vector<std::complex<double>> sampled(const radar::Pulse& pulse, double sample_rate_hz, std::size_t ahead,
                                          std::size_t count, double part) {
  std::vector<std::complex<double>> raw(count);
  for (std::size_t i = ahead; i < count; ++i) {
    const double t = static_cast<double>(i - ahead) + part;
    if (t < pulse.width_s * sample_rate_hz - edge) raw[i] = pulse.value(t / sample_rate_hz, edge / sample_rate_hz);
  }
  return raw;
}

// Magnitude of the band-limited continuation of samples at `index`, which lies between two of them.
double between(std::span<const std::complex<double>> samples, double index) {
  const double nearest = std::round(index);
  if (std::abs(index - nearest) < edge) return std::abs(samples[static_cast<std::size_t>(nearest)]);
  std::complex<double> sum;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    sum += sign / (index - static_cast<double>(i)) * samples[i];
  }
  return std::abs(sum) * std::abs(std::sin(core::pi * index)) / core::pi;
}

struct Peak {
  double value = 0.0;
  double at = 0.0;  // index
};

Peak peak_near(std::span<const std::complex<double>> samples, double index) {
  Peak peak{0.0, index};
  const auto search = [&](double middle, double step, int steps) {
    for (int n = -steps; n <= steps; ++n) {
      const double at = middle + n * step;
      const double value = between(samples, at);
      if (value > peak.value) peak = {value, at};
    }
  };
  search(index, coarse_step, static_cast<int>(reach / coarse_step));
  search(peak.at, fine_step, static_cast<int>(coarse_step / fine_step));
  return peak;
}

}  // namespace

SamplingLoss sampling_loss(const radar::Pulse& given, double sample_rate_hz) {
  CORE_EXPECT(sample_rate_hz > 0.0);
  if (given.kind == radar::Pulse::Kind::chirp && std::abs(given.sweep_hz) * given.width_s >= min_lossless_product)
    return {};
  const radar::Pulse pulse = shortened(given, sample_rate_hz);
  CompressionFilter filter = matched_filter(
      pulse, nullptr, [](double) { return 1.0; }, sample_rate_hz);
  const std::size_t ahead = filter.taps.size() + 2;
  const std::size_t count = 2 * ahead;
  std::vector<std::size_t> index(count);
  std::iota(index.begin(), index.end(), std::size_t{0});
  const RangeCompressor compressor(std::move(filter), count, std::move(index));
  std::vector<std::complex<double>> scratch(compressor.scratch_size());
  std::vector<std::complex<double>> compressed(count);
  SamplingLoss loss;
  double sum = 0.0;
  for (int beginning = 0; beginning < beginnings; ++beginning) {
    const double part = static_cast<double>(beginning) / beginnings;
    compressor.compress(sampled(pulse, sample_rate_hz, ahead, count, part), compressed, scratch);
    const double true_index = static_cast<double>(ahead) - part;
    const Peak peak = peak_near(compressed, true_index);
    sum += peak.value;
    loss.max_db = std::max(loss.max_db, -20.0 * std::log10(peak.value));
    loss.max_shift_s = std::max(loss.max_shift_s, std::abs(peak.at - true_index) / sample_rate_hz);
  }
  // Between two beginnings the peak may be that much farther.
  if (loss.max_shift_s > 0.0) loss.max_shift_s += 1.0 / (beginnings * sample_rate_hz);
  loss.mean_db = -20.0 * std::log10(sum / beginnings);
  return loss;
}

}  // namespace sarsim::signal
