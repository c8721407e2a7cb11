#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "radar/motion/path_state.hpp"

namespace sarsim::scene {

/// How the reader of a file of motion finds places between the samples.
enum class Reconstruction : std::uint8_t {
  hermite_degree_7,   ///< `radar::hermite_degree_7`: OEM, CSV with velocities.
  hermite_cubic,      ///< `radar::hermite_cubic`.
  lagrange_8_points,  ///< `radar::lagrange_8_points`: positions alone.
  spline_not_a_knot,  ///< CUBIC of a script, with core::CubicEnds::not_a_knot.
  spline_chords,      ///< CUBIC of a script, with core::CubicEnds::chords.
  straight_lines,     ///< LINEAR of a script.
};

/// Fewest samples that it takes.
[[nodiscard]] std::size_t fewest_samples(Reconstruction reconstruction);

/// A motion that can be asked at any time: position and velocity of `radar::PathState` are looked at, in one frame.
using MotionPath = std::function<radar::PathState(double time_s)>;

/// The largest errors found.
struct InterpolationError {
  double position_m = 0.0;
  double velocity_mps = 0.0;
  double position_at_s = 0.0;  ///< Where they were found.
  double velocity_at_s = 0.0;
};

/// What a reader gets wrong who has the samples of a motion at certain times only. Looked for at 4 places in an
/// interval: the middle, and one in each third, which differs from interval to interval so that no vibration is always
/// met at its zeros. The rounding of coordinates is part of the error: 1e-9 m at 7e6 m from the origin.
///
/// Refuses times that do not ascend, too few of them, and a motion that is not finite.
/// @param time_s  of the samples, ascending
/// @param every   look into one of so many intervals, and in any case into the first and last 8, which are the worst
[[nodiscard]] std::variant<InterpolationError, core::Problem> interpolation_error(const MotionPath& path,
                                                                                  std::span<const double> time_s,
                                                                                  Reconstruction reconstruction,
                                                                                  std::size_t every = 1);

/// Times from the first to the last, both included, with a spacing; the last two intervals share what remains, and so
/// are between half and three quarters of the spacing where it does not go up. Two times at least. Expects
/// first_s < last_s and a spacing above 0.
[[nodiscard]] std::vector<double> sample_times(double first_s, double last_s, double spacing_s);

/// What is asked for.
struct SpacingRequest {
  double error_m = 0.0;  ///< The largest error of position must be below this.
  double first_s = 0.0;
  double last_s = 0.0;
  Reconstruction reconstruction = Reconstruction::hermite_degree_7;
  std::size_t max_samples = 1'000'000;
};

/// A spacing and what it does.
struct SpacingChoice {
  double spacing_s = 0.0;
  InterpolationError error;  ///< Of `sample_times` with that spacing.
};

/// The widest spacing among ..., 0.5, 1, 2, 5, 10, 20, ... s whose largest error is below a limit. Each is tried, from
/// the widest that has enough samples, with 4 places in an interval, but 4000 in all at least: what lasts less than
/// 1/4000 of the time may be missed. Calls the path about twice for each of these, in the worst case 12 times
/// `max_samples`. Refuses a limit that no spacing reaches within that many samples or within the rounding of
/// coordinates, and what `interpolation_error` refuses.
[[nodiscard]] std::variant<SpacingChoice, core::Problem> spacing_for(const MotionPath& path,
                                                                     const SpacingRequest& wish);

}  // namespace sarsim::scene
