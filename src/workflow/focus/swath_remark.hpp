#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"
#include "signal/sar/swath_loss.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// The target of which a method in the frequency domain loses most.
struct MethodLoss {
  std::optional<std::size_t> target;  ///< Counted from 0; nothing for a point at the farther edge of the swath.
  double middle_m = 0.0;              ///< Closest distance of the middle of the swath.
  signal::SwathLoss loss;
  /// Smallest share of a target's echoes (within 20 dB of the strongest) whose Doppler frequency at the carrier is not
  /// aliased: the rest is missing from its peak as well, which `diagnose_ghosts` reports. 1 if no targets are
  /// examined.
  double told = 1.0;
  std::size_t min_told = 0;  ///< The target of that share, counted from 0.
};

/// Loss of the method of `options` for echoes as seen from the straight line, for the target in the swath that loses
/// most; with more than `max_examined_targets`, at the farther edge of the swath. Residuals of motion compensation are
/// not included. Nothing if there is no such target.
/// @param echoes  their track, waveform and window; no rows are read
/// @throw  Interrupted
[[nodiscard]] std::optional<MethodLoss> worst_method_loss(const simulate::Acquisition& acquisition,
                                                          const signal::EchoRows& echoes,
                                                          const signal::FocusOptions& options,
                                                          const core::WorkControl& control = {});

/// By how many times what is lost exceeds what an image may lose, 0.1 dB and 0.02 rad, the largest, with what is not
/// told; 0 for none.
[[nodiscard]] double excess_of(const std::optional<MethodLoss>& loss);

/// "1.2 dB of target 3, whose Doppler frequencies are aliased at the upper end of the band".
[[nodiscard]] std::string text_of(const MethodLoss& loss);

/// What it says of that loss: a warning from 0.1 dB or 0.02 rad on, a note from a tenth of that on.
/// @param echoes  their track, waveform and window; no rows are read
/// @throw  Interrupted
[[nodiscard]] core::Problems diagnose_swath_loss(const simulate::Acquisition& acquisition,
                                                 const signal::EchoRows& echoes, const signal::FocusOptions& options,
                                                 const core::WorkControl& control = {});

/// A warning where the area in azimuth that is asked for lies beyond all points whose echoes the record can hold: those
/// no farther from a pulse of it than the farthest sample, D: from x_first - D to x_last + D along the line of flight.
/// @param echoes  their track, waveform and window; no rows are read. At least two pulses, and a speed
[[nodiscard]] core::Problems diagnose_area(const signal::EchoRows& echoes, const signal::FocusOptions& options);

}  // namespace sarsim::workflow
