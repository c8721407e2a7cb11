#pragma once

#include "core/report/problem.hpp"
#include "raster/cphd/cphd_file.hpp"

namespace sarsim::raster {

/// Checks the parameters of every vector with a signal in a CPHD file, and compares them with the XML
/// (docs/formats/cphd.md).
///
/// Errors, one for each channel: parameters that are not finite or outside the range of any collection, bands and
/// swaths with exchanged ends, an echo that arrives before its pulse leaves, and sample spacings that are not above 0.
/// Warnings, each once with its count: times that do not ascend, positions inside the Earth, receive times that
/// contradict the two-way path, velocities that contradict the positions, bands, swaths and flags that contradict the
/// XML. Takes time linear in the vectors and constant memory.
/// @param[in,out] problems  receives the findings
void check_vectors(const CphdFile& file, core::Problems& problems);

}  // namespace sarsim::raster
