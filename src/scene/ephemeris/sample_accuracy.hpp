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

/// Estimates the error of `radar::StateTable` between the states within a time span (docs/theory/earth-and-orbits.md).
/// At three points of each interval its polynomial p is compared with p2 and p4 through two and four more states. If
/// the differences decrease, by q = |p4 - p2|/|p2 - p|, the error is |p4 - p| + |p4 - p2| q/(1 - q), q up to 3/4;
/// otherwise the larger of |p2 - p| and the smaller of |p4 - p| and the difference of p to the polynomials of one and
/// two fewer states. Without more states the last difference, times the factor by which it decreased, is taken. Within
/// a factor of 3 of the largest true error in 95 % of orbits, flights and vibrations at 3.5 states a period or more;
/// faster motion between positions alone is an alias of a slower one. Noise of the states counts as error. About 2000
/// intervals are examined at most.
/// @param samples  as `radar::StateTable::from` takes them, sound, and its interpolation
/// @return         nothing if no interval between two states overlaps the time span
[[nodiscard]] std::optional<SampleAccuracy> accuracy_between(const radar::StateSamples& samples,
                                                             const radar::StateInterpolation& interpolation,
                                                             const radar::TimeSpan& within);

/// The same for `radar::AttitudeTable`: its splines against the polynomials through the eight attitudes nearest to each
/// point, as an angle, rad. Nothing also if no table can be made of the samples.
[[nodiscard]] std::optional<SampleAccuracy> accuracy_between(const radar::AttitudeSamples& samples,
                                                             const radar::TimeSpan& within);

/// The largest rotation from one attitude to the next within a time span: `SampleAccuracy::step`, rad, up to pi.
[[nodiscard]] std::optional<SampleAccuracy> largest_turn(const radar::AttitudeSamples& samples,
                                                         const radar::TimeSpan& within);

}  // namespace sarsim::scene
