#pragma once

#include <memory>
#include <string>

#include "core/task/observer.hpp"
#include "raster/format/open_raster.hpp"
#include "signal/measure/sample_statistics.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::workflow {

/// What a file of samples says of itself and what its samples are like.
struct SampleFacts {
  std::shared_ptr<const raster::Raster> file;
  signal::SampleStatistics statistics;  ///< In counts or V, as the file's info says.
};

/// Reads a whole file of samples once, in bounded memory.
/// @param observer  hears warnings about the file
/// @throws core::Refused where it cannot be read, core::Interrupted when stopped
[[nodiscard]] SampleFacts facts_of_samples(const std::string& path, const SampleArguments& sample,
                                           const core::Observer& observer);

}  // namespace sarsim::workflow
