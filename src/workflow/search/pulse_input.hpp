#pragma once

#include "workflow/input/recording_input.hpp"
#include "workflow/search/pulse_rows.hpp"

namespace sarsim::workflow {

/// Pulses and what there is to say about their source.
struct PulseInput {
  PulseRows rows;
  std::size_t simulation = 0;  ///< Position in the script's list.
  core::Problems problems;
  std::vector<std::filesystem::path> sources;  ///< Files that they are made from.
};

/// What simulation number `number` of a sound scene, RAW or MATCHED_FILTER, records; it becomes a compressed one.
[[nodiscard]] std::shared_ptr<const simulate::Acquisition> acquisition_of_pulses(
    scene::Scene& scene, std::size_t number, const std::shared_ptr<const simulate::ResolvedScene>& resolved,
    const core::StopFlag* stop = nullptr);

/// Opens what the arguments name; throws core::InvalidRequest with all problems where it has no pulses.
[[nodiscard]] PulseInput open_pulse_input(const RecordingArguments& arguments, const core::WorkControl& control);

}  // namespace sarsim::workflow
