#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "core/task/observer.hpp"
#include "raster/format/open_raster.hpp"
#include "signal/measure/sample_statistics.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::workflow {

/// What a file of samples says of itself and, where asked for, what its samples are like.
struct SampleFacts {
  std::shared_ptr<const raster::Raster> file;
  std::size_t rows = 0;
  bool rows_estimated = false;                         ///< A long text has to be read to count them.
  std::optional<signal::SampleStatistics> statistics;  ///< In counts or V, as the file's info says.
};

/// Reads the header of a file of samples, and of a long text its beginning; for statistics the whole file once, in
/// bounded memory.
/// @param observer  hears warnings about the file
/// @throws core::InvalidRequest where it cannot be read, core::Interrupted when stopped
[[nodiscard]] SampleFacts facts_of_samples(const std::string& path, const SampleArguments& sample, bool statistics,
                                           const core::Observer& observer);

}  // namespace sarsim::workflow
