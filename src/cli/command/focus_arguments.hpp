#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/shell/recording_input.hpp"
#include "workflow/focus/focus_request.hpp"

namespace sarsim::cli {

/// What `sarsim focus` was told; the words as they stand there.
struct FocusArguments {
  workflow::RecordingArguments input;
  std::string output;
  std::optional<workflow::FocusAlgorithm> algorithm;
  std::string window;
  std::string range_window;
  std::string azimuth_window;
  std::string centroid = "geometry";
  std::optional<double> bandwidth_hz;
  std::optional<workflow::FocusGrid> grid;
  std::optional<double> ground_m;
  bool start_stop = false;
  std::optional<workflow::MotionOrder> motion;  ///< Nothing: what the track needs.
  bool autofocus = false;
  std::optional<double> autofocus_piece_m;
  std::string autofocus_phase;
  std::optional<std::int64_t> threads;
  std::string memory;
  std::string scratch;
  bool magnitude = false;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

/// Adds them all to a command.
void add_focus_arguments(CLI::App& app, FocusArguments& arguments);

/// What they ask for; core::Refused where one of their words means nothing.
[[nodiscard]] workflow::FocusRequest request_of(const FocusArguments& arguments);

}  // namespace sarsim::cli
