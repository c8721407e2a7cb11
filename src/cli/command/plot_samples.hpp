#pragma once

#include "cli/command/plot_arguments.hpp"
#include "picture/image/image_samples.hpp"

namespace sarsim::cli {

/// Whether a kind is made of samples by `plot_samples`.
[[nodiscard]] bool is_of_samples(PlotKind kind);

/// Pulse, range, profile, range-Doppler map, spectrum or phase history; throws core::Refused where the samples do not
/// say their times and ranges and the kind needs them, and where it would take too many of them.
[[nodiscard]] Plotted plot_samples(const PlotArguments& arguments, const picture::SampleSource& samples);

}  // namespace sarsim::cli
