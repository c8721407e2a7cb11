#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "signal/sar/image_spectrum.hpp"
#include "signal/sar/motion_compensation.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/focus/motion.hpp"

namespace sarsim::workflow {

/// How a method takes the flight.
struct TakenFlight {
  enum class Kind {
    even,         ///< As the line that fits the track, flown at constant speed.
    compensated,  ///< Each pulse moved to that line.
    flown,        ///< Pulse by pulse as it was, for points of level ground: back-projection.
  } kind = Kind::even;
  signal::MotionCompensation how;  ///< The line and the scene; the squint is that of compensation.
  bool on_grid = false;            ///< flown: for points of a ground grid, straight below or above the targets.
  double carrier_per_m = 0.0;      ///< Centre of the image's azimuth spectrum, cycles.
  signal::SpectrumExtent kept{-1e300, 1e300};  ///< Of the azimuth spectrum, cycles per metre.
};

/// What a method leaves in the image of a target, because of the flight.
struct MotionResidual {
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  double rms_rad = 0.0;    ///< Of the phase that is left, over its echoes by their amplitudes.
  double amplitude = 1.0;  ///< Of its peak, relative to the ideal one.
  double phase_rad = 0.0;  ///< Error of its peak's phase, carried to its place by the image's carrier, in (-pi, pi].
  double azimuth_m = 0.0;  ///< Displacement of its peak.
  double cell_m = 0.0;     ///< One over the width of its azimuth spectrum.

  /// By how much the peak is lower than the ideal one.
  [[nodiscard]] double lost_db() const;
};

/// What an image may have of it and still be called right.
inline constexpr double most_residual_rad = 0.02;
inline constexpr double most_residual_db = 0.1;
inline constexpr double most_residual_cells = 0.05;

/// By how many times a residual exceeds what an image may have; 0 for none.
[[nodiscard]] double excess_of(const std::optional<MotionResidual>& residual);

/// The target that is worst, of up to 512, over some pulses; nothing where there are no echoes. With the pulse sent at
/// P, Q the place of it that the method assumes, and the target at x,
///
///     even         4 pi/lambda (|P - x| - |Q - x|),                           Q on the line, at even times
///     compensated  4 pi/lambda (|P - x| - |Q - x| - |P - X| + |Q - X|),      Q on the line, nearest to P
///     flown        4 pi/lambda (|P - x| - |P - X|)
///
/// remains. X is the point of level ground that the method has in mind: under the squint angle at the target's distance
/// from Q (to the first order, at that of the scene); for back-projection, at the target's azimuth and range. The peak
/// is where the sum of the echoes with these phases is largest.
/// @param echoes  their track as it was flown, and waveform; no rows are read
/// @throw  Interrupted
[[nodiscard]] std::optional<MotionResidual> worst_motion_residual(const simulate::Plan& plan,
                                                                  const signal::EchoRows& echoes,
                                                                  const TakenFlight& flight,
                                                                  const core::WorkControl& control = {});

/// "0.240 rad and 0.10 dB at target 3".
[[nodiscard]] std::string text_of(const std::optional<MotionResidual>& residual);

/// A warning where an image is not right any more, with what the flight does to the target.
[[nodiscard]] core::Problems remarks_on_residual(const std::optional<MotionResidual>& residual, TakenFlight::Kind kind);

}  // namespace sarsim::workflow
