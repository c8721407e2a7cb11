#pragma once

#include "cli/command/plot_arguments.hpp"
#include "picture/image/image_samples.hpp"

namespace sarsim::cli {

/// Whether a kind is made of samples by `plot_samples`.
[[nodiscard]] bool is_of_samples(PlotKind kind);

/// Pulse, range, profile, range-Doppler map, spectrum or phase history; throws core::InvalidRequest where the samples
/// do not say their times and ranges and the kind needs them, and where it would take too many of them.
[[nodiscard]] Plotted plot_samples(const PlotArguments& arguments, const picture::SampleSource& samples);

/// Where the echoes are: the column with the most power, in up to 64 of some rows; the middle one of several alike.
[[nodiscard]] std::size_t strongest_column(const picture::SampleSource& samples, simulate::IndexSpan rows);

/// The row of an image with its largest sample, for most rows hold nothing but side lobes and noise; of images of more
/// than 2^25 samples the middle one.
[[nodiscard]] std::size_t strongest_row(const picture::SampleSource& samples);

}  // namespace sarsim::cli
