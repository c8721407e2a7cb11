#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "radar/receiver/converter.hpp"

namespace sarsim::workflow::verify {

/// Counts as complex numbers.
inline std::vector<std::complex<double>> converted(std::span<const std::complex<double>> volts, int bits,
                                                   double lsb_v) {
  std::vector<std::int64_t> pairs(2 * volts.size());
  radar::ConversionTally tally;
  radar::Converter{bits, lsb_v}.convert(volts, pairs, tally);
  std::vector<std::complex<double>> counts(volts.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
    counts[i] = {static_cast<double>(pairs[2 * i]), static_cast<double>(pairs[2 * i + 1])};
  return counts;
}

}  // namespace sarsim::workflow::verify
