#pragma once

#include <complex>
#include <cstdint>
#include <span>

#include "radar/receiver/convert_row.hpp"

namespace sarsim::radar {

/// Largest positive count C of a converter: 2^(bits-1) - 1, at least 1 (decision 24). Exact up to 53 bits.
[[nodiscard]] double full_scale_count(int bits);

/// An A/D converter for I and Q: count = floor(v/LSB + 1/2) clipped to [-C, C + 1] (decision 24).
/// Counts are exact up to 53 bits; beyond, they are the multiples that doubles can hold. NaN becomes 0 and is tallied;
/// infinity is clipped like any large value.
struct Converter {
  int bits = 8;
  double lsb_v = 1.0;  ///< Positive.

  /// Converts a row and adds to the tally, in SIMD: exactly what `convert_plainly` gives.
  /// @param[out] counts  2 * volts.size() values, I before Q; may be empty: then only the tally is made.
  void convert(std::span<const std::complex<double>> volts, std::span<std::int64_t> counts,
               ConversionTally& tally) const;
  /// The definition, one number at a time, with a division each.
  void convert_plainly(std::span<const std::complex<double>> volts, std::span<std::int64_t> counts,
                       ConversionTally& tally) const;
};

/// Largest magnitude of a row [V].
[[nodiscard]] double largest_magnitude(std::span<const std::complex<double>> volts);

}  // namespace sarsim::radar
