#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/stepped/profile_maker.hpp"
#include "signal/stepped/profile_sets.hpp"
#include "signal/stepped/stepped_limits.hpp"
#include "signal/stepped/velocity_search.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::workflow {

/// How the profiles of a recording are made.
struct SeriesOptions {
  enum class Velocity {
    none,       ///< Targets are taken to rest during a burst.
    given,      ///< The same speed for all.
    scene,      ///< Of each scan the mean speed of the scene's targets, weighted by the power of their echoes.
    estimated,  ///< Of each scan the speed that makes its profiles sharpest.
  };
  signal::WindowFunction window;  ///< Over the band; empty: none.
  std::optional<double> from_m;   ///< Ranges; nothing: `shown_ranges`.
  std::optional<double> to_m;
  std::size_t oversampling = 4;     ///< Bins for each resolution cell.
  double illuminated_share = 0.25;  ///< Of the strongest burst's power: what counts as illuminated.
  Velocity velocity = Velocity::none;
  double speed_mps = 0.0;      ///< Velocity::given.
  double fastest_mps = 500.0;  ///< Velocity::estimated: searched from minus this to this.
  bool align = false;          ///< Show targets where they are in the middle of their scan, not of each burst.
};

/// A scan and what was taken out of it.
struct ScanRecord {
  signal::ProfileSet bursts;  ///< Of the recording.
  double from_s = 0.0;
  double to_s = 0.0;
  double speed_mps = 0.0;  ///< That was compensated.
  std::optional<signal::VelocityEstimate> estimate;
};

/// One profile and what it is of.
struct ProfileRow {
  std::size_t burst = 0;  ///< Of the recording.
  std::size_t scan = 0;
  double time_s = 0.0;  ///< Middle of the burst.
};

/// The profiles of an encounter, burst after burst, scan after scan.
struct ProfileSeries {
  signal::ProfileAxis axis;
  signal::SteppedLimits limits;
  double centre_hz = 0.0;
  double band_hz = 0.0;
  std::vector<ScanRecord> scans;
  std::vector<ProfileRow> rows;
  std::vector<std::complex<double>> values;  ///< rows.size() rows of axis.count bins, volts.

  [[nodiscard]] std::span<const std::complex<double>> row(std::size_t i) const {
    return std::span(values).subspan(i * axis.count, axis.count);
  }
};

/// A stretch of slant ranges, c/2 times the delay.
struct RangeResampling {
  double from_m = 0.0;
  double to_m = 0.0;
};

/// The ranges of the script's window that the recorded samples show. A recording ends with its last sample: of an echo
/// that begins after it nothing is known, so that a window of CENTRE ends half a pulse behind that sample, one of BEGIN
/// at it, and one of raw modulated pulses where half of the echo is left. Rows of a scene are long enough for all of
/// the window. Where nothing of it is shown, `to_m` is not above `from_m`.
[[nodiscard]] RangeResampling shown_ranges(const SteppedRows& rows);

/// Makes the profiles of all illuminated bursts. The same bytes for any number of threads. Throws Interrupted, and
/// std::invalid_argument where the ranges are none.
[[nodiscard]] ProfileSeries make_profiles(const SteppedRows& rows, const SeriesOptions& options,
                                          const core::WorkControl& control, const core::ProgressReport& progress = {});

/// A series of which each scan has become one profile: the root mean square over its bursts.
[[nodiscard]] ProfileSeries mean_of_scans(const ProfileSeries& series);

/// A series of which the whole encounter has become one profile: that of all bursts, where the means of the scans are
/// first laid upon the strongest of them, by the largest correlation of their powers.
[[nodiscard]] ProfileSeries mean_of_encounter(const ProfileSeries& series);

/// A target of the scene in a profile.
struct HeldTarget {
  BurstTruth truth;
  double expected_m = 0.0;  ///< Its range, where its profile shows it, and what speed that is left shifts it by.
  double expected_bin = 0.0;
  bool outside = false;                      ///< That bin is not in the profile: it is not looked for.
  double smear_cells = 0.0;                  ///< By the speed that is left.
  double nearest_m = 0.0;                    ///< Distance of `expected_m` to that of the next target; infinite alone.
  std::optional<signal::ProfilePeak> found;  ///< The largest peak within half the distance to the next target.
};

/// The targets of the scene, as the profile of one burst shows them; those without echoes left out. Of many the first
/// `max_held_targets` are looked at.
/// @param row  of a series that `make_profiles` made
[[nodiscard]] std::vector<HeldTarget> hold_against_scene(const SteppedRows& rows, const ProfileSeries& series,
                                                         const SeriesOptions& options, std::size_t row);

/// From where the radar looks at the platform of the targets, one angle for each profile: that of the radar in the x-y
/// plane of the platform, from its x axis (0: from ahead) towards y, in rad, continued over whole turns. Empty where
/// the radar's own platform carries the targets.
[[nodiscard]] std::vector<double> aspects_rad(const SteppedRows& rows, const ProfileSeries& series);

/// The row to hold against the scene where nothing else is said: in the middle of the scan with the strongest echoes.
[[nodiscard]] std::size_t typical_row(const ProfileSeries& series);

}  // namespace sarsim::workflow
