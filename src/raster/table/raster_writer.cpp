#include "raster/table/raster_writer.hpp"

#include <utility>

#include "core/report/expect.hpp"

namespace sarsim::raster {

RasterWriter::RasterWriter(std::unique_ptr<Sink> sink, std::size_t columns, const radar::Converter& converter)
    : sink_(std::move(sink)), columns_(columns), converter_(converter) {
  CORE_EXPECT(sink_ != nullptr);
  CORE_EXPECT(columns_ > 0);
}

void RasterWriter::append(std::span<const std::complex<double>> samples) {
  CORE_EXPECT(samples.size() % columns_ == 0);
  if (sink_->wants_counts()) {
    counts_.resize(2 * samples.size());
    converter_.convert(samples, counts_, tally_);
  }
  const std::size_t rows = samples.size() / columns_;
  sink_->append(sink_->encode({next_row_, rows, columns_, samples, counts_}), next_row_, rows);
  next_row_ += rows;
}

void RasterWriter::append(std::span<const std::complex<float>> samples) {
  wide_.assign(samples.begin(), samples.end());
  append(std::span<const std::complex<double>>(wide_));
}

}  // namespace sarsim::raster
