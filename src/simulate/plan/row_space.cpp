#include "simulate/plan/row_space.hpp"

#include <numeric>
#include <utility>

#include "core/report/expect.hpp"

namespace sarsim::simulate {

std::shared_ptr<const signal::RangeCompressor> compressor_of(const Acquisition& acquisition,
                                                             const signal::WindowFunction& window,
                                                             std::size_t raw_samples, std::size_t samples) {
  CORE_EXPECT(raw_samples > 0);
  CORE_EXPECT(samples <= raw_samples);
  const radar::BandLimitedPulse* band_limited =
      acquisition.reception.pulse.band_limited ? &*acquisition.reception.pulse.band_limited : nullptr;
  std::vector<std::size_t> index(samples);
  std::iota(index.begin(), index.end(), std::size_t{0});
  signal::CompressionFilter filter = signal::matched_filter(acquisition.link.pulse, band_limited, window,
                                                            1.0 / acquisition.reception.raw_grid.interval_s);
  return std::make_shared<const signal::RangeCompressor>(std::move(filter), raw_samples, std::move(index));
}

void RowSpace::compress(const signal::RangeCompressor& compressor, std::span<std::complex<float>> out) {
  CORE_EXPECT(out.size() == compressor.output_count());
  CORE_EXPECT(raw.size() == compressor.input_count());
  compressed.resize(compressor.output_count());
  scratch.resize(compressor.scratch_size());
  compressor.compress(raw, compressed, scratch);
  to_float(compressed, out);
}

void to_float(std::span<const std::complex<double>> from, std::span<std::complex<float>> to) {
  CORE_EXPECT(to.size() == from.size());
  for (std::size_t n = 0; n < to.size(); ++n) to[n] = std::complex<float>(from[n]);
}

}  // namespace sarsim::simulate
