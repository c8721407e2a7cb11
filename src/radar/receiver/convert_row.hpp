#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sarsim::radar {

/// What a conversion met.
struct ConversionTally {
  double maximum_v = 0.0;         ///< Largest magnitude before conversion.
  std::uint64_t saturated = 0;    ///< Samples with I or Q clipped.
  std::uint64_t zero = 0;         ///< Samples whose counts are both 0.
  std::uint64_t not_numbers = 0;  ///< Samples whose I or Q is no number (NaN).

  /// Joins what two conversions met.
  void add(const ConversionTally& other);
};

/// Part of a row that was converted, and where the definition has to go on.
struct ConvertedPart {
  std::size_t done = 0;        ///< Samples from the first on that are converted and tallied.
  double largest_power = 0.0;  ///< Of these [V^2].
};

/// Counts up to this are whole numbers that an addition puts into the digits of a double.
inline constexpr double largest_simd_count = 0x1p50;

/// Converts whole vectors of samples, from the first on, up to one that only the definition is sure about: where the
/// product with 1/LSB is so close to a half that it may round otherwise than the quotient does, or is no number.
///
/// The reciprocal, the product and the quotient are rounded once each, so product and quotient differ by at most
/// 3 x 2^-53 of themselves and give the same count where the product is further than that from a half.
///
/// @param per_volt         1/LSB, neither subnormal nor infinite, nor its inverse
/// @param lowest, highest  of the counts, within +-`largest_simd_count`
/// @param[out] counts      2 volts.size() numbers, or none: then only the tally is made
/// @param[in,out] tally    all but its maximum is added to
ConvertedPart convert_vectors(std::span<const std::complex<double>> volts, double per_volt, double lowest,
                              double highest, std::span<std::int64_t> counts, ConversionTally& tally);

/// What can be said of a row without a converter, in SIMD: its largest magnitude, its samples that are 0 and those
/// that are no numbers are added to the tally.
void tally_volts(std::span<const std::complex<double>> volts, ConversionTally& tally);

}  // namespace sarsim::radar
