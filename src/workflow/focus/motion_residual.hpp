#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "signal/sar/image_spectrum.hpp"
#include "signal/sar/motion_compensation.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/focus/motion.hpp"

namespace sarsim::workflow {

/// How a method models the flight.
struct TakenFlight {
  enum class Kind {
    even,         ///< As the line that fits the track, flown at constant speed.
    compensated,  ///< Each pulse moved to that line.
    flown,        ///< Pulse by pulse as flown, for points of level ground: back-projection.
  } kind = Kind::even;
  signal::MotionCompensation how;  ///< The line and the scene; the squint is that of compensation.
  bool on_grid = false;            ///< Kind::flown: for points of a ground grid, vertically below or above the targets.
  double carrier_per_m = 0.0;      ///< Centre of the image's azimuth spectrum, cycles per metre.
  double range_carrier_per_m = 0.0;            ///< The same of its range spectrum; of slant range.
  signal::SpectrumExtent kept{-1e300, 1e300};  ///< Of the azimuth spectrum, cycles per metre.
};

/// Errors that the flight causes in the image of a target by a method.
struct MotionResidual {
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  double rms_rad = 0.0;    ///< Of the residual phase, over its echoes weighted by their amplitudes.
  double amplitude = 1.0;  ///< Of its peak, relative to the ideal peak.
  double phase_rad = 0.0;  ///< Phase error of its peak, referred to its position by the image's carrier, in (-pi, pi].
  double azimuth_m = 0.0;  ///< Displacement of its peak.
  double range_m = 0.0;    ///< The same in slant range; 0 where it is not searched for.
  double cell_m = 0.0;     ///< One over the width of its azimuth spectrum.
  double cells = 0.0;      ///< The displacement in resolution cells, along the line of sight or across it.

  /// By how much the peak is lower than the ideal one.
  [[nodiscard]] double lost_db() const;
};

/// Tolerances of these errors: phase, loss, and displacement in resolution cells.
inline constexpr double max_residual_rad = 0.02;
inline constexpr double max_residual_db = 0.1;
inline constexpr double max_residual_cells = 0.05;

/// The largest ratio of an error to its tolerance: above 1 the image is outside the tolerance; 0 for no residual.
[[nodiscard]] double excess_of(const std::optional<MotionResidual>& residual);

/// The worst of up to 512 targets, over up to 512 pulses; nothing if there are no echoes. With the pulse sent at P, Q
/// the position that the method assumes for it, and the target at x, the residual phase is
///
///     even         4 pi/lambda (|P - x| - |Q - x|),                           Q on the line, at even times
///     compensated  4 pi/lambda (|P - x| - |Q - x| - |P - X| + |Q - X|),      Q on the line, nearest to P
///     flown        4 pi/lambda (|P - x| - |P - X|)
///
/// X is the point of level ground that the method assumes: under the squint angle at the target's distance from Q (for
/// the first order, at that of the scene); for back-projection, at the target's azimuth and range. The peak is the
/// maximum along the track of the sum of the echoes with these phases; of the four worst targets in an image of slant
/// range, the maximum in both coordinates of the sum over echoes and frequencies of the pulse: a wide aperture and a
/// narrow band move it in range where that straightens the phases.
/// @param echoes  their track as it was flown, and waveform; no rows are read
/// @throw  Interrupted
[[nodiscard]] std::optional<MotionResidual> worst_motion_residual(const simulate::Acquisition& acquisition,
                                                                  const signal::EchoRows& echoes,
                                                                  const TakenFlight& flight,
                                                                  const core::WorkControl& control = {});

/// For messages: "0.240 rad and 0.10 dB at target 3".
[[nodiscard]] std::string text_of(const std::optional<MotionResidual>& residual);

/// A warning if an image is outside the tolerance, with the errors of the worst target.
[[nodiscard]] core::Problems diagnose_residual(const std::optional<MotionResidual>& residual, TakenFlight::Kind kind);

}  // namespace sarsim::workflow
