#pragma once

#include "core/report/problem.hpp"
#include "raster/cphd/cphd_file.hpp"

namespace sarsim::raster {

/// No sample is larger, in I or Q, as of recordings: sums over all of them stay within single precision.
inline constexpr double most_cphd_sample = 1e28;

/// Checks the parameters of every vector with a signal in a CPHD file, and compares them with the XML
/// (docs/formats/cphd.md).
///
/// Errors, one for each channel: parameters that are not finite or outside the range of any collection, bands and
/// swaths with exchanged ends, an echo that arrives before its pulse leaves, and sample spacings that are not above 0.
/// above 0 or that tell fewer times of arrival apart than the vector has. Warnings, each once with its count: times
/// that do not ascend, places inside the Earth, a reception that contradicts the ways, velocities that contradict the
/// places, bands, swaths and flags that contradict the XML. Takes time linear in the vectors and constant memory.
/// @param[in,out] problems  receives the findings
void check_vectors(const CphdFile& file, core::Problems& problems);

}  // namespace sarsim::raster
