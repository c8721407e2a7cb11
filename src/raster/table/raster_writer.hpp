#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "radar/receiver/converter.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// Appends the rows of a raster to a sink: makes counts of its numbers where the sink wants counts, and encodes them.
class RasterWriter {
 public:
  /// @param columns    samples of a row, at least 1
  /// @param converter  of the numbers as they are appended; not used where the sink takes volts
  RasterWriter(std::unique_ptr<Sink> sink, std::size_t columns, const radar::Converter& converter);

  /// Whether the numbers become counts.
  [[nodiscard]] bool wants_counts() const { return sink_->wants_counts(); }
  /// Takes the next rows, one after the other, whole rows only. Throws what the sink throws.
  void append(std::span<const std::complex<double>> samples);
  /// The same of floats.
  void append(std::span<const std::complex<float>> samples);
  /// What the conversion into counts met so far.
  [[nodiscard]] const radar::ConversionTally& tally() const { return tally_; }
  /// Completes the file with what is only known at the end; std::logic_error where rows are missing.
  void finish(const RunReport& report) { sink_->finish(report); }

 private:
  std::unique_ptr<Sink> sink_;
  std::size_t columns_;
  radar::Converter converter_;
  radar::ConversionTally tally_;
  std::size_t next_row_ = 0;
  std::vector<std::complex<double>> wide_;
  std::vector<std::int64_t> counts_;
};

}  // namespace sarsim::raster
