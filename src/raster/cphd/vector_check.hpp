#pragma once

#include "core/report/problem.hpp"
#include "raster/cphd/cphd_file.hpp"

namespace sarsim::raster {

/// No sample is larger, in I or Q, as of recordings: sums over all of them stay within single precision.
inline constexpr double max_cphd_sample = 1e28;

/// Checks the parameters of every vector with a signal in a CPHD file, and compares them with the XML
/// (docs/formats/cphd.md).
///
/// Errors, one for each channel: parameters that are not finite or outside the range of any collection, bands and
/// swaths with exchanged ends, an echo that arrives before its pulse leaves, sample spacings that are not above 0 or
/// that resolve fewer times of arrival than the vector has, positions more than 12 km inside the Earth, two-way paths
/// that are three times as long or short as the echo took, and reference points more than 1e7 m from the image area.
/// Warnings, each once with its count: times that do not ascend, receive times that contradict the two-way path by a
/// tenth, velocities that contradict the positions, bands, swaths and flags that contradict the XML. Takes time linear
/// in the vectors and constant memory.
/// @param[in,out] problems  receives the findings
/// @param stop  asked now and then; a requested stop throws Interrupted
void check_vectors(const CphdFile& file, core::Problems& problems, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::raster
