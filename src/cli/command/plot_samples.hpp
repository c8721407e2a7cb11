#pragma once

#include <functional>
#include <vector>

#include "cli/command/plot_arguments.hpp"
#include "picture/echo/radar_views.hpp"
#include "picture/image/cut_figure.hpp"

namespace sarsim::cli {

/// Samples that cuts and radar views can be made of, wherever they come from.
struct PlotSamples {
  std::vector<double> row_place;     ///< Time of each row; azimuth or number, where `look.rows` says so.
  std::vector<double> column_place;  ///< Range of each column, or its number.
  picture::CutLook look;             ///< Names of the places and unit of the samples.
  bool timed = true;                 ///< Rows have times, columns ranges, and the carriers are known.
  std::function<picture::EchoBlock(simulate::IndexSpan rows, simulate::IndexSpan columns)> read;
};

/// Whether a kind is made of samples by `plot_samples`.
[[nodiscard]] bool is_of_samples(PlotKind kind);

/// Pulse, range, profile, range-Doppler map, spectrum or phase history; throws core::Refused where the samples do not
/// say their times and ranges and the kind needs them, and where it would take too many of them.
[[nodiscard]] Plotted plot_samples(const PlotArguments& arguments, const PlotSamples& samples);

}  // namespace sarsim::cli
