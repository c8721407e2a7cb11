#include "signal/search/range_doppler_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {}  // namespace

std::vector<double> pulse_weights(const CoherentInterval& interval) {
  CORE_EXPECT(interval.pulses > 0);
  std::vector<double> weights(interval.pulses, 1.0);
  if (interval.window && interval.pulses > 1)
    for (std::size_t p = 0; p < interval.pulses; ++p)
      weights[p] = interval.window(static_cast<double>(p) / static_cast<double>(interval.pulses - 1));
  double sum = 0.0;
  for (const double w : weights) sum += w;
  core::expect(std::abs(sum) > 1e-12, "range-Doppler map: the weights of the window cancel");
  for (double& w : weights) w /= sum;
  return weights;
}

std::vector<RangeDopplerMap> range_doppler_maps(std::span<const std::complex<float>> volts, std::size_t samples,
                                                double prf_hz, const CoherentInterval& interval,
                                                const core::WorkControl& control) {
  core::expect(samples > 0 && volts.size() % samples == 0,
               "range-Doppler map: the samples are not a whole number of pulses");
  core::expect(prf_hz > 0.0, "range-Doppler map: the repetition frequency is not above 0");
  core::expect(interval.pulses > 0, "range-Doppler map: an interval has no pulses");
  core::expect(interval.frequencies == 0 || interval.frequencies >= interval.pulses,
               "range-Doppler map: fewer frequencies than pulses");
  const std::size_t pulses = volts.size() / samples;
  const std::size_t step = interval.step > 0 ? interval.step : interval.pulses;
  const std::size_t size = interval.frequencies > 0 ? interval.frequencies : interval.pulses;
  const std::vector<double> weights = pulse_weights(interval);
  const core::Fft fft(size);
  std::vector<RangeDopplerMap> maps;
  for (std::size_t first = 0; first + interval.pulses <= pulses; first += step) {
    RangeDopplerMap map;
    map.first_pulse = first;
    map.doppler_step_hz = prf_hz / static_cast<double>(size);
    map.first_doppler_hz = -static_cast<double>(size / 2) * map.doppler_step_hz;
    map.frequencies = size;
    map.samples = samples;
    map.values.resize(size * samples);
    core::parallel_ranges(samples, 64, control, [&](std::size_t begin, std::size_t end) {
      std::vector<std::complex<double>> column(size);
      for (std::size_t n = begin; n < end; ++n) {
        std::ranges::fill(column, 0.0);
        for (std::size_t p = 0; p < interval.pulses; ++p)
          column[p] = weights[p] * std::complex<double>(volts[(first + p) * samples + n]);
        fft.forward(column);
        for (std::size_t k = 0; k < size; ++k)
          map.values[k * samples + n] = std::complex<float>(column[(k + size - size / 2) % size]);
      }
    });
    maps.push_back(std::move(map));
  }
  return maps;
}

std::vector<float> power_of(const RangeDopplerMap& map) {
  std::vector<float> power;
  power.reserve(map.values.size());
  for (const auto& value : map.values) power.push_back(std::norm(value));
  return power;
}

}  // namespace sarsim::signal
