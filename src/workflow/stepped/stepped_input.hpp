#pragma once

#include "workflow/input/recording_input.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::workflow {

/// Bursts, read or computed when they are asked for.
struct SteppedInput {
  SteppedRows rows;
  std::size_t simulation = 0;                         ///< Position in the script's list.
  core::Problems problems;                            ///< Warnings about script and file.
  std::vector<std::filesystem::path> sources;         ///< Files that they are made from.
  std::shared_ptr<const raster::Raster> recording{};  ///< That they are read from; null: they are computed.
};

/// Whether the radar of a simulation steps its carrier, or, for images, at least modulates its pulse.
[[nodiscard]] Suits suits_use(SteppedUse use);

/// Simulation number `number` of a sound scene, which becomes what is wanted recorded (`recorded_for_stepped`): bursts
/// are cut here, and profiles made of sub-bands too. Where `problems` holds an error, there are no rows.
[[nodiscard]] SteppedInput stepped_input_of(scene::Scene& scene, std::size_t number,
                                            const std::shared_ptr<const simulate::ResolvedScene>& resolved,
                                            SteppedUse use);
/// The same of a simulation that is planned already.
/// @param planned  what it records
[[nodiscard]] SteppedInput stepped_input_of(scene::Scene& scene, std::size_t number,
                                            const simulate::Acquisition& planned, SteppedUse use);

/// Opens what the arguments name; throws core::InvalidRequest with all problems where it cannot be used.
[[nodiscard]] SteppedInput open_stepped_input(const RecordingArguments& arguments, SteppedUse use,
                                              const core::WorkControl& control);

}  // namespace sarsim::workflow
