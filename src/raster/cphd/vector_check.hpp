#pragma once

#include "core/report/problem.hpp"
#include "raster/cphd/cphd_file.hpp"

namespace sarsim::raster {

/// Judges the parameters of every vector of a CPHD file that has a signal, and compares them with what the XML says of
/// them (docs/formats/cphd.md).
///
/// Errors, one for each channel: parameters that are no finite numbers or lie beyond what any collection has, bands and
/// swaths whose ends are exchanged, an echo that arrives before its pulse leaves, intervals of samples that are not
/// above 0, places more than 12 km inside the Earth, ways that are three times as long or short as the echo took, and
/// reference points more than 1e7 m from the image area. Warnings, each once with its count: times that do not ascend,
/// a reception that contradicts the ways by a tenth, velocities that contradict the places, bands, swaths and flags
/// that contradict the XML. Takes time linear in the vectors and constant memory.
/// @param[in,out] problems  gets what is found
void check_vectors(const CphdFile& file, core::Problems& problems);

}  // namespace sarsim::raster
