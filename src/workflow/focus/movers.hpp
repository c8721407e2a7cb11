#pragma once

#include <optional>

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// Names targets that move or turn with their platform: an image displaces them by R u/V along the track, u the
/// speed at which they recede, and blurs them. A warning if one of them lies outside the rows of an image. Nothing is
/// said of more than `max_examined_targets`.
/// @param echoes  their track, waveform and window; no rows are read
/// @param image   axes and frame; nothing: rows are not checked
/// @throw  Interrupted
[[nodiscard]] core::Problems diagnose_movers(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                             const std::optional<signal::FocusedImage>& image,
                                             const core::WorkControl& control = {});

}  // namespace sarsim::workflow
