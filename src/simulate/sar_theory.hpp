#pragma once

#include <optional>
#include <vector>

#include "process/focusing.hpp"
#include "process/response.hpp"
#include "simulate/plan.hpp"

namespace sarsim {

/// What the image of a target is by theory.
struct TargetTheory {
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  ImagePlace place{};      ///< By its distance and Doppler frequency: a moving target R u/v beside where it is.
  double amplitude = 0.0;  ///< Weighted mean of its echoes (docs/theory/focusing.md), volts.
  double phase_rad = 0.0;  ///< -4 pi f0 R0/c, in (-pi, pi].
  /// Widths and nulls in metres. Range: of the chirp's autocorrelation under the window; nothing for other pulses.
  /// Azimuth: sum over pulses of amplitude and weight times exp(2 pi j f x/V); nothing where no first minimum is in it.
  std::optional<ResponseFigures> range;
  std::optional<ResponseFigures> azimuth;
};

/// Theory of every target for these options of focusing.
/// @param echoes       their waveform and track; no rows are read
/// @param time_domain  back projection, which knows each pulse's true Doppler frequency: no echoes are lost to ghosts
[[nodiscard]] std::vector<TargetTheory> theory_of_targets(const Plan& plan, const EchoRows& echoes,
                                                          const FocusOptions& options, bool time_domain = false);

}  // namespace sarsim
