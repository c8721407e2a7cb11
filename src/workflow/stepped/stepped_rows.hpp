#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "core/task/sample_rows.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/stepped/isar.hpp"
#include "signal/stepped/profile_maker.hpp"
#include "signal/stepped/stepped_band.hpp"
#include "signal/stepped/velocity_search.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/focus/sar_rows.hpp"

/// From simulations of stepped carriers and their recordings to what range profiles and images of turning targets are
/// made from (docs/theory/stepped-frequency.md).
namespace sarsim::workflow {

/// Whole bursts of a recording, read or computed when they are asked for: a row for each pulse, counted from
/// first_pulse, as SteppedBand::place takes it.
struct SteppedRows : core::SampleRows<double> {
  std::shared_ptr<const simulate::Acquisition> acquisition;
  std::shared_ptr<const signal::SteppedBand> band;
  std::int64_t first_pulse = 0;     ///< Of the first whole burst: its number in the schedule.
  std::size_t bursts = 0;           ///< Whole ones.
  std::int64_t dropped_pulses = 0;  ///< Of incomplete bursts at either end.
  double from_m = 0.0;              ///< Ranges that the script's window asks for.
  double to_m = 0.0;

  [[nodiscard]] double pulse_time_s(std::size_t pulse) const {
    return acquisition->link.repetition.send_time_s(first_pulse + static_cast<std::int64_t>(pulse));
  }
};

/// What is to be made of the bursts.
enum class SteppedUse {
  profiles,  ///< Needs two frequency steps or more.
  isar,      ///< Takes a single carrier, too, where the pulse is modulated.
};

/// What keeps a simulation from being used, all at once (errors): a carrier that does not step evenly, no whole burst,
/// profiles instead of echoes, samples that the classic profile places unevenly.
/// @param recorded  a file holds the echoes, which therefore must not be profiles already
[[nodiscard]] core::Problems problems_of_stepped(const simulate::Acquisition& acquisition, SteppedUse use,
                                                 bool recorded);

/// What makes profiles ambiguous, lost or blurred (warnings): steps wider than the pulse's band, gates that leave out
/// echoes, targets that fold onto each other, and of profiles targets whose speed shifts and smears them.
/// @param speed_mps  that is compensated; nothing: none
[[nodiscard]] core::Problems diagnose_stepped(const SteppedRows& rows, SteppedUse use, std::optional<double> speed_mps);

/// The simulation as it is wanted recorded: raw, longer by a pulse at its end and, for CENTRE, by half a pulse, in
/// whole samples, at its start. The sampling frequency stays the script's.
[[nodiscard]] scene::Simulation recorded_for_stepped(const scene::Simulation& simulation,
                                                     const simulate::Acquisition& acquisition);

/// Rows of a scene, of a simulation made by `recorded_for_stepped`.
/// @param window  the acquisition of the script's own window
[[nodiscard]] SteppedRows stepped_rows_of_scene(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                                const simulate::Acquisition& window);

/// Rows of a recording, raw or compressed.
[[nodiscard]] SteppedRows stepped_rows_of_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                                    core::SampleRows<double> recorded);

/// Reads bursts [first, first + count), their pulses placed in the band.
[[nodiscard]] signal::BurstEchoes read_bursts(const SteppedRows& rows, std::size_t first, std::size_t count,
                                              const core::WorkControl& control,
                                              const core::ProgressReport& progress = {});

/// Of many targets so many are held against profiles and images.
inline constexpr std::size_t max_held_targets = 1000;

/// Where a target is in the middle of a burst, and how strong.
struct BurstTruth {
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  double range_m = 0.0;    ///< c/2 times its delay.
  double speed_mps = 0.0;
  double amplitude = 0.0;  ///< Mean over the pulses of the burst, volts, with the receiver's gain over time (STC).
};

/// The targets of the scene at a burst.
[[nodiscard]] std::vector<BurstTruth> truth_of_burst(const SteppedRows& rows, std::size_t burst);

/// Two-way power of the strongest target's echo in the middle of each burst.
[[nodiscard]] std::vector<double> illumination_of(const SteppedRows& rows, const core::WorkControl& control);

/// The fastest speed that a search for the sharpest profiles can look through, to either side of 0
/// (signal/stepped/velocity_search.hpp).
[[nodiscard]] double fastest_searched_mps(const SteppedRows& rows);

/// Mean radial speed of targets and surfaces, weighted by the power of their echoes, over some bursts.
[[nodiscard]] double mean_speed_mps(const SteppedRows& rows, std::size_t first, std::size_t count);

/// The platform that carries the strongest targets (by cross-section), the radar's own left out; nothing where there
/// are no others.
[[nodiscard]] std::optional<std::size_t> platform_of_targets(const simulate::Acquisition& acquisition);

/// The antenna in the frame of a platform, pulse by pulse of some bursts.
[[nodiscard]] std::vector<signal::TrackPoint> seen_from_platform(const SteppedRows& rows, std::size_t platform,
                                                                 std::size_t first, std::size_t count);

}  // namespace sarsim::workflow
