#pragma once

#include <cstddef>
#include <cstdint>

#include "core/task/observer.hpp"
#include "workflow/search/pulse_report.hpp"
#include "workflow/search/pulse_request.hpp"

namespace sarsim::workflow {

/// Pulses of an interval, where nobody says how many, if there are that many.
inline constexpr std::size_t usual_doppler_pulses = 64;

/// Pulses of an interval of a plan, where nobody says how many.
/// @param canceller  its order: the pulses that it takes are no part of the interval
[[nodiscard]] std::size_t doppler_pulses(const simulate::Acquisition& acquisition, std::int64_t canceller = 0);

/// What is asked of `doppler`.
struct DopplerRequest : PulseRequest {};

/// Maps that were made and what was detected in them.
struct DopplerReport : PulseReport {
  std::size_t rows = 0;     ///< Doppler frequencies of a map.
  std::size_t columns = 0;  ///< Ranges.
  double doppler_first_hz = 0.0;
  double doppler_step_hz = 0.0;
  double speed_first_mps = 0.0;  ///< Receding, of the first frequency.
  double speed_step_mps = 0.0;   ///< Below 0: frequencies approach.
  double range_first_m = 0.0;
  double range_last_m = 0.0;
  double range_step_m = 0.0;
};

/// Range-Doppler maps of pulses, one below the other in an image, and the table of what stands out of them
/// (docs/theory/search-and-doppler.md). Throws core::InvalidRequest with everything that keeps it from being done,
/// before anything is written; Interrupted; failures of files as the sinks tell them.
[[nodiscard]] DopplerReport doppler(const DopplerRequest& request, const core::Observer& observer = {});

}  // namespace sarsim::workflow
