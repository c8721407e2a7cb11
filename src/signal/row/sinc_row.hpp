#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths/sinc_table.hpp"
#include "signal/row/row_kernels.hpp"

namespace sarsim::signal {

/// The interpolation of core::SincTable, with its weights and its steps, for whole rows in SIMD.
class SincRow {
 public:
  static constexpr int steps = static_cast<int>(core::SincTable::steps);
  /// Samples that must stand, zeros or repeated ones, before and behind those of a row.
  static constexpr std::size_t margin = core::SincTable::taps;

  /// @param band  share of the sampling rate that the samples fill, in (0, 1]
  explicit SincRow(double band);

  /// out[k] = factors[k] times the value at a place between samples; 0 where the place is not in [first, last).
  /// @param padded  the samples with their margins
  /// @param whole   the places: sample before, and steps from it to the next one
  /// @param first   from -8 on
  /// @param last    to 8 samples beyond the row's end
  void interpolate(std::span<const std::complex<float>> padded, std::span<const std::int32_t> whole,
                   std::span<const std::int32_t> step, std::span<const float> factors, std::ptrdiff_t first,
                   std::ptrdiff_t last, std::span<std::complex<float>> out) const;

 private:
  std::vector<float> weights_;  // each twice
};

}  // namespace sarsim::signal
