#pragma once

#include <string>

#include "core/report/problem.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::raster {

/// Checks the metadata of an opened file, whatever its format: LSB (up to 1e29 V, of counts at least 1e-37 V), sampling
/// rate (up to 1e18 Hz) and bits (up to 64), axes (magnitudes up to 1e15; of recordings no NaN, of images not all), and
/// the sampling rate against the ranges (to 1 %). All readers of samples pass here (docs/formats/samples.md). Sample
/// values are checked where they are used.
/// @param axes  of the raster, where they were read; null: they are not checked
/// @param path  of the file, for the problems
/// @return errors, and a warning where rate and ranges contradict each other
[[nodiscard]] core::Problems problems_of_facts(const Raster& raster, const RasterAxes* axes, const std::string& path);

}  // namespace sarsim::raster
