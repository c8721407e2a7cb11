#pragma once

#include "cli/shell/recording_input.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::cli {

/// Bursts, read or computed when they are asked for.
struct SteppedInput {
  workflow::SteppedRows rows;
  std::size_t simulation = 0;                  ///< Position in the script's list.
  core::Problems problems;                     ///< Warnings about script and file.
  std::vector<std::filesystem::path> sources;  ///< Files that they are made from.
};

/// Adds the options of `add_recording_arguments` and those that stand in for the script's.
void add_stepped_input_arguments(CLI::App& app, RecordingArguments& arguments);

/// Opens what the arguments name; throws core::Refused with all problems where it cannot be used.
[[nodiscard]] SteppedInput open_stepped_input(const RecordingArguments& arguments, workflow::SteppedUse use,
                                              const core::WorkControl& control);

}  // namespace sarsim::cli
