#pragma once

#include "core/report/problem.hpp"
#include "raster/cphd/cphd_file.hpp"

namespace sarsim::raster {

/// No sample is larger, in I or Q, as of recordings: sums over all of them stay within single precision.
inline constexpr double most_cphd_sample = 1e28;

/// Judges the parameters of every vector of a CPHD file that has a signal, and compares them with what the XML says of
/// them (docs/formats/cphd.md).
///
/// Errors, one for each channel: parameters that are no finite numbers or lie beyond what any collection has, bands and
/// swaths whose ends are exchanged, an echo that arrives before its pulse leaves, and intervals of samples that are not
/// above 0 or that tell fewer times of arrival apart than the vector has. Warnings, each once with its count: times
/// that do not ascend, places inside the Earth, a reception that contradicts the ways, velocities that contradict the
/// places, bands, swaths and flags that contradict the XML. Takes time linear in the vectors and constant memory.
/// @param[in,out] problems  gets what is found
void check_vectors(const CphdFile& file, core::Problems& problems);

}  // namespace sarsim::raster
