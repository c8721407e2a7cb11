#pragma once

#include <string>

#include "core/report/problem.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::raster {

/// Judges what a file that has been opened says of itself, whatever its format: that LSB, sampling rate and bits are
/// numbers that they can be, that its axes are finite, and that the sampling rate is that of its ranges; axes of more
/// than 2^20 values are left out. All readers of samples pass here (docs/formats/samples.md). The values themselves are
/// judged where they are used.
/// @param path  of the file, for the problems
/// @return errors, and a warning where rate and ranges contradict each other
[[nodiscard]] core::Problems problems_of_facts(const Raster& raster, const std::string& path);

}  // namespace sarsim::raster
