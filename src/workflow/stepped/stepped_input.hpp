#pragma once

#include "workflow/input/recording_input.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::workflow {

/// Bursts, read or computed when they are asked for.
struct SteppedInput {
  SteppedRows rows;
  std::size_t simulation = 0;                  ///< Position in the script's list.
  core::Problems problems;                     ///< Warnings about script and file.
  std::vector<std::filesystem::path> sources;  ///< Files that they are made from.
};

/// Opens what the arguments name; throws core::Refused with all problems where it cannot be used.
[[nodiscard]] SteppedInput open_stepped_input(const RecordingArguments& arguments, SteppedUse use,
                                              const core::WorkControl& control);

}  // namespace sarsim::workflow
