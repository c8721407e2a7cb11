#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/shell/recording_input.hpp"
#include "signal/sar/sar_window.hpp"
#include "workflow/focus/motion.hpp"

namespace sarsim::cli {

/// How `sarsim focus` makes its image.
enum class FocusAlgorithm { range_doppler, chirp_scaling, omega_k, back_projection };

/// As the command line and image headers call it.
[[nodiscard]] const char* word_of(FocusAlgorithm algorithm);

/// What the columns of its image are.
enum class FocusGrid { slant, ground };

/// What `sarsim focus` was told; the words as they stand there.
struct FocusArguments {
  RecordingArguments input;
  std::string output;
  std::optional<FocusAlgorithm> algorithm;
  std::string window;
  std::string range_window;
  std::string azimuth_window;
  std::string centroid = "geometry";
  std::optional<double> bandwidth_hz;
  std::optional<FocusGrid> grid;
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

/// Bytes of --memory: a number with K, M, G or T (of 1024) behind it; half of what is free where it is empty.
/// core::Refused where it is no size.
[[nodiscard]] std::size_t memory_of(const std::string& text);

}  // namespace sarsim::cli
