#pragma once

#include <optional>
#include <span>

#include "radar/motion/attitude_table.hpp"
#include "radar/orbit/state_table.hpp"

namespace sarsim::scene {

/// Interpolation error between samples of a motion, estimated from the samples alone.
struct SampleAccuracy {
  double error = 0.0;      ///< Largest distance from the sampled motion: m, or rad for attitudes.
  double at_s = 0.0;       ///< Its time.
  double spacing_s = 0.0;  ///< Between the samples around that time.
  double step = 0.0;       ///< Motion from the sample before that time to the next: m, or rad.
};

/// Estimates the error of `radar::StateTable` between the states within a time: what the polynomials lose of a smooth
/// motion, and what the states are off by themselves (`StateNoises`: noise, rounding, single wrong states, states that
/// are off by turns), as the polynomials pass it on.
///
/// Of a smooth motion, three places of each interval are compared with the polynomials of two more and of two fewer
/// states, p+ and p-. Differences of orders fall by a factor q = |p+ - p| / |p - p-| where interpolation converges, so
/// that the error is near |p+ - p| / (1 - q), q up to 3/4; where they do not fall, it is the larger of both. With too
/// few states for p+ the next difference is taken to be smaller by the same factor as the one before. Differences that
/// noise explains are no loss.
///
/// Within a factor of 2 of the root mean square or the largest of the true errors: of orbits, flights and vibrations at
/// 8 states a period or more, of states with noise of positions, velocities or both, and of wrong states. Of orbits of
/// any eccentricity with a state every 300 s or less, and of 4 states or more, within a factor of 0.5 to 10. Down to 3
/// states a period mostly within a factor of 3. Motion faster than that between positions alone cannot be told from a
/// slower one, and what is the same in all states, as an offset, is not seen. At most 2000 intervals are examined.
/// @param samples  as `radar::StateTable::from` takes them, sound, and its interpolation
/// @return         nothing if no interval between two states overlaps the time span
[[nodiscard]] std::optional<SampleAccuracy> accuracy_between(const radar::StateSamples& samples,
                                                             const radar::StateInterpolation& interpolation,
                                                             const radar::TimeSpan& within);

/// The same of `radar::AttitudeTable`, as an angle: its splines against the polynomials through the eight attitudes
/// next to each place, and the noise of the attitudes.
[[nodiscard]] std::optional<SampleAccuracy> accuracy_between(const radar::AttitudeSamples& samples,
                                                             const radar::TimeSpan& within);

/// The largest rotation from one attitude to the next within a time span: `SampleAccuracy::step`, rad, up to pi.
[[nodiscard]] std::optional<SampleAccuracy> largest_turn(const radar::AttitudeSamples& samples,
                                                         const radar::TimeSpan& within);

}  // namespace sarsim::scene
