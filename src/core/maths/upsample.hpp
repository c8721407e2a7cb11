#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace sarsim::core {

/// Samples between samples: `factor` times as many, the given ones among them, by filling up the spectrum with zeros.
/// Exact for samples that repeat themselves behind their end and whose band is one sampling rate wide about its centre.
/// @param centre_cycles  middle of the band, in cycles from one sample to the next
/// @param factor         at least 1
/// @return factor samples for each of `samples`; those behind the last one lead back to the first
[[nodiscard]] std::vector<std::complex<double>> upsample(std::span<const std::complex<double>> samples,
                                                         double centre_cycles, std::size_t factor);

}  // namespace sarsim::core
