#pragma once

#include <complex>
#include <cstddef>
#include <string>

#include "core/report/problem.hpp"

namespace sarsim::raster {

/// Largest part of a sample that can be computed with in single precision, V: sums over all samples of a recording stay
/// below 3.4e38.
inline constexpr double largest_usable_v = 1e28;

/// Whether a sample can be computed with: both parts are finite and at most `largest_usable_v`.
[[nodiscard]] bool is_usable_sample(const std::complex<double>& value);

/// Why a sample that is not usable is refused: a single one would spoil everything that is computed from it.
/// @param source  file, or name of a recording in memory
/// @param row     of the file, from 0, as the column
[[nodiscard]] core::Problem unusable_sample(const std::string& source, std::size_t row, std::size_t column,
                                            const std::complex<double>& value);

}  // namespace sarsim::raster
