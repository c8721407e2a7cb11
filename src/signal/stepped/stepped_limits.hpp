#pragma once

#include "signal/stepped/stepped_band.hpp"

namespace sarsim::signal {

/// What a burst can tell apart, and what a target's speed does to its profile (docs/theory/stepped-frequency.md). T is
/// the time between steps, f the middle of the band, df the step, B the band, v the radial speed.
struct SteppedLimits {
  double step_time_s = 0.0;          ///< T
  double burst_time_s = 0.0;         ///< From the first step to the last: (S - 1) T.
  double resolution_m = 0.0;         ///< c/(2 B)
  double unambiguous_range_m = 0.0;  ///< c/(2 df): how far apart targets fold onto each other, where they can.
  double seen_m = 0.0;               ///< Ranges that one gate sees, c times the length of the sample's pulse/2.
  double shift_m_per_mps = 0.0;      ///< f T/df: towards larger ranges of a receding target.
  double smear_m_per_mps = 0.0;      ///< 2 (S - 1) T: over how many metres a target is spread.
  double tolerable_mps = 0.0;        ///< Smear of half a cell, c/(8 B (S - 1) T): where compensation begins to matter.
  double ambiguous_mps = 0.0;        ///< c/(2 f T): speeds so far apart shift by the same, but smear differently.

  /// Metres by which a target of that speed appears beyond where it is in the middle of the burst.
  [[nodiscard]] double shift_m(double speed_mps) const { return shift_m_per_mps * speed_mps; }
  /// Resolution cells over which it is spread.
  [[nodiscard]] double smear_cells(double speed_mps) const;
};

/// @param pulse_interval_s  mean time between pulses
[[nodiscard]] SteppedLimits limits_of(const SteppedBand& band, double pulse_interval_s);

}  // namespace sarsim::signal
