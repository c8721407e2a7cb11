#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "signal/search/cfar.hpp"

namespace sarsim::signal {

/// Of the detections in a map, those that no neighbour of their cell exceeds, the eight around it: one for each
/// response, however many cells it fills. Rows are Doppler frequencies: the first is a neighbour of the last.
/// @param found  in the order of the cells, as `detect_cfar` gives them
/// @param power  the map, rows of `columns`
[[nodiscard]] std::vector<CfarDetection> peaks_of(std::span<const CfarDetection> found, std::span<const float> power,
                                                  std::size_t columns);

/// Frequency, in cycles from one value to the next, at which |sum of values[p] exp(-2 pi j f p)| is largest within
/// `reach` of `near`; to a millionth of `reach`. It must have one maximum there.
[[nodiscard]] double peak_frequency(std::span<const std::complex<double>> values, double near, double reach);

/// Place between the samples of a line, at most 0.6 from `near`, at which its band-limited interpolation is largest in
/// magnitude. Kaiser's sinc of 16 samples, beta 6: right to a hundredth of a sample for what fills up to 0.8 of the
/// sampled band.
[[nodiscard]] double peak_place(std::span<const std::complex<float>> line, std::size_t near);

}  // namespace sarsim::signal
