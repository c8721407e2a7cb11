#pragma once

#include <cstdint>
#include <vector>

#include "core/task/stop.hpp"
#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// A pulse whose echoes a row receives besides those of its own.
struct RangeAmbiguity {
  std::int64_t back = 0;  ///< Sent so many pulses before that of the row; negative: after it.
  double strength = 0.0;  ///< Amplitude of its strongest echo against the strongest of all in a row, antennas aside.

  friend bool operator==(const RangeAmbiguity&, const RangeAmbiguity&) = default;
};

/// The pulses whose echoes rows receive besides those of their own, ascending.
struct RangeAmbiguities {
  std::vector<RangeAmbiguity> pulses;
  /// Of those sent more than `max_pulses_away` before or after a row's own, which are left out: amplitude of the
  /// strongest echo against the strongest of all; 0 where there is none.
  double farther = 0.0;
};
inline constexpr std::int64_t max_pulses_away = 1000;

/// Which other pulses are heard while a row is received, those of whose echoes one may touch a row.
///
/// Looks at at most 65 pulses (17 where there are very many scatterers, 3 at least where there are very many
/// platforms), evenly spread. Ranges are widened by what they may change by between two looks, and by a thousandth for
/// motion during the flight, so that a pulse may be named of which no echo is heard, but none is left out. Strengths
/// are those of cross-section and range at these looks: a beam may meet its target between two of them. Empty where the
/// conventions let a row hear its own pulse alone.
///
/// @param stop  asked now and then; a requested stop throws Interrupted
[[nodiscard]] RangeAmbiguities find_range_ambiguities(const Acquisition& acquisition,
                                                      const core::StopFlag* stop = nullptr);

/// Of them, near and farther, those that the scene's options ask for: all, none, or those above -60 dB.
[[nodiscard]] RangeAmbiguities asked_for(RangeAmbiguities heard, scene::AmbiguousEchoes which);

/// Turns the echoes of a pulse into those of a row whose own pulse left `since_s` later, and leaves out those that
/// cannot touch it. Times then count from the row's pulse.
void clip_to_window(radar::EchoBatch& echoes, double since_s, const radar::EchoPulse& pulse,
                    const radar::SampleGrid& grid);

}  // namespace sarsim::simulate
