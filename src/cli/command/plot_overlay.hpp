#pragma once

#include <functional>

#include "cli/command/plot_arguments.hpp"

namespace sarsim::cli {

/// Whether --with or --vary ask for several curves in one picture.
[[nodiscard]] bool is_overlaid(const PlotArguments& arguments);

/// The curves of the input, of its variations (--vary) and of other inputs (--with) in one picture.
/// @param plot_one  what a picture of one of them is made by
/// @param stop      null: cannot be stopped
/// @throws core::InvalidRequest for variations that cannot be, and for figures that do not fit together
[[nodiscard]] Plotted plot_overlaid(const PlotArguments& arguments,
                                    const std::function<Plotted(const PlotArguments&)>& plot_one,
                                    const core::StopFlag* stop);

}  // namespace sarsim::cli
