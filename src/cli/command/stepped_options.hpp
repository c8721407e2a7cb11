#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/shell/context.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/recording_input.hpp"
#include "workflow/stepped/profile_series.hpp"

namespace sarsim::cli {

/// Adds the options of `add_recording_arguments` and those that stand in for the script's.
void add_stepped_input_arguments(CLI::App& app, RecordingArguments& arguments);

/// What --velocity says.
struct VelocityChoice {
  workflow::SeriesOptions::Velocity velocity = workflow::SeriesOptions::Velocity::none;
  double speed_mps = 0.0;
};

/// none, scene, estimated or a number of m/s; throws core::Refused for anything else.
[[nodiscard]] VelocityChoice velocity_choice(const std::string& text);

/// Throws core::Refused where a search for the speed of such bursts would try too many.
void expect_searchable(double fastest_mps, const workflow::SteppedRows& rows);

/// How progress is shown.
[[nodiscard]] ProgressDisplay::Style display_style(const Streams& streams, bool quiet);

}  // namespace sarsim::cli
