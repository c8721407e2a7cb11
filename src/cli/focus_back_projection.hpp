#pragma once

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "cli/focus_input.hpp"
#include "process/focusing.hpp"

namespace sarsim::cli {

/// Focuses by back projection to the slant-range image that the methods in the frequency domain make: the same axes,
/// phases and amplitudes, with closer rows where the pulses do not sample the targets' Doppler frequencies. A Doppler
/// bandwidth keeps the pulses that see a point at such frequencies; the azimuth window is over them, or, where all are
/// kept, over the record. Throws BadInput where the echoes need more memory than allowed.
[[nodiscard]] FocusedRows back_projected(const FocusInput& input, const FocusOptions& options,
                                         const WorkControl& control, const ProgressReport& progress);

}  // namespace sarsim::cli
